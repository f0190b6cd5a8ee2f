// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <vector>

namespace tp {

/// What a face does, as far as its contours are sure. A face that does neither, or of which nothing is sure, is
/// `unknown`: nothing is said of it.
enum class Mien { unknown, perhaps_smiling, smiling, smiling_broadly, perhaps_laughing };
enum class Eyes { unknown, open, perhaps_shut, shut };
/// Where a face is turned; left and right are those of who looks at the picture.
enum class Facing { unknown, camera, left, right };
/// How much of the picture a face fills.
enum class Nearness { far, usual, head_and_shoulders, face };
/// Never by how light a face is, for that would tell of the skin: by all of a picture, or by what is around people.
enum class Light { usual, dark, dark_background, bright_background };
/// What most of a picture is.
/// Without orange, which is skin, wood and lamplight.
enum class Colours { many, black_and_white, red, yellow, green, blue, violet };

/// A face that was found, in words' measure.
struct SeenFace {
    Rect part;            ///< its box, 0 … 1 of the picture as it is shown, y down; may reach beyond
    bool cut_off = false; ///< the picture's edge cuts it
    Mien mien = Mien::unknown;
    Eyes eyes = Eyes::unknown;
    Facing facing = Facing::unknown;

    bool operator==(const SeenFace& other) const {
        return part.min == other.part.min && part.max == other.part.max && cut_off == other.cut_off &&
               mien == other.mien && eyes == other.eyes && facing == other.facing;
    }
};

/// What is seen on a photograph: what a sentence about it can be made of, and nothing that could be guessed about a
/// person beyond that (no age, sex, descent, beauty or health).
struct SeenPhoto {
    int width = 0, height = 0;   ///< px, upright; 0: it could not be read
    int turned_degrees = 0;      ///< as Extraction::turned_degrees
    std::vector<SeenFace> faces; ///< the largest first
    Light light = Light::usual;
    Colours colours = Colours::many;
    bool blurred = false;

    bool operator==(const SeenPhoto&) const = default;
};

/// Of the largest face; far where there is none.
Nearness nearness_of(const SeenPhoto& seen);

} // namespace tp
