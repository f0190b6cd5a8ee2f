// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/camera/camera_trouble.hpp"

#include <QVideoFrame>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace tp {

/// The newest frame of a camera, from the thread that it comes on to the one that looks at it. Frames that nobody took in
/// time are dropped.
class NewestFrame {
public:
    struct Taken {
        QVideoFrame frame;
        double time_s = 0.0;
    };
    enum class Came { frame, nothing, trouble, end };

    void put(const QVideoFrame& frame, double time_s);
    /// No frame comes any more. The first of the two that is called holds.
    void fail(CameraTrouble trouble);
    void end();

    /// Waits for a frame that was not taken yet, `patience` at most.
    Came take(Taken& taken, std::chrono::milliseconds patience);
    CameraTrouble trouble() const;

private:
    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::optional<Taken> newest_;
    std::optional<CameraTrouble> trouble_;
    bool ended_ = false;
};

} // namespace tp
