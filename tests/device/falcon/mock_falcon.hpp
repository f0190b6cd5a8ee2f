// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../usb/usb_bed.hpp"
#include "device/falcon/model_falcon.hpp"
#include "falcon_bench.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tp::mock {

/// A Falcon on the USB with the model Falcon behind its endpoints, whose milliseconds are those of the
/// machine: its serial bridge sends packets without being asked.
class UsbFalconBed final : public UsbBed {
public:
    struct Seen : UsbBed::Seen {
        falcon::Command command; ///< that the Falcon obeys
        int loads_begun = 0;
        bool firmware_runs = false;
    };

    bool plug_in(const std::string& serial = "FTFALCON", bool bulk = true) {
        serial_ = serial;
        return appear({"0403", "cb48", "0400", "Novint", "Falcon", serial_.c_str(), descriptors(bulk)});
    }
    Seen seen() {
        const std::lock_guard lock(mutex_);
        return {seen_, model_.command(), model_.loads_begun(), model_.firmware_runs()};
    }
    /// Does something with the model while nothing else does.
    template <typename What>
    void with_model(What what) {
        const std::lock_guard lock(mutex_);
        what(model_);
    }

private:
    using Clock = std::chrono::steady_clock;

    /// An FTDI bridge at full speed: one interface of its vendor's class with two bulk endpoints.
    static std::vector<std::uint8_t> descriptors(bool bulk) {
        std::vector<std::uint8_t> all = {18,   1,    0x10, 1, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB,
                                         0x00, 0x04, 1,    2, 3, 1, 9, 2, 0,    0,    1,    1,
                                         0,    0x80, 45,   9, 4, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0};
        if (bulk) {
            all.insert(all.end(), {7, 5, 0x81, 2, 64, 0, 0, 7, 5, 0x02, 2, 64, 0, 0});
            all[31] = 2;
        }
        all[20] = static_cast<std::uint8_t>(all.size() - 18);
        return all;
    }

    void hear(std::span<const std::uint8_t> packet) override { model_.send(packet); }
    void obey(std::uint8_t type, std::uint8_t request, std::uint16_t value) override {
        if (type == falcon::ftdi::request_type)
            model_.control({request, value});
    }
    void go_on() override {
        const Clock::time_point now = Clock::now();
        int due =
            static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(now - last_).count());
        if (due > 0)
            last_ = now;
        for (due = std::min(due, 10); due > 0; --due) {
            model_.step();
            UsbPacket packet;
            while (model_.packet(packet)) {
                if (behaviour_.silent || packets_.size() > 64)
                    continue;
                std::vector<std::uint8_t> bytes(
                    packet.bytes.begin(), packet.bytes.begin() + static_cast<std::ptrdiff_t>(packet.size));
                if (behaviour_.other_device)
                    for (std::uint8_t& byte : bytes)
                        byte = static_cast<std::uint8_t>(byte ^ 0x5A);
                if (behaviour_.odd_packets)
                    for (const std::size_t odd : {1u, 0u})
                        packets_.emplace_back(odd, std::uint8_t{0x81});
                packets_.push_back(std::move(bytes));
            }
        }
    }
    bool is_answer(const std::vector<std::uint8_t>& packet) const override {
        return packet.size() > falcon::ftdi::status_size;
    }

    std::string serial_;
    ModelFalcon model_{testing::falcon_image()}; ///< of the mutex
    Clock::time_point last_ = Clock::now();
};

} // namespace tp::mock
