// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/plugged_pads.hpp"

#include "device/bus_mutex.hpp"
#include "device/force_pad/bulk_transport.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/hid_transport.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

namespace tp {

namespace {

/// A force pad by the interfaces that this system shows; at least one.
struct PadInterfaces {
    std::optional<FoundPad> hid;
    std::optional<FoundPad> bulk;

    const FoundPad& any() const { return hid ? *hid : *bulk; }
};

std::vector<PadInterfaces> pads_found() {
    std::vector<PadInterfaces> pads;
    for (FoundPad& found : find_hid())
        pads.push_back({std::move(found), std::nullopt});
    for (FoundPad& found : find_bulk()) {
        const auto same = std::find_if(pads.begin(), pads.end(), [&found](const PadInterfaces& pad) {
            return !found.serial_number.empty() && pad.any().serial_number == found.serial_number;
        });
        if (same != pads.end())
            same->bulk = std::move(found);
        else
            pads.push_back({std::nullopt, std::move(found)});
    }
    return pads;
}

Result<std::unique_ptr<ReportTransport>> open_pad(const PadInterfaces& pad) {
    const std::lock_guard lock(bus_mutex());
    if (!pad.hid)
        return open_bulk(*pad.bulk);
    Result<std::unique_ptr<ReportTransport>> over_hid = open_hid(*pad.hid);
    if (over_hid.ok() || !pad.bulk)
        return over_hid;
    Result<std::unique_ptr<ReportTransport>> over_bulk = open_bulk(*pad.bulk);
    return over_bulk.ok() ? std::move(over_bulk) : std::move(over_hid);
}

/// The one of its interfaces that open_pad takes, or tries last.
std::string interface_used(const PadInterfaces& pad) {
    return pad.hid && (!pad.bulk || open_hid(*pad.hid).ok()) ? "hid" : "bulk";
}

} // namespace

std::vector<PluggedDevice> plugged_pads() {
    std::vector<PluggedDevice> devices;
    for (const PadInterfaces& pad : pads_found()) {
        const FoundPad& found = pad.any();
        devices.push_back({"pad:" + (found.serial_number.empty() ? found.path : found.serial_number),
                           found.product.empty() ? "force pad" : found.product, found.serial_number,
                           [pad] { return interface_used(pad); },
                           [pad] { return std::make_unique<ForcePad>([pad] { return open_pad(pad); }); }});
    }
    return devices;
}

} // namespace tp
