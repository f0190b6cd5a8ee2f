// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// The one thing that the person should do now, in the terms of their own hand.
enum class Advice : std::uint8_t {
    look_left, ///< nobody is seen: turn slowly to the left
    look_right,
    look_up,
    look_down,
    move_left, ///< the camera is to look further to the left
    move_right,
    move_up,
    move_down,
    closer,
    farther,
    turn_clockwise, ///< as the holder sees the camera
    turn_anticlockwise,
    more_light,        ///< the face is dark
    light_behind_them, ///< the face is dark before something bright
    keep_still,        ///< all is well but for the picture, which moves or is blurred
    eyes_shut,         ///< all is well but for the eyes of somebody
    ready              ///< hold still: all is well
};

/// How much of it.
enum class AimStep : std::uint8_t { little, some, much };

/// An edge of the picture, as the person holds it: "left" is at their left.
enum class AimEdge : std::uint8_t { none, left, right, top, bottom };

/// What could be said now. It holds no sentence: whoever speaks makes one of it.
struct AimInstruction {
    Advice advice = Advice::look_right;
    AimStep step = AimStep::little;
    /// How much, > 0: of a move the share of the picture's width or height; of closer and farther metres, where
    /// the face is an adult's and the camera a usual one; of a turn degrees; else 0.
    double amount = 0.0;
    int faces = 0;               ///< how many count
    AimEdge cut = AimEdge::none; ///< the edge that cuts a face of the subject
    /// Whose faces they are, of those that are known, each once, in the order in which they came into view.
    std::vector<std::string> names{};
};

inline bool is_look(Advice advice) { return advice <= Advice::look_down; }
inline bool is_move(Advice advice) { return advice >= Advice::move_left && advice <= Advice::move_down; }

} // namespace tp
