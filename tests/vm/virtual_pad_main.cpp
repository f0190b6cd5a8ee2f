// SPDX-License-Identifier: Apache-2.0
// vm_virtual_pad hid|bulk PORTRAIT.svg LOG: a force pad on this kernel, and a hand that sweeps over the
// portrait with it; serve() says what the standard input does.
#include "face_touch.hpp"
#include "uhid_port.hpp"
#include "usbip_port.hpp"
#include "virtual_pad.hpp"

#include <cstdio>
#include <string_view>

int main(int count, char** words) {
    using namespace tp::vm;
    const std::string_view bus = count == 4 ? words[1] : "";
    if (bus != "hid" && bus != "bulk") {
        std::fputs("vm_virtual_pad hid|bulk PORTRAIT.svg LOG\n", stderr);
        return 2;
    }
    const auto face = face_of(words[2]);
    if (!face) {
        std::fprintf(stderr, "%s\n", face.error().c_str());
        return 2;
    }
    constexpr double beside_mm = 3.0;
    VirtualPad pad(way_beside(*face, beside_mm));
    if (bus == "hid") {
        PadOverHid model(pad);
        UhidPort port(model);
        return serve(pad, port, words[3]);
    }
    PadOverBulk model(pad);
    UsbipPort port(model);
    return serve(pad, port, words[3]);
}
