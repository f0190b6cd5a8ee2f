// SPDX-License-Identifier: Apache-2.0
// vm_virtual_game_pad LOG: a game pad with two motors on this kernel; serve() says what the standard input does.
#include "uhid_port.hpp"
#include "virtual_game_pad.hpp"

#include <cstdio>

int main(int count, char** words) {
    using namespace tp::vm;
    if (count != 2) {
        std::fputs("vm_virtual_game_pad LOG\n", stderr);
        return 2;
    }
    VirtualGamePad pad;
    UhidPort port(pad);
    return serve(pad, port, words[1]);
}
