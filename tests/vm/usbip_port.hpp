// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "port.hpp"

#include <cstdint>
#include <vector>

namespace tp::vm {

/// A USB device in the kernel's own virtual host controller (vhci_hcd), spoken to as USB/IP says
/// (Documentation/usb/usbip_protocol.rst of the kernel) over a pair of sockets; no network is in it.
class UsbipPort final : public Port {
public:
    /// The model must outlive it.
    explicit UsbipPort(UsbModel& model) : model_(model) {}
    ~UsbipPort() override { UsbipPort::unplug(); }
    UsbipPort(const UsbipPort&) = delete;
    UsbipPort& operator=(const UsbipPort&) = delete;

    bool plug_in() override;
    void unplug() override;
    int file() const override { return file_; }
    bool take_in() override;
    bool pass_on() override;

private:
    /// A transfer from the device that waits for it to have something.
    struct Waiting {
        std::uint32_t number;
        unsigned endpoint;
        std::size_t most;
    };
    bool answer(std::uint32_t number, int status, std::size_t length, const UsbModel::Bytes& bytes);
    bool take_back(std::uint32_t number, std::uint32_t unwanted);
    bool control(std::uint32_t number, const std::uint8_t* setup, bool inward, const UsbModel::Bytes& sent);

    UsbModel& model_;
    int file_ = -1;
    std::uint8_t configuration_ = 0;
    std::vector<Waiting> waiting_; ///< in the order in which they came
};

} // namespace tp::vm
