// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_servo.hpp"

#include "device/registry.hpp"

#include <cmath>
#include <utility>

namespace tp {

Result<std::shared_ptr<DeviceChain>> DeviceChain::open(const Wish& wish, const SurfaceSize& surface,
                                                       const LabParameters& parameters, Clock& clock) {
    auto chain = std::make_shared<DeviceChain>();
    if (wish.device == simulated_device_name) {
        auto simulated = std::make_unique<SimulatedDevice>(surface.width_mm, surface.height_mm, plant_of(parameters));
        chain->simulated_ = simulated.get();
        chain->base_ = std::move(simulated);
        chain->faulty_ = std::make_unique<FaultyDevice>(*chain->base_, clock);
    } else {
        Result<std::unique_ptr<ForceDevice>> made = device_named(wish.device);
        if (!made)
            return Error{made.error()};
        chain->base_ = std::move(made).value();
    }
    ForceDevice* behind = chain->faulty_ ? static_cast<ForceDevice*>(chain->faulty_.get()) : chain->base_.get();
    if (!wish.recording.empty()) {
        chain->recorder_ = std::make_unique<RecordingDevice>(*behind, wish.recording);
        behind = chain->recorder_.get();
    }
    chain->tap_ = std::make_unique<TickTap>(*behind);
    Result<Capabilities> can = chain->tap_->open();
    if (!can)
        return Error{can.error()};
    chain->capabilities_ = std::move(can).value();
    return chain;
}

LabServo::LabServo(std::shared_ptr<DeviceChain> chain, std::unique_ptr<HapticScene> scene,
                   const LabParameters& parameters, Clock& clock, bool virtual_time)
    : chain_(std::move(chain)), clock_(clock), period_(1.0 / chain_->capabilities().rate),
      loop_(chain_->front(), chain_->capabilities(), clock,
            servo_settings(parameters, chain_->capabilities().rate, chain_->simulated() == nullptr)) {
    tell(parameters);
    loop_.render(std::move(scene));
    loop_.engage();
    if (!virtual_time)
        loop_.start();
}

LabServo::~LabServo() {
    loop_.stop();
    if (chain_->recorder() != nullptr)
        chain_->recorder()->flush();
}

void LabServo::tell(const LabParameters& parameters) {
    loop_.set_max_force(parameters.max_force);
    FaultyDevice* faults = chain_->faults();
    if (faults == nullptr)
        return;
    faults->drop = parameters.drop;
    faults->silent = parameters.silent;
    faults->refuses = parameters.refuses;
    faults->its_motors_off = parameters.motors_off;
    faults->unplugged = parameters.unplugged;
}

void LabServo::run_for(double seconds) {
    const auto ticks = std::lround(seconds / period_);
    for (long i = 0; i < ticks; ++i) {
        loop_.tick();
        clock_.sleep_until(clock_.now() + period_);
    }
}

} // namespace tp
