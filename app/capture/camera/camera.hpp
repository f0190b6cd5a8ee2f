// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"
#include "core/base/result.hpp"
#include "core/handheld/held_pose.hpp"

#include <memory>
#include <string>

namespace tp {

enum class CameraSide { back, front };

/// What a page takes photographs with. All calls on the page's thread; the source that `open` gives is asked on another.
class Camera {
public:
    virtual ~Camera() = default;

    /// Switches it on. `side` is a wish: where there is no such camera it is another one. An error, in one sentence, where there
    /// is none. A source from before is to be interrupted first.
    virtual Result<std::unique_ptr<FrameSource>> open(CameraSide side) = 0;
    /// Switches it off.
    virtual void close() = 0;

    /// What the one that is open is called; empty where nobody knows.
    virtual std::string name() const { return {}; }
    /// There is one at the front and one at the back.
    virtual bool has_both() const { return false; }
    /// Of the one that is open.
    virtual bool has_torch() const { return false; }
    virtual void light(bool /*on*/) {}

    /// A person at a desk plays the hand: turns and steps on from where it is held. False where a real hand holds the camera.
    virtual bool move_by(const HeldPose& /*way*/) { return false; }
    virtual bool moved_by_keys() const { return false; }
};

} // namespace tp
