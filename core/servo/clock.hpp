// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Time as the servo knows it: seconds since any fixed moment, never going back.
class Clock {
public:
    virtual ~Clock() = default;
    virtual double now() noexcept = 0;
    /// Returns at `time` or soon after; at once when it has passed.
    virtual void sleep_until(double time) noexcept = 0;
};

/// The machine's monotonic clock.
class SteadyClock final : public Clock {
public:
    double now() noexcept override;
    void sleep_until(double time) noexcept override;
};

/// Simulated time: sleeping moves it on, nothing waits. For tests, tracing and the simulated participant;
/// used by one thread.
class VirtualClock final : public Clock {
public:
    double now() noexcept override { return now_; }
    void sleep_until(double time) noexcept override {
        if (time > now_)
            now_ = time;
    }

private:
    double now_ = 0.0;
};

} // namespace tp
