// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "port.hpp"

namespace tp::vm {

/// A HID device of the kernel's that is answered here (linux/uhid.h): its hidraw node is a real one.
class UhidPort final : public Port {
public:
    /// The model must outlive it.
    explicit UhidPort(HidModel& model) : model_(model) {}
    ~UhidPort() override { UhidPort::unplug(); }
    UhidPort(const UhidPort&) = delete;
    UhidPort& operator=(const UhidPort&) = delete;

    bool plug_in() override;
    void unplug() override;
    int file() const override { return file_; }
    bool take_in() override;
    bool pass_on() override;

private:
    HidModel& model_;
    int file_ = -1;
};

} // namespace tp::vm
