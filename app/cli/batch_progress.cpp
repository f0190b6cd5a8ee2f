// SPDX-License-Identifier: Apache-2.0
#include "app/cli/batch_progress.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

std::string time_left(std::size_t done, std::size_t all, double seconds) {
    if (done == 0 || done >= all)
        return {};
    const double left = seconds * static_cast<double>(all - done) / static_cast<double>(done);
    const auto about = [](double amount, const char* unit) {
        return "about " + std::to_string(std::max(1L, std::lround(amount))) + " " + unit + " left";
    };
    return left < 90.0     ? about(left, "s")
           : left < 5400.0 ? about(left / 60.0, "min")
                           : about(left / 3600.0, "h");
}

std::string BatchProgress::next(const std::string& name) {
    ++done_;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began_;
    const std::string left = time_left(done_, all_, passed.count());
    return std::to_string(done_) + " of " + std::to_string(all_) + ": " + name +
           (left.empty() ? "" : ", " + left);
}

} // namespace tp
