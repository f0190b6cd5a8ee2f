// SPDX-License-Identifier: Apache-2.0
#include "device/registry.hpp"

#include "device/force_pad/bulk_transport.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/hid_transport.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

namespace tp {

namespace {

constexpr const char* simulated = "simulated";

/// One look or opening at a time: hidapi's own set-up and its list are not made for two threads.
std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
}

/// A force pad by the interfaces that this system shows; at least one.
struct PluggedPad {
    std::optional<FoundPad> hid;
    std::optional<FoundPad> bulk;

    const FoundPad& any() const { return hid ? *hid : *bulk; }
    std::string name() const {
        return "pad:" + (any().serial_number.empty() ? any().path : any().serial_number);
    }
};

std::vector<PluggedPad> plugged_pads() {
    std::vector<PluggedPad> pads;
    for (FoundPad& found : find_hid())
        pads.push_back({std::move(found), std::nullopt});
    for (FoundPad& found : find_bulk()) {
        const auto same = std::find_if(pads.begin(), pads.end(), [&found](const PluggedPad& pad) {
            return !found.serial_number.empty() && pad.any().serial_number == found.serial_number;
        });
        if (same != pads.end())
            same->bulk = std::move(found);
        else
            pads.push_back({std::nullopt, std::move(found)});
    }
    return pads;
}

Result<std::unique_ptr<ReportTransport>> open_pad(const PluggedPad& pad) {
    const std::lock_guard lock(one_at_a_time());
    if (!pad.hid)
        return open_bulk(*pad.bulk);
    Result<std::unique_ptr<ReportTransport>> over_hid = open_hid(*pad.hid);
    if (over_hid.ok() || !pad.bulk)
        return over_hid;
    Result<std::unique_ptr<ReportTransport>> over_bulk = open_bulk(*pad.bulk);
    return over_bulk.ok() ? std::move(over_bulk) : std::move(over_hid);
}

/// The one of its interfaces that open_pad takes, or tries last.
const char* interface_used(const PluggedPad& pad) {
    return pad.hid && (!pad.bulk || open_hid(*pad.hid).ok()) ? "hid" : "bulk";
}

} // namespace

std::vector<ListedDevice> list_devices() {
    const std::lock_guard lock(one_at_a_time());
    std::vector<ListedDevice> devices{{simulated, "the mouse or a finger on the screen", "", ""}};
    for (const PluggedPad& pad : plugged_pads())
        devices.push_back({pad.name(), pad.any().product.empty() ? "force pad" : pad.any().product,
                           pad.any().serial_number, interface_used(pad)});
    return devices;
}

Result<std::unique_ptr<ForceDevice>> device_named(const std::string& name) {
    if (name == simulated)
        return std::unique_ptr<ForceDevice>(std::make_unique<SimulatedDevice>(200.0, 150.0));
    const std::lock_guard lock(one_at_a_time());
    for (const PluggedPad& pad : plugged_pads())
        if (pad.name() == name)
            return std::unique_ptr<ForceDevice>(std::make_unique<ForcePad>([pad] { return open_pad(pad); }));
    return Error{"There is no device \"" + name +
                 "\" now. See that it is plugged in; \"touchphoto-lab devices\" lists what is there."};
}

} // namespace tp
