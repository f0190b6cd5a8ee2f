// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/shared_pixels.hpp"

#include <algorithm>
#include <cstddef>

namespace tp {
namespace {

constexpr std::size_t kept_bytes = std::size_t{3} * 3200 * 2400;
constexpr std::size_t bytes_at_a_time = 4 << 20;

} // namespace

bool PixelTray::put(const cv::Mat& picture) {
    const std::size_t bytes = picture.total() * picture.elemSize();
    if (!memory_ || memory_->size() != std::max(bytes, kept_bytes)) {
        memory_.reset();
        memory_ = SharedMemory::make(std::max(bytes, kept_bytes));
        is_new_ = true;
    }
    if (!memory_)
        return false;
    cv::Mat in_tray(picture.size(), picture.type(), memory_->data());
    picture.copyTo(in_tray);
    return true;
}

Descriptor PixelTray::handed_over() {
    if (!memory_ || !is_new_)
        return Descriptor();
    is_new_ = false;
    Descriptor descriptor = memory_->another();
    if (memory_->size() > kept_bytes)
        memory_.reset();
    return descriptor;
}

cv::Mat pixels_in(std::optional<Mapping>& tray, cv::Size size) {
    if (!tray || size.width <= 0 || size.height <= 0)
        return {};
    const std::size_t bytes =
        std::size_t{3} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    cv::Mat picture;
    if (bytes <= tray->size()) {
        const cv::Mat in_tray(size, CV_8UC3, tray->data());
        const std::size_t row = 3 * static_cast<std::size_t>(size.width);
        const int rows = std::max(1, static_cast<int>(bytes_at_a_time / row));
        picture.create(size, CV_8UC3);
        for (int y = 0; y < size.height; y += rows) { // never both whole in memory
            const int end = std::min(size.height, y + rows);
            in_tray.rowRange(y, end).copyTo(picture.rowRange(y, end));
            tray->rest(static_cast<std::size_t>(y) * row, static_cast<std::size_t>(end - y) * row);
        }
    }
    if (tray->size() > kept_bytes)
        tray.reset();
    return picture;
}

} // namespace tp
