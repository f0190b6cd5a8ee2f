// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/pid_layout.hpp"

#include "device/hid/field_slot.hpp"

#include <algorithm>

namespace tp::hid {

namespace {

constexpr std::uint32_t desktop(std::uint32_t id) { return usage_of(0x01, id); }
constexpr std::uint32_t physical(std::uint32_t id) { return usage_of(0x0F, id); }
constexpr std::uint32_t button(std::uint32_t id) { return usage_of(0x09, id); }

constexpr std::uint32_t axis_x = desktop(0x30);
constexpr std::uint32_t axis_y = desktop(0x31);

// Reports (PID 1.0, table 2).
constexpr std::uint32_t set_effect = physical(0x21);
constexpr std::uint32_t axes_enable = physical(0x55);
constexpr std::uint32_t direction = physical(0x57);
constexpr std::uint32_t set_constant_force = physical(0x73);
constexpr std::uint32_t effect_operation = physical(0x77);
constexpr std::uint32_t device_gain_report = physical(0x7D);
constexpr std::uint32_t block_load = physical(0x89);
constexpr std::uint32_t block_free = physical(0x90);
constexpr std::uint32_t state_report = physical(0x92);
constexpr std::uint32_t create_new_effect = physical(0xAB);

// Values.
constexpr std::uint32_t block_index = physical(0x22);
constexpr std::uint32_t constant_force = physical(0x26);
constexpr std::uint32_t duration = physical(0x50);
constexpr std::uint32_t effect_gain = physical(0x52);
constexpr std::uint32_t direction_enable = physical(0x56);
constexpr std::uint32_t magnitude = physical(0x70);
constexpr std::uint32_t operation_start = physical(0x79);
constexpr std::uint32_t operation_stop = physical(0x7B);
constexpr std::uint32_t loop_count = physical(0x7C);
constexpr std::uint32_t device_gain = physical(0x7E);
constexpr std::uint32_t load_success = physical(0x8C);
constexpr std::uint32_t load_full = physical(0x8D);
constexpr std::uint32_t enable_actuators = physical(0x97);
constexpr std::uint32_t disable_actuators = physical(0x98);
constexpr std::uint32_t stop_all_effects = physical(0x99);
constexpr std::uint32_t device_reset = physical(0x9A);
constexpr std::uint32_t device_paused = physical(0x9F);
constexpr std::uint32_t actuators_enabled = physical(0xA0);
constexpr std::uint32_t safety_switch = physical(0xA4);
constexpr std::uint32_t actuator_power = physical(0xA6);

/// Finds the values of one report: the first field of it decides which report it is.
class ReportFinder {
public:
    ReportFinder(const ReportDescriptor& descriptor, ReportKind kind, std::uint32_t report_usage)
        : descriptor_(descriptor), kind_(kind), report_usage_(report_usage) {}

    /// The value of that usage, in a collection of the usage `inside` where one is given.
    Slot value(std::uint32_t usage, std::uint32_t inside = 0) {
        for (const Field& field : descriptor_.fields) {
            if (!may_be(field, inside) || field.array)
                continue;
            const std::int64_t index = field.index_of(usage);
            if (index >= 0)
                return found(field, static_cast<std::uint32_t>(std::min<std::int64_t>(index, field.count)));
        }
        return {};
    }

    Choice choice(std::uint32_t usage) {
        for (const Field& field : descriptor_.fields) {
            const std::int64_t index = may_be(field, 0) ? field.index_of(usage) : -1;
            if (index < 0)
                continue;
            if (!field.array)
                return {found(field, static_cast<std::uint32_t>(std::min<std::int64_t>(index, field.count))),
                        1};
            const Slot slot = found(field, 0);
            const std::int64_t number = field.logical_min + index;
            if (slot.there() && number >= slot.least && number <= slot.most)
                return {slot, number};
        }
        return {};
    }

    /// The first two values inside a collection of that usage, whatever they are called.
    std::array<Slot, 2> pair(std::uint32_t inside) {
        std::array<Slot, 2> both;
        std::size_t count = 0;
        for (const Field& field : descriptor_.fields)
            for (std::uint32_t i = 0; may_be(field, inside) && !field.array && i < field.count && count < 2;
                 ++i)
                both[count++] = found(field, i);
        return both;
    }

    ReportShape report() const {
        return known_ ? ReportShape{id_, descriptor_.bytes(kind_, id_)} : ReportShape{};
    }

private:
    bool may_be(const Field& field, std::uint32_t inside) const {
        return field.kind == kind_ && !field.constant && !field.relative &&
               (!known_ || field.report_id == id_) &&
               (report_usage_ == 0 || descriptor_.within(field.collection, report_usage_)) &&
               (inside == 0 || descriptor_.within(field.collection, inside));
    }
    Slot found(const Field& field, std::uint32_t index) {
        const Slot slot = slot_of(field, index);
        if (slot.there()) {
            known_ = true;
            id_ = field.report_id;
        }
        return slot;
    }

    const ReportDescriptor& descriptor_;
    ReportKind kind_;
    std::uint32_t report_usage_;
    bool known_ = false;
    std::uint8_t id_ = 0;
};

void find_outputs(const ReportDescriptor& descriptor, PidLayout& layout) {
    ReportFinder effect(descriptor, ReportKind::output, set_effect);
    layout.effect.block = effect.value(block_index);
    layout.effect.constant_force = effect.choice(constant_force);
    layout.effect.duration = effect.value(duration);
    layout.effect.gain = effect.value(effect_gain);
    layout.effect.axis_enable = {effect.value(axis_x, axes_enable), effect.value(axis_y, axes_enable)};
    layout.effect.direction_enable = effect.value(direction_enable);
    layout.effect.direction = effect.pair(direction);
    layout.effect.report = effect.report();

    ReportFinder force(descriptor, ReportKind::output, set_constant_force);
    layout.force.block = force.value(block_index);
    layout.force.magnitude = force.value(magnitude);
    layout.force.report = force.report();

    ReportFinder operation(descriptor, ReportKind::output, effect_operation);
    layout.operation.block = operation.value(block_index);
    layout.operation.start = operation.choice(operation_start);
    layout.operation.stop = operation.choice(operation_stop);
    layout.operation.loops = operation.value(loop_count);
    layout.operation.report = operation.report();

    ReportFinder free(descriptor, ReportKind::output, block_free);
    layout.free.block = free.value(block_index);
    layout.free.report = free.report();

    // Some devices have it in a collection of its own, some inside the state report's.
    ReportFinder control(descriptor, ReportKind::output, 0);
    layout.control.enable = control.choice(enable_actuators);
    layout.control.disable = control.choice(disable_actuators);
    layout.control.stop_all = control.choice(stop_all_effects);
    layout.control.reset = control.choice(device_reset);
    layout.control.report = control.report();

    ReportFinder gain(descriptor, ReportKind::output, device_gain_report);
    layout.gain.gain = gain.value(device_gain);
    layout.gain.report = gain.report();
}

void find_features(const ReportDescriptor& descriptor, PidLayout& layout) {
    ReportFinder create(descriptor, ReportKind::feature, create_new_effect);
    layout.create.constant_force = create.choice(constant_force);
    layout.create.report = create.report();

    ReportFinder load(descriptor, ReportKind::feature, block_load);
    layout.block_load.block = load.value(block_index);
    layout.block_load.success = load.choice(load_success);
    layout.block_load.full = load.choice(load_full);
    layout.block_load.report = load.report();
}

void find_inputs(const ReportDescriptor& descriptor, PidLayout& layout) {
    ReportFinder state(descriptor, ReportKind::input, state_report);
    layout.state.actuators_enabled = state.value(actuators_enabled);
    layout.state.paused = state.value(device_paused);
    layout.state.safety_switch = state.value(safety_switch);
    layout.state.actuator_power = state.value(actuator_power);
    layout.state.report = state.report();

    ReportFinder stick(descriptor, ReportKind::input, 0);
    layout.stick.axis = {stick.value(axis_x), stick.value(axis_y)};
    for (std::uint32_t i = 0; i < layout.stick.buttons.size(); ++i)
        layout.stick.buttons[i] = stick.value(button(1 + i));
    layout.stick.report = stick.report();
}

} // namespace

bool has_constant_force(const ReportDescriptor& descriptor) {
    return std::any_of(descriptor.fields.begin(), descriptor.fields.end(), [&descriptor](const Field& field) {
        return field.kind == ReportKind::output && field.index_of(magnitude) >= 0 &&
               descriptor.within(field.collection, set_constant_force);
    });
}

const char* find_layout(const ReportDescriptor& descriptor, PidLayout& layout) {
    layout = {};
    layout.numbered = descriptor.numbered;
    find_outputs(descriptor, layout);
    find_features(descriptor, layout);
    find_inputs(descriptor, layout);
    for (const ReportShape& report :
         {layout.create.report, layout.block_load.report, layout.effect.report, layout.force.report,
          layout.operation.report, layout.free.report, layout.control.report, layout.gain.report,
          layout.state.report, layout.stick.report})
        if (report.bytes > most_report_bytes)
            return "its reports are too long";
    if (!layout.stick.axis[0].there() || !layout.stick.axis[1].there())
        return "it does not have two axes";
    if (!layout.force.magnitude.there())
        return "it has no constant force";
    if (!layout.force.magnitude.is_signed() || layout.force.magnitude.most <= 0)
        return "its force has no sign";
    if (!layout.create.constant_force.there() || !layout.block_load.block.there() ||
        !layout.block_load.success.there())
        return "it does not keep its effects itself";
    if (!layout.force.block.there() || !layout.effect.block.there() || !layout.operation.block.there() ||
        !layout.operation.start.there())
        return "its effects have no numbers";
    const bool turns = layout.effect.direction[0].there();
    const bool selects = layout.effect.axis_enable[0].there() && layout.effect.axis_enable[1].there();
    if (!turns && !selects)
        return "its force has no direction";
    return nullptr;
}

} // namespace tp::hid
