// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../hid_node.hpp"
#include "joystick_bench.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <thread>
#include <unistd.h>
#include <vector>

namespace tp::mock {

/// A force stick made by umockdev, with the model stick behind its node.
class JoystickBed final : public ListeningNode {
public:
    explicit JoystickBed(const JoystickWire& wire = plain_controller(),
                         std::span<const std::uint8_t> other_descriptor = {}, const HandlePlant& plant = {})
        : ListeningNode(
              {"force stick", "FS-0001", other_descriptor.empty() ? wire.descriptor : other_descriptor,
               "045e", "001b"},
              [this](gulong request, std::span<std::uint8_t> data) { return answer(request, data); }),
          model_(wire, plant) {
        model_.place_grip({10.0, 3.0});
    }
    ~JoystickBed() override { end(); }

    /// Forces from the computer that were taken.
    long taken() const { return taken_.load(); }
    std::size_t effects() {
        const std::lock_guard lock(mutex_);
        return model_.effects();
    }
    Vec2 force() {
        const std::lock_guard lock(mutex_);
        return model_.force();
    }
    bool motors_on() {
        const std::lock_guard lock(mutex_);
        return model_.motors_on();
    }
    /// Reports of commands to the whole device that were taken.
    long commands() const { return commands_.load(); }

private:
    int answer(gulong request, std::span<std::uint8_t> data) {
        constexpr unsigned set_feature = 0x06;
        constexpr unsigned get_feature = 0x07;
        constexpr unsigned get_input = 0x0A;
        // On a bus a request comes after what was written before it; here they go different ways. The
        // gain is the last that is written, after commands, before an effect is asked for.
        while (_IOC_NR(request) == set_feature && !gain_taken_.load() && !ends())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const std::lock_guard lock(mutex_);
        std::vector<std::uint8_t> told;
        if (_IOC_NR(request) == set_feature)
            return model_.set_feature(data) ? static_cast<int>(data.size()) : -1;
        if (_IOC_NR(request) == get_feature && !model_.get_feature(data[0], told))
            return -1;
        if (_IOC_NR(request) == get_input && data[0] == model_.wire().axes)
            told = model_.axes_report();
        if (told.empty())
            return usual_answer(request, data);
        std::copy_n(told.begin(), std::min(told.size(), data.size()), data.begin());
        return static_cast<int>(std::min(told.size(), data.size()));
    }
    std::size_t report_bytes(std::uint8_t id) const override {
        const JoystickWire& wire = model_.wire();
        return id == wire.set_effect                               ? 1 + wire.effect_bytes
               : id == wire.constant_force || id == wire.operation ? 4
                                                                   : 2;
    }
    void take(const std::vector<std::uint8_t>& report) override {
        std::vector<std::uint8_t> told;
        {
            const std::lock_guard lock(mutex_);
            model_.receive(report);
            model_.step();
            while (model_.report(told)) {
            }
        }
        if (!told.empty() && ::write(file(), told.data(), told.size()) != static_cast<ssize_t>(told.size()))
            return;
        constexpr std::uint8_t gain = 0x0D;
        if (report[0] == gain)
            gain_taken_.store(true);
        if (report[0] == model_.wire().control) {
            gain_taken_.store(false);
            commands_.fetch_add(1);
        }
        if (report[0] == model_.wire().constant_force)
            taken_.fetch_add(1);
    }

    std::atomic<bool> gain_taken_{false};
    std::atomic<long> taken_{0};
    std::atomic<long> commands_{0};
    std::mutex mutex_; ///< of the model
    ModelJoystick model_;
};

} // namespace tp::mock
