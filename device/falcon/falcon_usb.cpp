// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/falcon_usb.hpp"

#include "device/falcon/falcon_frame.hpp"
#include "device/guard/guard_process.hpp"
#include "device/usb/bulk_pipe.hpp"
#include "device/usb/usb_devices.hpp"

#include <array>
#include <utility>

namespace tp {

namespace {

constexpr UsbKind falcon_on_the_usb{0x0403, 0xCB48, 0x81, 0x02,
                                    falcon::ftdi::status_size + falcon::packet_size};

class UsbFalconLink final : public FalconLink {
public:
    UsbFalconLink(std::unique_ptr<BulkPipe> pipe, const std::string& guard_program)
        : pipe_(std::move(pipe)), guard_program_(guard_program) {}

    bool control(const falcon::ftdi::Request& request) noexcept override {
        return pipe_->control(falcon::ftdi::request_type, request.request, request.value, 0);
    }
    UsbGot read(UsbPacket& packet, int wait_ms) noexcept override { return pipe_->read(packet, wait_ms); }
    bool write(std::span<const std::uint8_t> bytes) noexcept override { return pipe_->write(bytes); }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const std::uint8_t> no_force) override {
        const std::array endpoint{falcon_on_the_usb.out};
        return start_force_guard(guard_program_, pipe_->descriptor(),
                                 {"packet", guard_word(endpoint), guard_word(no_force)});
    }

private:
    std::unique_ptr<BulkPipe> pipe_;
    std::string guard_program_;
};

} // namespace

std::vector<FoundFalcon> find_falcons() {
    std::vector<FoundFalcon> found;
    if (const UsbContext context = usb_context())
        for (FoundUsb& one : find_usb(context.get(), falcon_on_the_usb))
            found.push_back({std::move(one.path), std::move(one.serial_number)});
    return found;
}

Result<std::unique_ptr<FalconLink>> open_falcon(const FoundFalcon& falcon, const std::string& guard_program) {
    Result<std::unique_ptr<BulkPipe>> pipe =
        open_pipe(falcon_on_the_usb, falcon.serial_number, falcon.path, "Falcon");
    if (!pipe.ok())
        return Error{pipe.error()};
    return std::unique_ptr<FalconLink>(
        std::make_unique<UsbFalconLink>(std::move(pipe).value(), guard_program));
}

} // namespace tp
