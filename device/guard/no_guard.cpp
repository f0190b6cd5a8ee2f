// SPDX-License-Identifier: Apache-2.0
#include "device/guard/no_guard.hpp"

namespace tp {

Error nobody_to_watch() {
    return Error{"The device stays off, because nothing would watch over its motors on this system."};
}

Error guard_is_missing() {
    return Error{"The device stays off, because the program that watches over its motors, "
                 "touchphoto-force-guard, is missing. Install TouchPhoto again."};
}

Error guard_does_not_start() {
    return Error{"The device stays off, because the program that watches over its motors, "
                 "touchphoto-force-guard, does not start. Install TouchPhoto again."};
}

Error no_room_for_guard() {
    return Error{"This computer has no room for the program that watches over the motors. Close other "
                 "programs and try again."};
}

} // namespace tp
