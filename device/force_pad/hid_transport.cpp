// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/hid_transport.hpp"

#include "device/force_pad/protocol/usb.hpp"
#include "device/hid_handles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <hidapi.h>
#include <utility>

namespace tp {

namespace {

class HidTransport final : public ReportTransport {
public:
    explicit HidTransport(HidHandles handles) : handles_(std::move(handles)) {}

    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        std::array<std::uint8_t, pad::frame_size> bytes{};
        const int count = hid_read_timeout(handles_.reader.get(), bytes.data(), bytes.size(), wait_ms);
        if (count < 0)
            return Got::lost;
        if (count == 0)
            return Got::nothing;
        if (static_cast<std::size_t>(count) != pad::frame_size)
            return Got::odd;
        std::copy_n(bytes.begin(), pad::frame_size, frame.bytes);
        return Got::report;
    }

    bool write(const pad::Frame& frame) noexcept override {
        std::array<std::uint8_t, 1 + pad::frame_size> bytes{}; // report id 0 leads
        std::copy_n(frame.bytes, pad::frame_size, bytes.begin() + 1);
        return hid_write(handles_.writer(), bytes.data(), bytes.size()) >= 0;
    }

private:
    HidHandles handles_;
};

} // namespace

std::vector<FoundPad> find_hid() {
    std::vector<FoundPad> found;
    hid_device_info* const all = hid_enumerate(pad::usb_vendor, pad::usb_product);
    for (const hid_device_info* one = all; one != nullptr; one = one->next)
        // A back end of hidapi that cannot tell the usage page says 0.
        if (one->usage_page == pad::usage_page || one->usage_page == 0)
            found.push_back({one->path, plain_hid_text(one->serial_number), plain_hid_text(one->product_string)});
    hid_free_enumeration(all);
    return found;
}

Result<std::unique_ptr<ReportTransport>> open_hid(const FoundPad& pad) {
    Result<HidHandles> handles = open_hid_handles(pad.path, "force pad");
    if (!handles.ok())
        return Error{handles.error()};
    return std::unique_ptr<ReportTransport>(std::make_unique<HidTransport>(std::move(handles).value()));
}

} // namespace tp
