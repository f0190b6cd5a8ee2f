// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// The motor that shakes the machine in the hand. One implementation a platform; calls come from the page's thread
/// and never block it.
class Vibration {
public:
    virtual ~Vibration() = default;
    /// Whether there is a motor.
    virtual bool there() const = 0;
    /// One pulse: `strength` 0 … 1, `ms` > 0. Replaces one that is under way.
    virtual void pulse(double strength, int ms) = 0;
    /// Still, now.
    virtual void stop() = 0;
};

/// Of machines without a motor: desktops, and tablets of which Qt does not know one.
class NoVibration final : public Vibration {
public:
    bool there() const override { return false; }
    void pulse(double, int) override {}
    void stop() override {}
};

} // namespace tp
