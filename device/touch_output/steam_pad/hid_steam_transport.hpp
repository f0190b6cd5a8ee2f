// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/touch_output/steam_pad/steam_transport.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// A Steam Deck's controller, a Steam Controller or a receiver, as the HID bus shows it.
struct FoundSteamPad {
    steam::Kind kind = steam::Kind::deck;
    std::string path; ///< the system's name for it
    std::string serial_number;
};

/// Those on the HID bus now: the interface that tells of the pads, not the mouse and keyboard beside it; of a receiver, which has
/// such an interface for each of four controllers, all. Calls of hidapi's enumeration: one thread at a time.
std::vector<FoundSteamPad> find_steam_pads();

/// Opens one. One that another TouchPhoto uses is busy. The error is a sentence that says what to do on this system.
Result<std::unique_ptr<SteamTransport>> open_steam_pad(const FoundSteamPad& pad);

} // namespace tp
