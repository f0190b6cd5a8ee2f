// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/touch_access.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tp::testing {

/// Where a test plugs outputs for a bare finger in and out, and sees what they were told.
class TouchSocket {
    struct Plugged {
        std::mutex mutex;
        std::vector<ListedTouchOutput> list;
        std::string refusal; ///< of open; empty: it opens
        bool pad = false;
        PadTouch finger; ///< on a pad
        std::vector<Tick> ticks;
        std::atomic<bool> there{false};
        std::atomic<int> open{0};
        std::atomic<int> most_open{0};
        std::atomic<int> halts{0};
        std::mutex closing; ///< a test that holds it keeps outputs from being closed
    };

    class Output final : public TouchOutput {
    public:
        explicit Output(std::shared_ptr<Plugged> plugged) : plugged_(std::move(plugged)) {}
        ~Output() override { stop(); }
        Result<TouchCapabilities> open() override {
            const std::lock_guard lock(plugged_->mutex);
            if (!plugged_->refusal.empty())
                return Error{plugged_->refusal};
            plugged_->most_open = std::max(plugged_->most_open.load(), ++plugged_->open);
            open_ = true;
            TouchCapabilities can;
            can.name = "double";
            can.rate = 1000.0;
            if (plugged_->pad)
                can.pad = Rect{{-20.0, -20.0}, {20.0, 20.0}};
            return can;
        }
        std::optional<PadTouch> read(double now) noexcept override {
            const std::lock_guard lock(plugged_->mutex);
            if (!plugged_->pad)
                return std::nullopt;
            PadTouch touch = plugged_->finger;
            touch.time = now;
            return touch;
        }
        bool resist(double) noexcept override { return true; }
        bool tick(const Tick& tick) noexcept override {
            const std::lock_guard lock(plugged_->mutex);
            plugged_->ticks.push_back(tick);
            return true;
        }
        void halt() noexcept override { ++plugged_->halts; }
        void stop() noexcept override {
            if (!std::exchange(open_, false))
                return;
            const std::lock_guard lock(plugged_->closing);
            --plugged_->open;
        }
        bool lost() const noexcept override { return !plugged_->there; }

    private:
        std::shared_ptr<Plugged> plugged_;
        bool open_ = false;
    };

public:
    static constexpr double delay_s = 0.012; ///< as it says of itself

    TouchAccess access() const {
        TouchAccess access;
        access.list = [plugged = plugged_] {
            const std::lock_guard lock(plugged->mutex);
            return plugged->there ? plugged->list : std::vector<ListedTouchOutput>{};
        };
        access.make = [plugged = plugged_](const std::string&) -> Result<std::unique_ptr<TouchOutput>> {
            return std::unique_ptr<TouchOutput>(std::make_unique<Output>(plugged));
        };
        access.look_every_ms = 20;
        return access;
    }
    void plug_in(bool pad = false, const std::string& refusal = {}) {
        const std::lock_guard lock(plugged_->mutex);
        plugged_->pad = pad;
        plugged_->refusal = refusal;
        plugged_->list = {{"double:1", "test pad", "1", TouchMeans::ticks, pad, delay_s}};
        plugged_->there = true;
    }
    void unplug() { plugged_->there = false; }
    /// The finger lies there on the pad, mm; lifted.
    void finger_at(Vec2 place) {
        const std::lock_guard lock(plugged_->mutex);
        plugged_->finger.touched = true;
        plugged_->finger.place = place;
    }
    void lift() {
        const std::lock_guard lock(plugged_->mutex);
        plugged_->finger.touched = false;
    }
    std::vector<Tick> ticks() const {
        const std::lock_guard lock(plugged_->mutex);
        return plugged_->ticks;
    }
    void forget() {
        const std::lock_guard lock(plugged_->mutex);
        plugged_->ticks.clear();
    }
    /// How many are open.
    int open() const { return plugged_->open; }
    /// How many were at the same time, at most.
    int most_open() const { return plugged_->most_open; }
    /// How often one was told to be still.
    int halts() const { return plugged_->halts; }
    /// As long as this is held, nothing is closed.
    std::unique_lock<std::mutex> hold_closing() { return std::unique_lock(plugged_->closing); }

private:
    std::shared_ptr<Plugged> plugged_ = std::make_shared<Plugged>();
};

} // namespace tp::testing
