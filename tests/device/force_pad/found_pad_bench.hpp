// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../usb/wire_bench.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/found_pad.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tp {

/// Waits a millisecond where it is told to wait longer: what never gives the right answer is asked as often, and sooner
/// done with.
class ImpatientTransport final : public ReportTransport {
public:
    explicit ImpatientTransport(std::unique_ptr<ReportTransport> real) : real_(std::move(real)) {}
    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        return real_->read(frame, std::min(wait_ms, 1));
    }
    bool write(const pad::Frame& frame) noexcept override { return real_->write(frame); }

private:
    std::unique_ptr<ReportTransport> real_;
};

/// The mocks' pad makes a step for each frame that it is sent, whatever the clock says: its states get the clock of the
/// bench, as those of a pad that lives by itself have.
class ClockedTransport final : public ReportTransport {
public:
    ClockedTransport(std::unique_ptr<ReportTransport> real, Clock& clock)
        : real_(std::move(real)), clock_(clock) {}
    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        const Got got = real_->read(frame, wait_ms);
        pad::StateFrame state;
        if (got == Got::report && pad::decode(frame, state)) {
            state.time_us = static_cast<std::uint32_t>(std::llround(1e6 * clock_.now()));
            frame = pad::encode(state);
        }
        return got;
    }
    bool write(const pad::Frame& frame) noexcept override { return real_->write(frame); }

private:
    std::unique_ptr<ReportTransport> real_;
    Clock& clock_;
};

/// The only pad that is found, behind its real transport.
struct FoundPadBench : testing::WireBench<ForcePad> {
    using Opened = Result<std::unique_ptr<ReportTransport>>;

    FoundPadBench(const std::vector<FoundPad>& found, Opened (*open)(const FoundPad&),
                  std::function<long()> answered_now, bool patient = true)
        : WireBench(std::move(answered_now)) {
        if (found.size() == 1)
            begin(std::make_unique<ForcePad>([this, open, patient, pad = found.front()]() -> Opened {
                Opened opened = open(pad);
                if (!opened.ok())
                    return opened;
                std::unique_ptr<ReportTransport> transport = std::move(opened).value();
                if (!patient)
                    transport = std::make_unique<ImpatientTransport>(std::move(transport));
                return std::unique_ptr<ReportTransport>(
                    std::make_unique<ClockedTransport>(std::move(transport), clock));
            }));
        else
            error = "found " + std::to_string(found.size());
    }
    /// Until a pad that has fallen silent is stale and its force let go; how many ticks that took since the last of its
    /// frames, which may have been on its way.
    int ticks_until_let_go() {
        int ticks = 0;
        for (ServoSnapshot seen; seen.fault != Fault::stale_input || seen.force() != Vec2(0.0); seen = loop->snapshot()) {
            const long before = answered();
            tick(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ticks = answered() == before ? ticks + 1 : 0;
        }
        return ticks;
    }
};

} // namespace tp
