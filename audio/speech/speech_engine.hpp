// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace tp {

/// What speaks one text at a time. `id` names the utterance, so that a late word about a cancelled one is not
/// taken for the end of the next.
class SpeechEngine {
public:
    virtual ~SpeechEngine() = default;
    /// Replaces what is being spoken. Its end comes back through SpeechQueue::finished(id).
    virtual void speak(quint64 id, const QString& text) = 0;
    virtual void cancel() = 0;
};

} // namespace tp
