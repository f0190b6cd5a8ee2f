// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/sample_ring.hpp"

#include <algorithm>

namespace tp {

std::size_t SampleRing::filled() const {
    const std::size_t read = read_.load(std::memory_order_acquire);
    return written_.load(std::memory_order_acquire) - read;
}

std::size_t SampleRing::write(std::span<const float> samples) {
    const std::size_t written = written_.load(std::memory_order_relaxed);
    const std::size_t room = capacity() - (written - read_.load(std::memory_order_acquire));
    const std::size_t count = std::min(room, samples.size());
    const std::size_t begin = written % capacity();
    const std::size_t first = std::min(count, capacity() - begin);
    std::copy_n(samples.data(), first, samples_.data() + begin);
    std::copy_n(samples.data() + first, count - first, samples_.data());
    written_.store(written + count, std::memory_order_release);
    return count;
}

std::size_t SampleRing::read(std::span<float> samples) {
    const std::size_t read = read_.load(std::memory_order_relaxed);
    const std::size_t count = std::min(written_.load(std::memory_order_acquire) - read, samples.size());
    const std::size_t begin = read % capacity();
    const std::size_t first = std::min(count, capacity() - begin);
    std::copy_n(samples_.data() + begin, first, samples.data());
    std::copy_n(samples_.data(), count - first, samples.data() + first);
    read_.store(read + count, std::memory_order_release);
    return count;
}

} // namespace tp
