// SPDX-License-Identifier: Apache-2.0
// vm_virtual_joystick PORTRAIT.svg LOG: a force stick on this kernel, and a hand that sweeps over the portrait
// with it; serve() says what the standard input does.
#include "face_touch.hpp"
#include "uhid_port.hpp"
#include "virtual_joystick.hpp"

#include <cstdio>

int main(int count, char** words) {
    using namespace tp::vm;
    if (count != 3) {
        std::fputs("vm_virtual_joystick PORTRAIT.svg LOG\n", stderr);
        return 2;
    }
    const auto face = face_of(words[1]);
    if (!face) {
        std::fprintf(stderr, "%s\n", face.error().c_str());
        return 2;
    }
    constexpr double beside_mm = 3.0;
    VirtualJoystick stick(way_beside(*face, beside_mm));
    UhidPort port(stick);
    return serve(stick, port, words[2]);
}
