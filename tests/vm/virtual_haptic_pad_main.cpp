// SPDX-License-Identifier: Apache-2.0
// vm_virtual_haptic_pad LOG: a touch pad with haptics on this kernel, and a finger that goes round on it; serve() says what the
// standard input does.
#include "uhid_port.hpp"
#include "virtual_haptic_pad.hpp"

#include <cstdio>

int main(int count, char** words) {
    using namespace tp::vm;
    if (count != 2) {
        std::fputs("vm_virtual_haptic_pad LOG\n", stderr);
        return 2;
    }
    VirtualHapticPad pad;
    UhidPort port(pad);
    return serve(pad, port, words[1]);
}
