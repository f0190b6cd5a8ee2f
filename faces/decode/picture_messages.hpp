// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/processes/message.hpp"
#include "core/processes/shared_memory.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/picture_file.hpp"
#include "faces/decode/shared_pixels.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <cstdint>
#include <optional>

namespace tp {

/// What is asked of a helper that decodes pictures.
struct PictureQuestion {
    enum class What : std::uint8_t {
        to_fit, ///< `file`, as small as it fits into `box`
        shrunk, ///< `file`, with its longest side at least `longest_px`
        whole,  ///< all pixels of the picture that was shrunk last
        forget  ///< that picture; not answered
    };
    What what = What::forget;
    cv::Size box;
    int longest_px = 0;
    PictureFile file;
};
Message message_of(PictureQuestion question);
/// None where it is no such question.
std::optional<PictureQuestion> picture_question(MessageReader& message);

/// What it answers: a picture, or a sentence.
struct PictureAnswer {
    cv::Mat pixels;
    cv::Size size;
    int shrink = 1;
    bool whole_is_kept = false;
};
Message message_of(const Result<PictureAnswer>& answer, PixelTray& tray);
/// Believed is only what can be true: a helper may have been taken over by what it decoded. `tray` is what
/// that helper has handed over.
Result<PictureAnswer> picture_answer(Message& message, std::optional<Mapping>& tray);

} // namespace tp
