// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/camera_trouble.hpp"

namespace tp {

std::string sentence_of(CameraTrouble trouble) {
    switch (trouble) {
    case CameraTrouble::none_there:
        return "No camera was found on this computer.";
    case CameraTrouble::denied:
        return "The system does not let TouchPhoto use the camera.";
    case CameraTrouble::in_use:
        return "Another program is using the camera. Close it and try again.";
    case CameraTrouble::unplugged:
        return "The camera was unplugged.";
    case CameraTrouble::silent:
        return "The camera gives no pictures.";
    case CameraTrouble::unreadable:
        return "The camera gives pictures that TouchPhoto cannot read.";
    }
    return {};
}

} // namespace tp
