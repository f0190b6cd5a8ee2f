// SPDX-License-Identifier: Apache-2.0
// vm_virtual_steam_pad deck|controller LOG: Steam pads on this kernel, and a thumb that goes round on the left one; serve() says
// what the standard input does.
#include "uhid_port.hpp"
#include "virtual_steam_pad.hpp"

#include <cstdio>
#include <string_view>

int main(int count, char** words) {
    using namespace tp::vm;
    const std::string_view kind = count == 3 ? words[1] : "";
    if (kind != "deck" && kind != "controller") {
        std::fputs("vm_virtual_steam_pad deck|controller LOG\n", stderr);
        return 2;
    }
    VirtualSteamPad pad(kind == "deck" ? tp::steam::Kind::deck : tp::steam::Kind::controller);
    UhidPort port(pad);
    return serve(pad, port, words[2]);
}
