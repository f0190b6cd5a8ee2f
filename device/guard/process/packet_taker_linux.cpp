// SPDX-License-Identifier: Apache-2.0
#include "device/guard/process/force_taker.hpp"
#include "device/guard/process/posix_ends.hpp"

#include <cerrno>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <utility>

namespace tp::guard {

namespace {

constexpr unsigned packets = 3; ///< what the device holds of a broken one can spoil the first
constexpr unsigned packet_tries = 10;
constexpr unsigned packet_timeout_ms = 100;

class PacketTaker final : public ForceTaker {
public:
    PacketTaker(unsigned endpoint, Bytes no_force) : endpoint_(endpoint), no_force_(std::move(no_force)) {}
    bool let_go() override {
        unsigned taken = 0;
        for (unsigned i = 0; i < packet_tries && taken < packets; ++i) {
            usbdevfs_bulktransfer packet{endpoint_, static_cast<unsigned>(no_force_.size()),
                                         packet_timeout_ms, no_force_.data()};
            if (ioctl(device_descriptor, USBDEVFS_BULK, &packet) == static_cast<int>(no_force_.size()))
                ++taken;
            else if (errno == EPIPE)
                ioctl(device_descriptor, USBDEVFS_CLEAR_HALT, &endpoint_);
            else if (errno == ENODEV)
                break;
        }
        return true;
    }
    void leave(bool may_pull) override {
        if (may_pull)
            let_go();
    }

private:
    unsigned endpoint_;
    Bytes no_force_;
};

} // namespace

std::unique_ptr<ForceTaker> packet_taker(std::uint8_t endpoint, Bytes no_force) {
    return std::make_unique<PacketTaker>(endpoint, std::move(no_force));
}

} // namespace tp::guard
