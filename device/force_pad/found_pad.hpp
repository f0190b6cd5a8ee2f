// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tp {

/// A device with a force pad's ids, as one bus shows it; whether it is a force pad it must say itself.
struct FoundPad {
    std::string path; ///< the system's name for it, or on the USB the place it is plugged in: "1-4.2"
    std::string serial_number;
    std::string product;
};

} // namespace tp
