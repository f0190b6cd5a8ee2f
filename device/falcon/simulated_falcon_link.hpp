// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/falcon/falcon_link.hpp"
#include "device/falcon/model_falcon.hpp"
#include "device/guard/simulated_guard.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <vector>

namespace tp {

/// What can go wrong on the way between a computer and a Falcon. Shares are 0 … 1 of all packets.
struct FalconTroubles {
    double drop = 0.0;    ///< each way
    double garble = 0.0;  ///< each way: some bytes are others
    double cut = 0.0;     ///< to the computer: packets end early, in their status too
    bool stalled = false; ///< to the computer: packets wait, and come all at once afterwards
    bool mute = false;    ///< nothing comes from the Falcon
    bool deaf = false;    ///< nothing reaches it
    bool unplugged = false;
    bool no_guard = false;
};

/// A cable to a model Falcon, in simulated time, with a delay and knobs for what goes wrong. The model must
/// outlive it.
class SimulatedFalconLink final : public FalconLink {
public:
    /// `delay_ms` is how many milliseconds a packet takes each way.
    explicit SimulatedFalconLink(ModelFalcon& model, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : model_(model), delay_ms_(delay_ms), random_(seed) {}

    /// A millisecond of the Falcon.
    void advance();
    bool control(const falcon::ftdi::Request& request) noexcept override;
    /// A wait passes in simulated time too.
    UsbGot read(UsbPacket& packet, int wait_ms) noexcept override;
    bool write(std::span<const std::uint8_t> bytes) noexcept override;
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const std::uint8_t> no_force) override;

    FalconTroubles troubles;
    GuardDiary diary;                           ///< of its guard
    std::vector<std::uint8_t> guard_takes_away; ///< what its guard would write
    std::function<void()> each_ms = [] {};      ///< what a person does while something waits

private:
    struct ToFalcon {
        std::uint64_t due = 0; ///< ms
        std::vector<std::uint8_t> bytes;
    };
    struct ToComputer {
        std::uint64_t due = 0; ///< ms
        UsbPacket packet;
    };
    bool happens(double share);
    void garble(std::span<std::uint8_t> bytes);

    ModelFalcon& model_;
    unsigned delay_ms_;
    std::mt19937 random_;
    std::uint64_t now_ = 0; ///< ms
    std::deque<ToFalcon> to_falcon_;
    std::deque<ToComputer> to_computer_;
};

} // namespace tp
