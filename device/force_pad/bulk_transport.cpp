// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/bulk_transport.hpp"

#include "device/force_pad/protocol/usb.hpp"
#include "device/usb/bulk_pipe.hpp"
#include "device/usb/usb_devices.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr UsbKind pad_on_the_usb{pad::usb_vendor, pad::usb_product, pad::bulk_in,       pad::bulk_out,
                                 pad::frame_size, pad::bulk_class,  pad::bulk_subclass, pad::bulk_protocol};

class BulkTransport final : public ReportTransport {
public:
    explicit BulkTransport(std::unique_ptr<BulkPipe> pipe) : pipe_(std::move(pipe)) {}

    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        UsbPacket packet;
        const UsbGot got = pipe_->read(packet, wait_ms);
        if (got != UsbGot::packet)
            return got == UsbGot::lost ? Got::lost : Got::nothing;
        if (packet.size != pad::frame_size)
            return Got::odd;
        std::copy_n(packet.bytes.begin(), pad::frame_size, frame.bytes);
        return Got::report;
    }
    bool write(const pad::Frame& frame) noexcept override { return pipe_->write(frame.bytes); }

private:
    std::unique_ptr<BulkPipe> pipe_;
};

} // namespace

std::vector<FoundPad> find_bulk() {
    std::vector<FoundPad> found;
    if (const UsbContext context = usb_context())
        for (FoundUsb& one : find_usb(context.get(), pad_on_the_usb))
            found.push_back({std::move(one.path), std::move(one.serial_number), std::move(one.product)});
    return found;
}

Result<std::unique_ptr<ReportTransport>> open_bulk(const FoundPad& pad) {
    Result<std::unique_ptr<BulkPipe>> pipe =
        open_pipe(pad_on_the_usb, pad.serial_number, pad.path, "force pad");
    if (!pipe.ok())
        return Error{pipe.error()};
    return std::unique_ptr<ReportTransport>(std::make_unique<BulkTransport>(std::move(pipe).value()));
}

} // namespace tp
