// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include <cstdint>
#include <span>

namespace tp {

/// A microphone. Lives on one thread; all calls and signals are there.
class SoundInput : public QObject {
    Q_OBJECT
public:
    enum class Trouble {
        none_there, ///< no microphone, or it went away
        stalled,    ///< it is there and delivers nothing
        unfit,      ///< it cannot record 48 000 samples a second
    };
    Q_ENUM(Trouble)
    using QObject::QObject;

    /// The system's microphone begins to deliver; blocks or `lost` follow.
    virtual void start() = 0;
    /// Nothing more is delivered.
    virtual void stop() = 0;

signals:
    /// One channel, 48 000 a second. The samples are the listener's only during the call.
    void block(std::span<const std::int16_t> samples);
    /// What was started has ended by itself.
    void lost(tp::SoundInput::Trouble trouble);
    /// There is a microphone that was not there before; `start` may be tried.
    void came();
};

} // namespace tp
