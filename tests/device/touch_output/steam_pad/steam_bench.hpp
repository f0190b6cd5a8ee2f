// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/steam_pad/simulated_steam_link.hpp"
#include "device/touch_output/steam_pad/steam_pad.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp::testing {

/// Lets a transport that a test keeps be opened, and counts those who have it open.
class BorrowedSteamLink final : public SteamTransport {
public:
    BorrowedSteamLink(SteamTransport& lent, std::shared_ptr<int> users)
        : lent_(lent), users_(std::move(users)) {
        ++*users_;
    }
    ~BorrowedSteamLink() override { --*users_; }
    BorrowedSteamLink(const BorrowedSteamLink&) = delete;
    BorrowedSteamLink& operator=(const BorrowedSteamLink&) = delete;
    steam::Kind kind() const override { return lent_.kind(); }
    Got read(Input& report, int wait_ms) noexcept override { return lent_.read(report, wait_ms); }
    bool send(const steam::Feature& report) noexcept override { return lent_.send(report); }

private:
    SteamTransport& lent_;
    std::shared_ptr<int> users_;
};

inline SteamPad::Opener lend(SteamTransport& transport,
                             std::shared_ptr<int> users = std::make_shared<int>(0)) {
    return [&transport, users]() -> Result<std::unique_ptr<SteamTransport>> {
        return std::unique_ptr<SteamTransport>(std::make_unique<BorrowedSteamLink>(transport, users));
    };
}

/// Model pads on a simulated cable and their back end, in simulated time.
struct SteamBench {
    ModelSteamPad model;
    SimulatedSteamLink link;
    std::shared_ptr<int> users = std::make_shared<int>(0); ///< who have it open
    SteamPad pad;
    double now = 0.0; ///< s
    bool writer_stalled = false;
    std::optional<PadTouch> touch; ///< the newest reading
    TouchCapabilities can;
    std::string error;

    explicit SteamBench(steam::Kind kind = steam::Kind::deck, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : model(kind), link(model, delay_ms, seed),
          pad({lend(link, users)}, "SD-0001", LatestWriter::Thread::caller) {
        Result<TouchCapabilities> opened = pad.open();
        if (opened.ok())
            can = opened.value();
        error = opened.error();
    }
    void put_finger(Vec2 place) { model.touch(steam::Side::left, place); }
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
        for (double end = now + seconds; now < end;)
            tick();
    }
    bool harmless() const { return model.longest_ms() <= 50.001; }
    bool listens() const { return model.on(); }
    bool let_go() const { return model.imitates(); } // a mouse again, as it was found
    double felt() const { return std::max(model.felt(steam::Side::left), model.felt(steam::Side::right)); }
};

} // namespace tp::testing
