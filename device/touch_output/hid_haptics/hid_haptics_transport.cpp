// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/hid_haptics_transport.hpp"

#include "core/files/open_file.hpp"
#include "device/hid/hidraw_descriptor.hpp"
#include "device/hid/report_descriptor.hpp"
#include "device/hid_handles.hpp"
#include "device/open_problem.hpp"

#include <algorithm>
#include <cerrno>
#include <hidapi.h>
#include <utility>

namespace tp {

namespace {

class HidHapticsTransport final : public HapticsTransport {
public:
    HidHapticsTransport(HidHandles handles, std::string path, OpenFile lock)
        : handles_(std::move(handles)), path_(std::move(path)), lock_(std::move(lock)) {}

    std::vector<std::uint8_t> descriptor() override { return hid::hidraw_descriptor(path_); }

    std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t bytes) override {
        std::vector<std::uint8_t> report(1 + bytes);
        report[0] = id;
        const int count = hid_get_feature_report(handles_.writer(), report.data(), report.size());
        report.resize(count > 0 ? std::min(report.size(), static_cast<std::size_t>(count)) : 0);
        if (!report.empty())
            report.erase(report.begin());
        return report;
    }

    Got read(Input& report, int wait_ms) noexcept override {
        const int count =
            hid_read_timeout(handles_.reader.get(), report.bytes.data(), report.bytes.size(), wait_ms);
        if (count <= 0)
            return count < 0 ? Got::lost : Got::nothing;
        report.size = static_cast<std::size_t>(count);
        return Got::report;
    }

    bool send(const haptics::Output& report) noexcept override {
        return hid_write(handles_.writer(), report.bytes.data(), report.size) >= 0;
    }

private:
    HidHandles handles_;
    std::string path_;
    OpenFile lock_; ///< held as long as this program uses it
};

} // namespace

std::vector<FoundHapticPad> find_haptic_pads() {
    std::vector<FoundHapticPad> found;
    hid_device_info* const all = hid_enumerate(0, 0);
    for (const hid_device_info* one = all; one != nullptr; one = one->next) {
        // hidapi lists a node once for each of its collections.
        if (std::any_of(found.begin(), found.end(),
                        [one](const FoundHapticPad& other) { return other.path == one->path; }))
            continue;
        hid::ReportDescriptor descriptor;
        if (hid::parse_report_descriptor(hid::hidraw_descriptor(one->path), descriptor) !=
                hid::DescriptorFault::none ||
            !haptics::has_haptics(descriptor))
            continue;
        haptics::Layout layout;
        haptics::find_layout(descriptor, layout); // finds no pad of one that cannot be used
        found.push_back({one->path, plain_hid_text(one->serial_number), plain_hid_text(one->product_string),
                         layout.pad.has_value()});
    }
    hid_free_enumeration(all);
    return found;
}

Result<std::unique_ptr<HapticsTransport>> open_haptic_pad(const FoundHapticPad& pad) {
    const char* const name = "touch pad with haptics";
    Result<HidHandles> handles = open_hid_handles(pad.path, name);
    if (!handles.ok())
        return Error{handles.error()};
    OpenFile node(pad.path, {.write = true});
    if (node.ok() && !node.lock() && errno == EWOULDBLOCK)
        return Error{sentence(OpenProblem::busy, this_system(), name)};
    return std::unique_ptr<HapticsTransport>(
        std::make_unique<HidHapticsTransport>(std::move(handles).value(), pad.path, std::move(node)));
}

} // namespace tp
