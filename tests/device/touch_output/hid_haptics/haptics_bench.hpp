// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/haptic_pad.hpp"
#include "device/touch_output/hid_haptics/simulated_haptics_link.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp::testing {

/// Lets a transport that a test keeps be opened, and counts those who have it open.
class BorrowedHapticsLink final : public HapticsTransport {
public:
    BorrowedHapticsLink(HapticsTransport& lent, int& users) : lent_(lent), users_(users) { ++users_; }
    ~BorrowedHapticsLink() override { --users_; }
    BorrowedHapticsLink(const BorrowedHapticsLink&) = delete;
    BorrowedHapticsLink& operator=(const BorrowedHapticsLink&) = delete;
    std::vector<std::uint8_t> descriptor() override { return lent_.descriptor(); }
    std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t bytes) override {
        return lent_.feature(id, bytes);
    }
    Got read(Input& report, int wait_ms) noexcept override { return lent_.read(report, wait_ms); }
    bool send(const haptics::Output& report) noexcept override { return lent_.send(report); }

private:
    HapticsTransport& lent_;
    int& users_;
};

inline HapticPad::Opener lend(HapticsTransport& transport, int& users) {
    return [&transport, &users]() -> Result<std::unique_ptr<HapticsTransport>> {
        return std::unique_ptr<HapticsTransport>(std::make_unique<BorrowedHapticsLink>(transport, users));
    };
}

/// A model pad on a simulated cable and its back end, in simulated time; not yet open.
struct HapticsBench {
    ModelHapticPad model;
    SimulatedHapticsLink link;
    int users = 0; ///< who have it open
    HapticPad pad;
    double now = 0.0; ///< s
    bool writer_stalled = false;
    std::optional<PadTouch> touch; ///< the newest reading
    TouchCapabilities can;

    explicit HapticsBench(unsigned delay_ms = 0, std::uint32_t seed = 1)
        : link(model, delay_ms, seed),
          pad(lend(link, users), {"model pad", "HP-0001"}, LatestWriter::Thread::caller) {}
    /// What it says where it cannot be opened.
    std::string open() {
        Result<TouchCapabilities> opened = pad.open();
        if (opened.ok())
            can = opened.value();
        return opened.error();
    }
    void put_finger(Vec2 place) { model.touch(0, place); }
    /// A millisecond.
    void tick() {
        now += 0.001;
        link.advance();
        if (const std::optional<PadTouch> read = pad.read(now))
            touch = read;
        if (!writer_stalled)
            pad.deliver();
    }
    void run(double seconds) {
        for (const double end = now + seconds; now < end;)
            tick();
    }
    double felt() const { return model.felt(); }
    bool harmless() const { return model.waveform() != 0x1004; } // the one that goes on and on
    bool listens() const { return true; }
    bool let_go() const { return true; }
};

} // namespace tp::testing
