// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/plugged_steam_pads.hpp"

#include "device/bus_mutex.hpp"
#include "device/touch_output/steam_pad/hid_steam_transport.hpp"
#include "device/touch_output/steam_pad/steam_pad.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace tp {

namespace {

/// The interfaces of one thing that is plugged in: of a receiver several, one for each controller that it can be joined to.
using Interfaces = std::vector<FoundSteamPad>;

std::vector<Interfaces> controllers_found() {
    std::vector<Interfaces> all;
    for (FoundSteamPad& found : find_steam_pads()) {
        const auto same = std::find_if(all.begin(), all.end(), [&found](const Interfaces& other) {
            return found.kind == steam::Kind::receiver && other.front().kind == found.kind &&
                   other.front().serial_number == found.serial_number;
        });
        if (same == all.end())
            all.emplace_back().push_back(std::move(found));
        else
            same->push_back(std::move(found));
    }
    return all;
}

Result<std::unique_ptr<SteamTransport>> open_now(const FoundSteamPad& pad) {
    const std::lock_guard lock(bus_mutex());
    return open_steam_pad(pad);
}

} // namespace

std::vector<PluggedTouchOutput> plugged_steam_pads() {
    std::vector<PluggedTouchOutput> outputs;
    for (const Interfaces& interfaces : controllers_found()) {
        const FoundSteamPad& first = interfaces.front();
        PluggedTouchOutput output;
        output.name = "steam:" + (first.serial_number.empty() ? first.path : first.serial_number);
        output.about = first.kind == steam::Kind::deck         ? "Steam Deck: its touch pads"
                       : first.kind == steam::Kind::controller ? "Steam Controller: its touch pads"
                                                               : "Steam Controller by radio: its touch pads";
        output.serial_number = first.serial_number;
        output.means = TouchMeans::ticks;
        output.delay = SteamPad::delay_s(first.kind);
        output.is_pad = true;
        output.make = [interfaces] {
            std::vector<SteamPad::Opener> openers;
            for (const FoundSteamPad& one : interfaces)
                openers.emplace_back([one] { return open_now(one); });
            return std::make_unique<SteamPad>(std::move(openers), interfaces.front().serial_number);
        };
        outputs.push_back(std::move(output));
    }
    return outputs;
}

} // namespace tp
