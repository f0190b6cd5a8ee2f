// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device_under_test.hpp"

#include <QObject>
#include <QString>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace tp::testing {

/// The judge of every device's closed loop: whatever happens, no force beyond the limits, none that comes without
/// the ramp, and for every force that goes a reason. A device's own test derives from it, gives its table and
/// adds what no other device has.
class ClosedLoopTest : public QObject {
    Q_OBJECT
public:
    explicit ClosedLoopTest(DeviceUnderTest device) : device_(std::move(device)) {}

protected:
    /// A firm hand that the device has been pulling towards a line for a second.
    std::unique_ptr<LoopBench> held_above_a_line(std::size_t variant = 0) const;
    /// The same, as what it is.
    template <typename Bench>
    std::unique_ptr<Bench> held(std::size_t variant = 0) const {
        return std::unique_ptr<Bench>(dynamic_cast<Bench*>(held_above_a_line(variant).release()));
    }

private slots:
    void a_released_handle_settles_on_the_line_data() { each_variant(); }
    void a_released_handle_settles_on_the_line();
    void a_hand_is_led_across_from_line_to_line_within_all_limits_data() { each_variant(); }
    void a_hand_is_led_across_from_line_to_line_within_all_limits();
    void unplugged_in_mid_touch_a_reason_is_said_and_nothing_comes_back_by_itself_data() { each_variant(); }
    void unplugged_in_mid_touch_a_reason_is_said_and_nothing_comes_back_by_itself();
    void when_the_servo_stands_still_a_device_with_a_watchdog_lets_go_data() { each_variant(); }
    void when_the_servo_stands_still_a_device_with_a_watchdog_lets_go();
    void every_way_out_leaves_no_force_data() { each_variant(); }
    void every_way_out_leaves_no_force();
    void what_takes_the_force_away_is_told_and_it_comes_back_by_the_ramp_or_not_at_all_data();
    void what_takes_the_force_away_is_told_and_it_comes_back_by_the_ramp_or_not_at_all();
    void readings_that_are_no_newer_take_the_force_away_data() { each_variant_and(stale_stamps()); }
    void readings_that_are_no_newer_take_the_force_away();
    void a_clock_that_jumps_is_not_felt_data() { each_variant_and(survived_stamps()); }
    void a_clock_that_jumps_is_not_felt();
    void random_troubles_never_hurt_data();
    void random_troubles_never_hurt();

private:
    void each_variant() const;
    void each_variant_and(const std::vector<StampTrouble>& troubles) const;
    /// The person has, and what pulls is what motors that are on leave at the most.
    bool let_go(const LoopBench& bench) const;
    QString settles(std::size_t variant, const Handle& handle, unsigned delay_ms, double start) const;
    /// `variant` of those that are not tried in turn.
    QString schedule(std::size_t variant, int number) const;

    DeviceUnderTest device_;
};

} // namespace tp::testing
