// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/falcon/falcon_link.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// A device on the USB with a Falcon's ids; whether it is a Falcon it must show.
struct FoundFalcon {
    std::string path; ///< the place it is plugged in: "1-4.2"
    std::string serial_number;
};

/// Those on the USB now; none where libusb cannot work.
std::vector<FoundFalcon> find_falcons();

/// Opens the one with this serial number wherever it is plugged in, or without a number the one at this
/// place, and takes it for itself, from the system's serial driver if need be. The error is a sentence that
/// says what to do on this system. The program is the one that shall guard it
/// (force_guard_program()).
Result<std::unique_ptr<FalconLink>> open_falcon(const FoundFalcon& falcon, const std::string& guard_program);

} // namespace tp
