// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/dnn/dnn.hpp>

#include <optional>

namespace tp {

/// What lies before the jaw, as far as can be told: then the outline is a guess.
enum class JawCover { none, beard, hair };

/// The net that tells it. It is loaded when it is first asked.
class HiddenJaw {
public:
    /// Of a face in an 8-bit BGR picture; none where there is nothing to see. It looks a second time, in the
    /// mirror, where the first look is not sure.
    JawCover cover(const cv::Mat& picture, const Landmarks& face);

    /// Gives its memory back until it is asked again.
    void rest() { net_.reset(); }

private:
    std::optional<cv::dnn::Net> net_;
};

} // namespace tp
