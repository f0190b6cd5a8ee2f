// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_output.hpp"

#include <functional>
#include <memory>
#include <string>

namespace tp {

/// An output for a bare finger that can be used now, as its back end gives it to the registry.
struct PluggedTouchOutput {
    std::string name; ///< the back end's word, a colon, and the serial number or, where it has none, its path
    std::string about; ///< as a person is told
    std::string serial_number;
    TouchMeans means = TouchMeans::ticks;
    bool is_pad = false; ///< the finger lies on it, and it tells where (TouchCapabilities::pad)
    double delay = 0.0;  ///< s, estimate from a call to what is felt (TouchCapabilities::delay)
    /// Its back end, not yet open, whose open() holds bus_mutex() itself.
    std::function<std::unique_ptr<TouchOutput>()> make;
};

} // namespace tp
