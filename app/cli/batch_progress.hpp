// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tp {

/// About how long the rest of a batch takes, e.g. "about 3 min left", when `done` of `all` took `seconds`;
/// empty where nothing is left or nothing was done.
std::string time_left(std::size_t done, std::size_t all, double seconds);

/// Counts a batch for a person: "3 of 40: IMG_3.jpg, about 2 min left".
class BatchProgress {
public:
    explicit BatchProgress(std::size_t all) : all_(all) {}
    /// The line for the next one that is done.
    std::string next(const std::string& name);

private:
    std::size_t all_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

} // namespace tp
