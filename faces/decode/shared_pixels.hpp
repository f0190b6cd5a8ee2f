// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"
#include "core/processes/shared_memory.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <optional>

namespace tp {

/// Memory in which one picture after the other is handed to another process. It is kept, because new memory
/// costs more than copying: a page that is touched first takes 0.3 to 13 µs, by machine. What a search looks
/// at, at most 3200 px long, has room in it; a larger picture has memory for once.
class PixelTray {
public:
    /// Puts the pixels there, row after row without gaps. False where the system gives no memory.
    bool put(const cv::Mat& picture);
    /// Of memory that the other process does not have yet. Not ok() where it is that of the picture before.
    Descriptor handed_over();

private:
    std::optional<SharedMemory> memory_;
    bool is_new_ = false;
};

/// 8-bit BGR pixels of this size in px, copied from a tray that another process has handed over. Empty where
/// they are more than it has. A tray for once is gone afterwards.
cv::Mat pixels_in(std::optional<Mapping>& tray, cv::Size size);

} // namespace tp
