// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/hid_steam_transport.hpp"

#include "core/files/open_file.hpp"
#include "device/hid/hidraw_descriptor.hpp"
#include "device/hid/report_descriptor.hpp"
#include "device/hid_handles.hpp"
#include "device/open_problem.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <hidapi.h>
#include <optional>
#include <thread>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t feature_payload = 64;

/// Linux tells the interface by its feature report, as hid-steam.c does; elsewhere by its vendor's usage page.
bool tells_of_pads(const hid_device_info& one) {
    const std::vector<std::uint8_t> bytes = hid::hidraw_descriptor(one.path);
    if (bytes.empty())
        return one.usage_page >= 0xFF00;
    hid::ReportDescriptor descriptor;
    return hid::parse_report_descriptor(bytes, descriptor) == hid::DescriptorFault::none &&
           !descriptor.numbered && descriptor.bytes(hid::ReportKind::feature, 0) >= feature_payload;
}

class HidSteamTransport final : public SteamTransport {
public:
    HidSteamTransport(HidHandles handles, OpenFile lock, steam::Kind kind)
        : handles_(std::move(handles)), lock_(std::move(lock)), kind_(kind) {}

    steam::Kind kind() const override { return kind_; }

    Got read(Input& report, int wait_ms) noexcept override {
        const int count =
            hid_read_timeout(handles_.reader.get(), report.bytes.data(), report.bytes.size(), wait_ms);
        if (count <= 0)
            return count < 0 ? Got::lost : Got::nothing;
        report.size = static_cast<std::size_t>(count);
        return Got::report;
    }

    bool send(const steam::Feature& report) noexcept override {
        // By radio a report is refused until it has gone through the air (SDL: to 25 ms).
        constexpr int tries = 25;
        for (int i = 0; i < tries; ++i) {
            if (hid_send_feature_report(handles_.writer(), report.data(), report.size()) >= 0)
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }

private:
    HidHandles handles_;
    OpenFile lock_; ///< held as long as this program uses it
    steam::Kind kind_;
};

} // namespace

std::vector<FoundSteamPad> find_steam_pads() {
    std::vector<FoundSteamPad> found;
    hid_device_info* const all = hid_enumerate(steam::vendor, 0);
    for (const hid_device_info* one = all; one != nullptr; one = one->next) {
        const std::optional<steam::Kind> kind = steam::kind_of(one->product_id);
        // hidapi lists a node once for each of its collections.
        const bool known = std::any_of(found.begin(), found.end(),
                                       [one](const FoundSteamPad& other) { return other.path == one->path; });
        if (kind && !known && tells_of_pads(*one))
            found.push_back({*kind, one->path, plain_hid_text(one->serial_number)});
    }
    hid_free_enumeration(all);
    return found;
}

Result<std::unique_ptr<SteamTransport>> open_steam_pad(const FoundSteamPad& pad) {
    const std::string name = pad.kind == steam::Kind::deck ? "Steam Deck" : "Steam Controller";
    Result<HidHandles> handles = open_hid_handles(pad.path, name);
    if (!handles.ok())
        return Error{handles.error()};
    OpenFile node(pad.path, {.write = true});
    if (node.ok() && !node.lock() && errno == EWOULDBLOCK)
        return Error{sentence(OpenProblem::busy, this_system(), name)};
    return std::unique_ptr<SteamTransport>(
        std::make_unique<HidSteamTransport>(std::move(handles).value(), std::move(node), pad.kind));
}

} // namespace tp
