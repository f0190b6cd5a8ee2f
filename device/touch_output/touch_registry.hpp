// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/touch/touch_output.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// An output for a bare finger that can be used now.
struct ListedTouchOutput {
    std::string name;  ///< what touch_output_named takes
    std::string about; ///< as a person is told
    std::string serial_number;
    TouchMeans means = TouchMeans::ticks;
    bool is_pad = false; ///< the finger lies on it, and it tells where (TouchCapabilities::pad)
    double delay = 0.0;  ///< s, estimate from a call to what is felt (TouchCapabilities::delay)
};

/// What is plugged in or built in now, each once. Any thread; it may wait for another.
std::vector<ListedTouchOutput> list_touch_outputs();

/// One of them by its name, not yet open. An error where there is none of that name now. Any thread, as open() of the output.
Result<std::unique_ptr<TouchOutput>> touch_output_named(const std::string& name);

} // namespace tp
