// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace tp {

/// Why a camera gives no pictures.
enum class CameraTrouble {
    none_there,
    denied,    ///< the system keeps it from this program
    in_use,    ///< another program has it
    unplugged, ///< it was there
    silent,    ///< it is there and sends nothing
    unreadable ///< it sends pictures of a form that is not read
};

/// One sentence that says what it is and what the person can do.
std::string sentence_of(CameraTrouble trouble);

/// Where the system keeps its cameras; another place in tests.
struct CameraPlaces {
    std::filesystem::path devices = "/dev";
    std::filesystem::path names = "/sys/class/video4linux"; ///< NAMES/video0/name
};

/// What an `errno` says that opening a camera ended with.
CameraTrouble trouble_of(int error);
/// Why no camera is listed: one may be there that this program may not open.
CameraTrouble why_none(const CameraPlaces& places = {});
/// Why the camera that is called so, as its driver or the system says, gives nothing. `gave`: it has given pictures before.
CameraTrouble why_silent(const std::string& name, bool gave, const CameraPlaces& places = {});

} // namespace tp
