// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/pid_reports.hpp"

#include <cmath>

namespace tp::hid {

namespace {

constexpr double degrees_x = 90.0; ///< east
constexpr double degrees_y = 0.0;  ///< north

/// A report that is being filled.
class Filler {
public:
    explicit Filler(const ReportShape& shape) {
        report_.bytes[0] = shape.id;
        report_.size = 1 + shape.bytes;
    }
    Filler& put(const Slot& slot, std::int64_t value) {
        if (slot.there())
            put_value(behind_id(), slot, value);
        return *this;
    }
    Filler& put(const Choice& choice) { return put(choice.slot, choice.value); }
    Filler& put_ones(const Slot& slot) {
        put_bits(behind_id(), slot, ~std::uint64_t{0});
        return *this;
    }
    const Report& report() const { return report_; }

private:
    std::span<std::uint8_t> behind_id() { return std::span(report_.bytes).subspan(1, report_.size - 1); }
    Report report_;
};

std::int64_t angle_in(const Slot& slot, double degrees) {
    return slot.least + std::llround(degrees / 360.0 * static_cast<double>(slot.most - slot.least));
}

/// The bytes behind the id, where the report is of this shape and whole; else none.
std::span<const std::uint8_t> behind_id_of(const ReportShape& shape, bool id_leads,
                                           std::span<const std::uint8_t> report) {
    if (id_leads) {
        if (report.empty() || report[0] != shape.id)
            return {};
        report = report.subspan(1);
    }
    return shape.there() && report.size() >= shape.bytes ? report.first(shape.bytes)
                                                         : std::span<const std::uint8_t>{};
}

double share_of(std::int64_t value, const Slot& slot) {
    const double middle = 0.5 * static_cast<double>(slot.least + slot.most);
    const double half = 0.5 * static_cast<double>(slot.most - slot.least);
    return (static_cast<double>(value) - middle) / half;
}

} // namespace

Report create_report(const PidLayout& layout) {
    return Filler(layout.create.report).put(layout.create.constant_force).report();
}

Report asking_for(const ReportShape& shape) { return Filler(shape).report(); }

Report effect_report(const PidLayout& layout, std::uint8_t block, Along along) {
    const PidLayout::SetEffect& effect = layout.effect;
    Filler filler(effect.report);
    filler.put(effect.block, block)
        .put(effect.constant_force)
        .put_ones(effect.duration)
        .put(effect.gain, effect.gain.most);
    if (effect.direction[0].there()) {
        filler.put(effect.axis_enable[0], 1).put(effect.axis_enable[1], 1).put(effect.direction_enable, 1);
        filler.put(effect.direction[0],
                   angle_in(effect.direction[0], along == Along::x ? degrees_x : degrees_y));
    } else {
        filler.put(effect.axis_enable[along == Along::x ? 0 : 1], 1);
    }
    return filler.report();
}

Report force_report(const PidLayout& layout, std::uint8_t block, int share) {
    const PidLayout::ConstantForce& force = layout.force;
    return Filler(force.report)
        .put(force.block, block)
        .put(force.magnitude, std::int64_t{share} * force.magnitude.most / full_share)
        .report();
}

Report start_report(const PidLayout& layout, std::uint8_t block) {
    const PidLayout::Operation& operation = layout.operation;
    return Filler(operation.report)
        .put(operation.block, block)
        .put(operation.start)
        .put(operation.loops, 1)
        .report();
}

Report stop_report(const PidLayout& layout, std::uint8_t block) {
    const PidLayout::Operation& operation = layout.operation;
    return Filler(operation.report).put(operation.block, block).put(operation.stop).report();
}

Report free_report(const PidLayout& layout, std::uint8_t block) {
    return Filler(layout.free.report).put(layout.free.block, block).report();
}

Report control_report(const PidLayout& layout, const Choice& what) {
    return Filler(layout.control.report).put(what).report();
}

Report full_gain_report(const PidLayout& layout) {
    return Filler(layout.gain.report).put(layout.gain.gain, layout.gain.gain.most).report();
}

LoadedBlock loaded_block(const PidLayout& layout, std::span<const std::uint8_t> report) {
    const PidLayout::BlockLoad& load = layout.block_load;
    const std::span<const std::uint8_t> bytes = behind_id_of(load.report, true, report);
    LoadedBlock loaded;
    const auto says = [&bytes](const Choice& choice) {
        return choice.there() && !bytes.empty() && value_in(bytes, choice.slot) == choice.value;
    };
    const std::int64_t block = value_in(bytes, load.block);
    if (says(load.success) && block > 0 && block <= 255)
        return {LoadedBlock::Status::success, static_cast<std::uint8_t>(block)};
    if (says(load.full))
        loaded.status = LoadedBlock::Status::full;
    return loaded;
}

JoystickNews joystick_news(const PidLayout& layout, std::span<const std::uint8_t> report) {
    JoystickNews news;
    if (const auto bytes = behind_id_of(layout.stick.report, layout.numbered, report); !bytes.empty()) {
        Vec2 axes(share_of(value_in(bytes, layout.stick.axis[0]), layout.stick.axis[0]),
                  share_of(value_in(bytes, layout.stick.axis[1]), layout.stick.axis[1]));
        news.axes = glm::clamp(axes, Vec2(-1.0), Vec2(1.0));
        for (std::size_t i = 0; i < layout.stick.buttons.size(); ++i)
            if (value_in(bytes, layout.stick.buttons[i]) != 0)
                news.buttons |= 1u << i;
    }
    if (const auto bytes = behind_id_of(layout.state.report, layout.numbered, report); !bytes.empty()) {
        const auto says = [&bytes](const Slot& slot, bool otherwise) {
            return slot.there() ? value_in(bytes, slot) != 0 : otherwise;
        };
        news.safety_switch_off = !says(layout.state.safety_switch, true);
        news.motors_on = says(layout.state.actuators_enabled, true) && !says(layout.state.paused, false) &&
                         says(layout.state.actuator_power, true) && !news.safety_switch_off;
    }
    return news;
}

} // namespace tp::hid
