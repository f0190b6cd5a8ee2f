// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <algorithm>

namespace tp {

/// A place where a detector sees a face, in pixels of the picture it was shown.
struct Detection {
    Rect box;            ///< the head without hair
    Vec2 right_eye{0.0}; ///< centre of the person's own right eye, left in the picture
    Vec2 left_eye{0.0};  ///< centre of the other eye
    double score = 0.0;  ///< 0 … 1

    double size() const { return std::max(box.width(), box.height()); }
    bool operator==(const Detection& other) const {
        return box.min == other.box.min && box.max == other.box.max && right_eye == other.right_eye &&
               left_eye == other.left_eye && score == other.score;
    }
};

} // namespace tp
