// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/device_access.hpp"
#include "core/servo/force_device.hpp"
#include "device/registry.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp::testing {

/// A force device that a test plugs in and pulls out, and whose handle it holds, while a page uses it on threads of its
/// own. All of it may be asked at any moment.
class DeviceSocket {
public:
    static constexpr const char* serial_number = "TPC-0042";

    void plug_in() { state_->plugged = true; }
    void unplug() { state_->plugged = false; }
    /// The handle is there now, mm in the device's frame.
    void hold_at(Vec2 place) {
        const std::lock_guard lock(state_->mutex);
        state_->place = place;
    }
    /// How far it reaches to each side of (0, 100) mm, in its frame.
    void reach(Vec2 half) {
        const std::lock_guard lock(state_->mutex);
        state_->half_reach = half;
    }
    /// It cannot be opened, and says so; empty: it can.
    void refuse(std::string sentence) {
        const std::lock_guard lock(state_->mutex);
        state_->refusal = std::move(sentence);
    }
    /// Its own motors are off for that reason; empty: they are not.
    void switch_motors_off(std::string why) {
        const std::lock_guard lock(state_->mutex);
        state_->complaint = std::move(why);
    }
    /// It is a force stick now, so strong (N of its whole force) and with such signs, whose grip stands free.
    void be_a_joystick(double newtons_at_full, Vec2 sign) {
        const std::lock_guard lock(state_->mutex);
        state_->newtons_at_full = newtons_at_full;
        state_->sign = sign;
        state_->stick = state_->free = true;
    }
    /// A hand holds the stick's grip where it is.
    void hold() { state_->free = false; }
    /// It was told that its handle stands on the mark.
    bool homed() const { return state_->homed; }
    /// N, what is on its handle now.
    Vec2 force() const {
        const std::lock_guard lock(state_->mutex);
        return state_->force;
    }
    /// N, the strongest that ever was.
    double strongest() const {
        const std::lock_guard lock(state_->mutex);
        return state_->strongest;
    }
    /// How often somebody looked; one look ends before the next begins.
    int looks() const { return state_->looks; }
    int opened() const { return state_->opened; }
    int tried() const { return state_->tried; }
    /// Opened and not given back.
    bool in_use() const { return state_->in_use; }

    DeviceAccess access() const {
        DeviceAccess access;
        access.look_every_ms = 5;
        access.list = [state = state_] {
            ++state->looks;
            std::vector<ListedDevice> there{{"simulated", "the mouse", "", ""}};
            if (state->plugged && state->stick)
                there.push_back({std::string("stick:") + serial_number, "a stick", serial_number, "hid", false, serial_number});
            else if (state->plugged)
                there.push_back({std::string("pad:") + serial_number, "force pad", serial_number, "hid"});
            return there;
        };
        access.make = [state = state_](const std::string&) -> Result<std::unique_ptr<ForceDevice>> {
            return std::unique_ptr<ForceDevice>(std::make_unique<Device>(state));
        };
        return access;
    }

private:
    struct State {
        mutable std::mutex mutex; ///< of what follows
        Vec2 place{0.0};
        Vec2 force{0.0};
        double strongest = 0.0;
        double newtons_at_full = 0.0;
        Vec2 half_reach{100.0, 75.0};
        Vec2 sign{1.0};
        std::string refusal;
        std::string complaint;
        std::atomic<bool> plugged{false};
        std::atomic<bool> stick{false};
        std::atomic<bool> free{false};
        std::atomic<bool> in_use{false};
        std::atomic<bool> homed{false};
        std::atomic<int> looks{0};
        std::atomic<int> opened{0};
        std::atomic<int> tried{0};
    };
    class Device final : public ForceDevice {
    public:
        explicit Device(std::shared_ptr<State> state) : state_(std::move(state)) {}
        ~Device() override { stop(); }
        Result<Capabilities> open() override {
            const std::lock_guard lock(state_->mutex);
            ++state_->tried;
            if (!state_->refusal.empty())
                return Error{state_->refusal};
            ++state_->opened;
            state_->in_use = true;
            open_ = true;
            Capabilities can;
            can.name = "double";
            can.serial_number = serial_number;
            const Vec2 far = state_->half_reach;
            for (const Vec2 side : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
                can.workspace.push_back(Vec2(0, 100) + side * far);
            can.max_force = 3.0;
            return can;
        }
        std::optional<DeviceState> read(double now) noexcept override {
            if (lost_ || !state_->plugged) {
                lost_ = true;
                return std::nullopt;
            }
            const std::lock_guard lock(state_->mutex);
            return DeviceState{now, state_->place, 0};
        }
        bool write(const SafeForce& force) noexcept override {
            const std::lock_guard lock(state_->mutex);
            if (lost_ || !state_->plugged) {
                state_->force = Vec2(0.0); // there is no motor any more
                return false;
            }
            state_->force = state_->stick ? state_->newtons_at_full / assumed_ * state_->sign * assumed_sign_ * force.newtons()
                                          : force.newtons();
            state_->strongest = std::max(state_->strongest, length(state_->force));
            if (constexpr double friction_n = 0.3; state_->free && length(state_->force) > friction_n)
                state_->place += 0.03 * state_->force; // mm in a tick
            return true;
        }
        void halt() noexcept override {}
        Result<bool> home() override {
            if (!state_->plugged)
                return Error{"The force pad could not be homed. Check that it is plugged in, and try again."};
            state_->homed = true;
            return true;
        }
        void stop() noexcept override {
            if (!open_)
                return;
            open_ = false;
            const std::lock_guard lock(state_->mutex);
            state_->force = Vec2(0.0);
            state_->in_use = false;
        }
        bool assume(double newtons_at_full, Vec2 sign) noexcept override {
            const std::lock_guard lock(state_->mutex);
            assumed_ = newtons_at_full;
            assumed_sign_ = sign;
            return state_->stick;
        }
        bool lost() const noexcept override { return lost_; }
        bool motors_off() const noexcept override {
            const std::lock_guard lock(state_->mutex);
            return !state_->complaint.empty();
        }
        std::string complaint() const override {
            const std::lock_guard lock(state_->mutex);
            return state_->complaint;
        }

    private:
        std::shared_ptr<State> state_;
        std::atomic<bool> lost_{false}; ///< for good: what is plugged in again is opened again
        bool open_ = false;
        double assumed_ = 60.0;
        Vec2 assumed_sign_{-1.0, -1.0};
    };

    std::shared_ptr<State> state_ = std::make_shared<State>();
};

} // namespace tp::testing
