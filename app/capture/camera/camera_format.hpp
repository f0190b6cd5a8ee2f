// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QVideoFrameFormat>

#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

inline constexpr double fewest_frames_per_s = 10.0; ///< with which one can aim
inline constexpr int most_pixels = 12'600'000;      ///< 12 megapixels: what the shutter stores in time

/// One way in which a camera can be switched on.
struct CameraForm {
    QSize size; ///< px
    QVideoFrameFormat::PixelFormat pixels = QVideoFrameFormat::Format_Invalid;
    double frames_per_s = 0.0; ///< the most it gives
};

/// Which of them is taken, by its index: the largest that one can still aim with, of those the fastest. Where none is fast
/// enough, the fastest. None where no form is read.
std::optional<std::size_t> best_form(const std::vector<CameraForm>& forms);

} // namespace tp
