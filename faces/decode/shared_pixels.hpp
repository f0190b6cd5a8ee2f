// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor_posix.hpp"
#include "core/processes/shared_memory_linux.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// From now on pictures of this process lie in memory that can be handed over, so that none is copied for
/// that. Small ones do not.
void keep_pixels_in_shared_memory();

/// The pixels for another process, row after row without gaps, sealed. The picture is empty afterwards. Not
/// ok() where the system gives no memory.
Descriptor handed_over(cv::Mat&& picture);

/// 8-bit BGR pixels that another process has handed over, of this size in px. Empty where it did not seal
/// their memory, or where they are fewer.
cv::Mat pixels_in(const Descriptor& memory, cv::Size size);

} // namespace tp
