// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/controls/announcer.hpp"

#include <QStringList>

namespace tp {

/// Remembers what a screen reader would have been told; for tests.
class RecordingAnnouncer final : public Announcer {
    Q_OBJECT
public:
    using Announcer::Announcer;
    void announce(const QString& sentence) override { announced_ << sentence; }
    const QStringList& announced() const { return announced_; }

private:
    QStringList announced_;
};

} // namespace tp
