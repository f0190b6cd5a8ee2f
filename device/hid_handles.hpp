// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <hidapi.h>
#include <memory>
#include <string>

namespace tp {

struct CloseHid {
    void operator()(hid_device* device) const { hid_close(device); }
};
using HidHandle = std::unique_ptr<hid_device, CloseHid>;

/// hidapi keeps the words of the last error in the handle, so that two threads must not share one: reports
/// are read through one handle and written through another where the system opens a device twice.
struct HidHandles {
    HidHandle reader;
    HidHandle other; ///< nothing where the system opens a device only once

    hid_device* writer() const { return other ? other.get() : reader.get(); }
};

/// Opens a device by the system's name for it. The error is a sentence that says what to do on this system,
/// for a device called `name`.
Result<HidHandles> open_hid_handles(const std::string& path, const std::string& name);

/// What a device says of itself, with a question mark for what is not ASCII.
std::string plain_hid_text(const wchar_t* text);

} // namespace tp
