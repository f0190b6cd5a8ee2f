// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tp {

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): the standard's own generators and shuffle differ between libraries.
class SplitMix {
public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// 0 … below, each as likely; below > 0.
    std::uint64_t below(std::uint64_t below) {
        const std::uint64_t unfair =
            (0 - below) % below; // as many of the smallest numbers would come once too often
        std::uint64_t number = next();
        while (number < unfair)
            number = next();
        return number % below;
    }
    template <typename T>
    void shuffle(std::vector<T>& all) {
        for (std::size_t i = all.size(); i > 1; --i)
            std::swap(all[i - 1], all[below(i)]);
    }

private:
    std::uint64_t state_;
};

} // namespace tp
