// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/haltable.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A force that went through the safety chain; nothing else can make one, so nothing else can reach a device.
class SafeForce {
public:
    /// No force at all: always safe, and what a device gets on every way out.
    SafeForce() = default;
    /// N, device frame.
    Vec2 newtons() const { return newtons_; }
    /// Share of the wanted force that the chain lets in now, 0 … 1. What a device adds of its own making,
    /// such as a spring on an axis that no law knows of, goes by it: it comes with the ramp, and every fault
    /// and every Escape takes it away.
    double share() const { return share_; }
    /// The same force made smaller, which is safe too; `share` is clamped to 0 … 1, NaN counts as 0.
    SafeForce scaled(double share) const {
        const double part = share > 0.0 ? (share < 1.0 ? share : 1.0) : 0.0;
        return part > 0.0 ? SafeForce(part * newtons_, part * share_) : SafeForce();
    }

private:
    friend class SafetyChain;
    SafeForce(Vec2 newtons, double share) : newtons_(newtons), share_(share) {}
    Vec2 newtons_{0.0};
    double share_ = 0.0;
};

/// What a device can do.
struct Capabilities {
    std::string name;              ///< as a person is told
    std::string serial_number;     ///< keeps its calibration; empty where it has none
    std::vector<Vec2> workspace;   ///< polygon of reachable places, mm, device frame
    double max_force = 0.0;        ///< N, for a moment
    double continuous_force = 0.0; ///< N, for ever
    double resolution = 0.0;       ///< mm, the smallest step of its position
    double rate = 1000.0;          ///< Hz, nominal
    double delay = 0.0;            ///< s, estimate from write to motion and back to read
    bool calibrated = false;       ///< its newtons are newtons
    double damping =
        0.0; ///< N·s/m, of its own mechanics, which holds what sampling and delay leak; 0: unknown
};

/// One reading.
///
/// Its stamp is what makes it fresh: two readings with the same stamp are one reading, however often it is
/// returned. A device with a clock stamps by that clock; a device that only counts its readings stamps when a
/// new count came, and a device that says neither when its report came. A device never stamps a reading that it
/// returns again. What the servo does with stamps that jump or stand still: FreshReadings.
struct DeviceState {
    double time = 0.0;         ///< s, the stamp: when the position was taken, of a clock that begins anywhere
    Vec2 position{0.0};        ///< mm, device frame
    std::uint32_t buttons = 0; ///< bit 0 = the main button
};

/// The port that every force device implements. Called by one thread at a time, `halt` excepted; read and
/// write must not block for longer than a tick (a slow transport keeps a writer thread of its own behind this
/// port).
class ForceDevice : public Haltable {
public:
    virtual ~ForceDevice() = default;
    /// Makes the device ready; its force is zero afterwards.
    virtual Result<Capabilities> open() = 0;
    /// The newest reading at `now`; nothing, or one with the same stamp, where there is no newer one. A device
    /// that reports only changes gives a newer reading of the same place only where something else shows that
    /// it is alive. A lost device says so by lost().
    virtual std::optional<DeviceState> read(double now) noexcept = 0;
    /// False where the force could not be delivered.
    virtual bool write(const SafeForce& force) noexcept = 0;
    /// Takes the force away at once and leaves the device open. Any thread, at any moment, also while a write
    /// of another thread hangs, and from a signal handler: nothing but what is safe there
    /// (signal-safety(7): no lock, no allocation).
    void halt() noexcept override = 0;
    /// Force off, device released. May be called twice.
    virtual void stop() noexcept = 0;
    virtual bool lost() const noexcept { return false; }
    /// It reads, but has switched its motors off by itself; it obeys again once it was given no force and
    /// nothing keeps it from that. The servo's thread.
    virtual bool motors_off() const noexcept { return false; }
    /// A person has put the handle on its mark, and it counts from there. An open device, before anything
    /// ticks: it may wait for an answer.
    virtual Result<bool> home() { return Error{"This device needs no homing."}; }
    /// A device that tells no newtons is taken to be this strong (N of its whole force) and to pull this way (1 or
    /// −1 for each axis) from the next write on, until it is opened again; false where the device knows better.
    /// For measuring it. Any thread.
    virtual bool assume(double /*newtons_at_full*/, Vec2 /*sign*/) noexcept { return false; }
    /// Why it has done so and what to do, for a person; empty where there is nothing to say. Any thread.
    virtual std::string complaint() const { return {}; }
};

} // namespace tp
