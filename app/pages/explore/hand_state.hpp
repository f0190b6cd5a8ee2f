// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// What moves the drawn finger, and whether that is on the surface. A mouse moves beside a finger that is
/// down, as some systems make one of it.
///
/// |           | mouse     | keys     | one finger | several   | lifted | mouse gone |
/// |-----------|-----------|----------|------------|-----------|--------|------------|
/// | pointing  |           |          | touching   | gesturing |        | away       |
/// | touching  |           | pointing |            | gesturing | lifted |            |
/// | gesturing |           | pointing | touching   |           | lifted |            |
/// | lifted    | pointing  | pointing | touching   | gesturing |        | away       |
/// | away      | pointing  | pointing | touching   | gesturing |        |            |
class HandState {
public:
    enum class Is {
        pointing,  ///< a mouse, or the keys
        touching,  ///< one fingertip on the screen, which is where it is
        gesturing, ///< several: they mean something when they are lifted
        lifted,    ///< the fingertip is off the screen
        away,      ///< the mouse is off the surface
    };

    Is is() const { return is_; }
    bool touches() const { return is_ == Is::touching || is_ == Is::gesturing; }
    /// The place is a fingertip's, not where a force has drawn the finger.
    bool is_fingertip() const { return touches() || is_ == Is::lifted; }
    bool off_surface() const { return is_ == Is::lifted || is_ == Is::away; }

    void mouse() {
        if (!touches())
            is_ = Is::pointing;
    }
    void keys() { is_ = Is::pointing; }
    void one_finger() { is_ = Is::touching; }
    void several_fingers() { is_ = Is::gesturing; }
    void lifted() {
        if (touches())
            is_ = Is::lifted;
    }
    void mouse_gone() {
        if (!touches())
            is_ = Is::away;
    }

private:
    Is is_ = Is::pointing;
};

} // namespace tp
