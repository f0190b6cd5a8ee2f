// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tp::vm {

/// What is true of a device after one of its milliseconds.
struct DeviceSample {
    double time = 0.0; ///< s, the machine's monotonic clock
    Vec2 force{0.0};   ///< N, on the handle
    Vec2 handle{0.0};  ///< mm, device frame
    bool motors = false;
    bool plugged = false;
};

/// A device's inner life: what goes on whether or not it is plugged in.
class VirtualDevice {
public:
    virtual ~VirtualDevice() = default;
    /// A millisecond of its time. `time` and `plugged` are the caller's to fill in.
    virtual DeviceSample step() = 0;
    /// From now on it says nothing, or speaks again.
    virtual void silence(bool silent) = 0;
};

/// A device as its HID interface shows it; a UhidPort makes it one of the kernel's.
class HidModel {
public:
    struct Identity {
        std::uint16_t vendor = 0;
        std::uint16_t product = 0;
        std::string name;
        std::string serial_number;
        std::span<const std::uint8_t> report_descriptor;
        std::uint16_t bus = 3; ///< BUS_USB of linux/input.h
    };
    using Bytes = std::vector<std::uint8_t>;

    virtual ~HidModel() = default;
    virtual Identity identity() const = 0;
    /// An output report; its id leads, 0 where the device has no ids.
    virtual void output(std::span<const std::uint8_t> report) = 0;
    /// The feature report with this id, which leads it; nothing: refused.
    virtual std::optional<Bytes> feature(std::uint8_t) { return std::nullopt; }
    /// The input report with this id as it is now, as a computer may ask for it; nothing: refused.
    virtual std::optional<Bytes> input_now(std::uint8_t) { return std::nullopt; }
    /// A feature report that the computer sets; its id leads. False: refused.
    virtual bool set_feature(std::span<const std::uint8_t>) { return false; }
    /// The next input report, with its id in front where the device has ids; false when all is said.
    virtual bool input(Bytes& report) = 0;
};

/// A device as its USB shows it; a UsbipPort plugs it into the kernel's virtual host controller.
class UsbModel {
public:
    struct Descriptors {
        std::vector<std::uint8_t> device;
        std::vector<std::uint8_t> configuration; ///< with its interfaces and endpoints
        std::vector<std::string> strings;        ///< number 1 first
    };
    using Bytes = std::vector<std::uint8_t>;
    enum class Speed { full = 2, high = 3 }; ///< as the kernel's usb_device_speed numbers them

    virtual ~UsbModel() = default;
    virtual Speed speed() const { return Speed::full; }
    virtual Descriptors descriptors() const = 0;
    /// A control request that is not one of the standard ones for the whole device, as its eight setup bytes
    /// and what came with it: the answer, empty for a request that wants none. Nothing: stalled.
    virtual std::optional<Bytes> control(std::span<const std::uint8_t, 8>, std::span<const std::uint8_t>) {
        return std::nullopt;
    }
    /// A transfer to the endpoint with this number.
    virtual void output(unsigned endpoint, std::span<const std::uint8_t> bytes) = 0;
    /// What the endpoint with this number has for a transfer of at most `most` bytes; false: nothing yet, it
    /// waits.
    virtual bool input(unsigned endpoint, std::size_t most, Bytes& bytes) = 0;
};

} // namespace tp::vm
