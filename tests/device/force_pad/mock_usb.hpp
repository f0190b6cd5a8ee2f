// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../usb/usb_bed.hpp"
#include "device/force_pad/model_pad.hpp"
#include "device/force_pad/protocol/frame.hpp"
#include "mock_hidraw.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <span>
#include <vector>

namespace tp::mock {

/// A force pad on the USB with the model pad behind its bulk endpoints. It makes a step and sends its state
/// for each frame that it is sent.
class UsbPadBed final : public UsbBed {
public:
    struct Seen : UsbBed::Seen {
        bool motors = false; ///< of the last force frame taken
        std::int16_t x_mn = 0, y_mn = 0;
    };

    UsbPadBed() {
        hid_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(hid_, "handle-ioctl", G_CALLBACK(answer_hidraw_ioctl), nullptr);
        model_.place_knob({10.0, 2.0});
    }
    ~UsbPadBed() override { g_object_unref(hid_); }

    /// With or without a HID node that the kernel made for its other interface, and with or without the bulk
    /// interface.
    bool plug_in(bool hid = false, bool bulk = true) {
        return appear({"1209", "0001", "0100", "touchphoto", "force pad", "TPC-0001", descriptors(bulk)},
                      hid ? hidraw_description() : std::string()) &&
               (!hid || umockdev_testbed_attach_ioctl(bed(), hidraw_node, hid_, nullptr) != FALSE);
    }
    Seen seen() {
        const std::lock_guard lock(mutex_);
        Seen all{seen_, motors_, x_mn_, y_mn_};
        return all;
    }

private:
    /// PROTOCOL.md's device at full speed; the second interface is the bulk one.
    static std::vector<std::uint8_t> descriptors(bool bulk) {
        constexpr std::uint8_t report_size = sizeof pad::report_descriptor;
        constexpr std::uint8_t hid[] = {9,    4, 0, 0, 2,    3,           0, 0,  0, 9,    0x21,
                                        0x11, 1, 0, 1, 0x22, report_size, 0, 7,  5, 0x83, 3,
                                        32,   0, 1, 7, 5,    0x04,        3, 32, 0, 1};
        constexpr std::uint8_t vendor[] = {9, 4,  1, 0, 2, 0xFF, 0x54, 1, 0,  7, 5, 0x81,
                                           2, 64, 0, 0, 7, 5,    0x02, 2, 64, 0, 0};
        const std::size_t total = 9 + sizeof hid + (bulk ? sizeof vendor : 0);
        const std::uint8_t head[] = {18,
                                     1,
                                     0,
                                     2,
                                     0,
                                     0,
                                     0,
                                     64,
                                     0x09,
                                     0x12,
                                     0x01,
                                     0x00,
                                     0,
                                     1,
                                     1,
                                     2,
                                     3,
                                     1,
                                     9,
                                     2,
                                     static_cast<std::uint8_t>(total),
                                     0,
                                     static_cast<std::uint8_t>(bulk ? 2 : 1),
                                     1,
                                     0,
                                     0x80,
                                     45};
        std::vector<std::uint8_t> all(sizeof head + sizeof hid + (bulk ? sizeof vendor : 0));
        std::memcpy(all.data(), head, sizeof head);
        std::memcpy(all.data() + sizeof head, hid, sizeof hid);
        if (bulk)
            std::memcpy(all.data() + sizeof head + sizeof hid, vendor, sizeof vendor);
        return all;
    }

    void hear(std::span<const std::uint8_t> packet) override {
        pad::Frame frame;
        if (packet.size() != pad::frame_size)
            return; // dropped, as PROTOCOL.md has it
        std::memcpy(frame.bytes, packet.data(), pad::frame_size);
        if (pad::ForceFrame force; pad::decode(frame, force)) {
            motors_ = force.motors;
            x_mn_ = force.x_mn;
            y_mn_ = force.y_mn;
        }
        model_.receive(frame);
        model_.step();
        pad::Frame report;
        while (model_.report(report)) {
            if (behaviour_.silent)
                continue;
            std::vector<std::uint8_t> bytes(report.bytes, report.bytes + pad::frame_size);
            if (behaviour_.other_device)
                for (std::uint8_t& byte : bytes)
                    byte = static_cast<std::uint8_t>(byte ^ 0x5A);
            if (behaviour_.odd_packets)
                for (const std::size_t odd : {15u, 0u, 64u})
                    packets_.emplace_back(odd, std::uint8_t{0x81});
            packets_.push_back(std::move(bytes));
        }
    }
    bool is_answer(const std::vector<std::uint8_t>& packet) const override {
        return packet.size() == pad::frame_size;
    }

    UMockdevIoctlBase* hid_ = nullptr;
    ModelPad model_{pad::cable_pad()}; ///< of the mutex, as what follows
    bool motors_ = false;
    std::int16_t x_mn_ = 0, y_mn_ = 0;
};

} // namespace tp::mock
