// SPDX-License-Identifier: Apache-2.0
// vm_virtual_falcon FIRMWARE PORTRAIT.svg LOG: a Falcon on this kernel's USB that takes this firmware, and a
// hand that sweeps over the portrait with it; serve() says what the standard input does.
#include "device/falcon/firmware_image.hpp"
#include "face_touch.hpp"
#include "usbip_port.hpp"
#include "virtual_falcon.hpp"

#include <cstdio>

int main(int count, char** words) {
    using namespace tp::vm;
    if (count != 4) {
        std::fputs("vm_virtual_falcon FIRMWARE PORTRAIT.svg LOG\n", stderr);
        return 2;
    }
    const auto firmware = tp::falcon::firmware_in(words[1]);
    const auto face = face_of(words[2]);
    if (!firmware || !face) {
        std::fprintf(stderr, "%s%s\n", firmware.error().c_str(), face.error().c_str());
        return 2;
    }
    constexpr double beside_mm = 3.0;
    VirtualFalcon falcon(*firmware, way_beside(*face, beside_mm));
    UsbipPort port(falcon);
    return serve(falcon, port, words[3]);
}
