// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/faulty_device.hpp"
#include "app/pages/lab/lab_setup.hpp"
#include "app/pages/lab/tick_tap.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/recording/recording_device.hpp"
#include "device/simulated/simulated_device.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tp {

inline constexpr const char* simulated_device_name = "simulated";

/// An open device with what stands between it and the servo: faults (in front of the simulated device only), a recorder
/// where one is wanted, and a tap for the plots.
class DeviceChain {
public:
    struct Wish {
        std::string device = simulated_device_name; ///< as list_devices names it
        std::filesystem::path recording;            ///< a new file; empty: none
    };
    /// May wait for a real device; any thread. `clock` must outlive it. An error is the device's own sentence.
    static Result<std::shared_ptr<DeviceChain>> open(const Wish& wish, const SurfaceSize& surface,
                                                     const LabParameters& parameters, Clock& clock);

    ForceDevice& front() { return *tap_; }
    const Capabilities& capabilities() const { return capabilities_; }
    /// Null where the device is a real one.
    SimulatedDevice* simulated() { return simulated_; }
    FaultyDevice* faults() { return faulty_.get(); }
    RecordingDevice* recorder() { return recorder_.get(); }
    std::vector<TickSample> take() { return tap_->take(); }

private:
    std::unique_ptr<ForceDevice> base_;
    SimulatedDevice* simulated_ = nullptr; ///< base_
    std::unique_ptr<FaultyDevice> faulty_;
    std::unique_ptr<RecordingDevice> recorder_;
    std::unique_ptr<TickTap> tap_;
    Capabilities capabilities_;
};

/// The loop that serves a device, engaged from its first tick to its last. Called from the page's thread only.
class LabServo {
public:
    /// Runs from now on; a strongest force above `parameters` allows nothing more. With a virtual clock nothing ticks
    /// but by `run_for`.
    LabServo(std::shared_ptr<DeviceChain> chain, std::unique_ptr<HapticScene> scene, const LabParameters& parameters,
             Clock& clock, bool virtual_time);
    ~LabServo();
    LabServo(const LabServo&) = delete;
    LabServo& operator=(const LabServo&) = delete;

    void render(std::unique_ptr<HapticScene> scene) { loop_.render(std::move(scene)); }
    /// What can change while it runs: the strongest force and the faults.
    void tell(const LabParameters& parameters);
    /// Ticks for so long in virtual time, at most 16 s.
    void run_for(double seconds);

    ServoSnapshot snapshot() const { return loop_.snapshot(); }
    DeviceChain& chain() { return *chain_; }

private:
    std::shared_ptr<DeviceChain> chain_;
    Clock& clock_;
    double period_;
    ServoLoop loop_;
};

} // namespace tp
