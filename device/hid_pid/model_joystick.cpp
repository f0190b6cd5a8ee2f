// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/model_joystick.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {

namespace {

// clang-format off
/// Usages and report ids as in the OpenFFBoard firmware; what a constant force does not need is left out.
#define TP_STICK_AXES \
    0x05, 0x01, 0x09, 0x04, 0xA1, 0x01,                         /* Joystick (Application) */ \
    0x85, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x40,             /*   Buttons 1 … 64 */ \
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x40, 0x81, 0x02, \
    0x05, 0x01, 0x09, 0x30, 0x09, 0x31,                         /*   X, Y: 16 bits */ \
    0x16, 0x01, 0x80, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x02, 0x81, 0x02, \
    0x05, 0x0F

#define TP_STICK_STATE \
    0x09, 0x92, 0xA1, 0x02, 0x85, 0x02,                         /*   State */ \
    0x09, 0x9F, 0x09, 0xA0, 0x09, 0xA4, 0x09, 0xA6,             /*     paused, enabled, safety switch, power */ \
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x04, 0x81, 0x02, \
    0x95, 0x04, 0x81, 0x03, 0xC0

#define TP_STICK_EFFECT_HEAD \
    0x09, 0x21, 0xA1, 0x02, 0x85, 0x01,                         /*   Set Effect */ \
    0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08, 0x95, 0x01, 0x91, 0x02, \
    0x09, 0x25, 0xA1, 0x02, 0x09, 0x26, 0x09, 0x27,             /*     type: constant, ramp */ \
    0x15, 0x01, 0x25, 0x02, 0x91, 0x00, 0xC0

#define TP_STICK_EFFECT_TAIL \
    0x09, 0x52, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x01, 0x91, 0x02, /* gain */ \
    0x09, 0x53, 0x15, 0x01, 0x25, 0x08, 0x91, 0x02,             /*     trigger button */ \
    0x09, 0x55, 0xA1, 0x02, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, /*     axes: X, Y */ \
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x91, 0x02, 0xC0, \
    0x05, 0x0F, 0x09, 0x56, 0x95, 0x01, 0x91, 0x02,             /*     direction enable */ \
    0x95, 0x05, 0x91, 0x03, \
    0x09, 0x57, 0xA1, 0x02,                                     /*     direction: 2 × 16 bits */ \
    0x0B, 0x01, 0x00, 0x0A, 0x00, 0x0B, 0x02, 0x00, 0x0A, 0x00, \
    0x27, 0xA0, 0x8C, 0x00, 0x00, 0x75, 0x10, 0x95, 0x02, 0x91, 0x02, 0xC0

#define TP_STICK_REST \
    0xC0, \
    0x05, 0x0F, 0x09, 0x73, 0xA1, 0x02, 0x85, 0x05,             /*   Set Constant Force */ \
    0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08, 0x95, 0x01, 0x91, 0x02, \
    0x09, 0x70, 0x16, 0x01, 0x80, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x91, 0x02, 0xC0, \
    0x09, 0x77, 0xA1, 0x02, 0x85, 0x0A,                         /*   Effect Operation */ \
    0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08, 0x91, 0x02, \
    0x09, 0x78, 0xA1, 0x02, 0x09, 0x79, 0x09, 0x7A, 0x09, 0x7B, 0x25, 0x03, 0x91, 0x00, 0xC0, \
    0x09, 0x7C, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x91, 0x02, 0xC0, \
    0x09, 0x90, 0xA1, 0x02, 0x85, 0x0B,                         /*   Block Free */ \
    0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x91, 0x02, 0xC0

#define TP_STICK_MEMORY \
    0x09, 0x7D, 0xA1, 0x02, 0x85, 0x0D,                         /*   Device Gain */ \
    0x09, 0x7E, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x01, 0x91, 0x02, 0xC0, \
    0x09, 0xAB, 0xA1, 0x02, 0x85, 0x11,                         /*   Create New Effect */ \
    0x09, 0x25, 0xA1, 0x02, 0x09, 0x26, 0x09, 0x27, 0x15, 0x01, 0x25, 0x02, 0xB1, 0x00, 0xC0, \
    0x75, 0x10, 0xB1, 0x03, 0xC0, \
    0x09, 0x89, 0xA1, 0x02, 0x85, 0x12,                         /*   Block Load */ \
    0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08, 0xB1, 0x02, \
    0x09, 0x8B, 0xA1, 0x02, 0x09, 0x8C, 0x09, 0x8D, 0x09, 0x8E, 0x25, 0x03, 0xB1, 0x00, 0xC0, \
    0x09, 0xAC, 0x15, 0x00, 0x27, 0xFF, 0xFF, 0x00, 0x00, 0x75, 0x10, 0xB1, 0x02, 0xC0, \
    0xC0

#define TP_STICK_COMMANDS 0x09, 0x97, 0x09, 0x98, 0x09, 0x99, 0x09, 0x9A, 0x09, 0x9B, 0x09, 0x9C

constexpr std::uint8_t open_descriptor[] = {
    TP_STICK_AXES, TP_STICK_STATE, TP_STICK_EFFECT_HEAD,
    0x09, 0x50, 0x09, 0x54, 0x09, 0x51, 0x09, 0xA7,             // duration, repeat, sample period, start delay
    0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x04, 0x91, 0x02,
    TP_STICK_EFFECT_TAIL,
    0x09, 0x58, 0xA1, 0x02, 0x0B, 0x01, 0x00, 0x0A, 0x00, 0x0B, 0x02, 0x00, 0x0A, 0x00, // type specific offsets
    0x26, 0xFD, 0x7F, 0x91, 0x02, 0xC0,
    TP_STICK_REST,
    0x09, 0x96, 0xA1, 0x02, 0x85, 0x0C, TP_STICK_COMMANDS,      // Device Control: a number
    0x15, 0x01, 0x25, 0x06, 0x75, 0x08, 0x95, 0x01, 0x91, 0x00, 0xC0,
    TP_STICK_MEMORY,
};

constexpr std::uint8_t plain_descriptor[] = {
    TP_STICK_AXES, TP_STICK_EFFECT_HEAD,
    0x09, 0x50, 0x09, 0x54, 0x09, 0x51,                         // duration, repeat, sample period
    0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x03, 0x91, 0x02,
    TP_STICK_EFFECT_TAIL,
    TP_STICK_REST,
    0x09, 0x95, 0xA1, 0x02, 0x85, 0x0C, TP_STICK_COMMANDS,      // Device Control: a bit for each
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x06, 0x91, 0x02, 0x95, 0x02, 0x91, 0x03, 0xC0,
    TP_STICK_MEMORY,
};
// clang-format on

#undef TP_STICK_AXES
#undef TP_STICK_STATE
#undef TP_STICK_EFFECT_HEAD
#undef TP_STICK_EFFECT_TAIL
#undef TP_STICK_REST
#undef TP_STICK_MEMORY
#undef TP_STICK_COMMANDS

constexpr int endless = 0xFFFF;
constexpr double longest_ms = 65535.0;

int word_at(std::span<const std::uint8_t> bytes, std::size_t at) { return bytes[at] | bytes[at + 1] << 8; }

void put_word(std::vector<std::uint8_t>& bytes, std::size_t at, int value) {
    bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
    bytes[at + 1] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
}

} // namespace

JoystickWire open_controller() {
    JoystickWire wire;
    wire.descriptor = open_descriptor;
    return wire;
}

JoystickWire plain_controller() {
    JoystickWire wire;
    wire.descriptor = plain_descriptor;
    wire.effect_bytes = 15;
    wire.enable_byte = 10;
    wire.direction_byte = 11;
    wire.control_bits = true;
    wire.has_state = false;
    return wire;
}

ModelJoystick::ModelJoystick(const JoystickWire& wire, const HandlePlant& plant)
    : wire_(wire), plant_(plant) {
    told_axes_ = axes_report();
    told_state_ = state_report();
}

ModelJoystick::Effect* ModelJoystick::effect(std::uint8_t block) {
    if (block == 0 || block > effects_.size() || !effects_[block - 1u].held)
        return nullptr;
    return &effects_[block - 1u];
}

std::size_t ModelJoystick::effects() const {
    return static_cast<std::size_t>(
        std::count_if(effects_.begin(), effects_.end(), [](const Effect& one) { return one.held; }));
}

void ModelJoystick::leave_effects(std::size_t count) {
    for (std::size_t i = 0; i < count && i < effects_.size(); ++i)
        effects_[i].held = true;
}

void ModelJoystick::obey(unsigned command) {
    switch (command) {
    case 1:
        enabled_ = true;
        break;
    case 2:
        enabled_ = false;
        break;
    case 3:
        for (Effect& one : effects_)
            one.playing = false;
        break;
    case 4:
        enabled_ = false;
        for (Effect& one : effects_) {
            one.playing = false;
            one.held = one.held && troubles.keeps_after_reset;
        }
        break;
    default:
        break;
    }
}

void ModelJoystick::receive(std::span<const std::uint8_t> report) {
    if (report.empty())
        return;
    const std::uint8_t id = report[0];
    const std::span<const std::uint8_t> bytes = report.subspan(1);
    if (id == wire_.control && !bytes.empty()) {
        for (unsigned command = 1; command <= 6; ++command)
            if (wire_.control_bits ? (bytes[0] >> (command - 1) & 1u) != 0 : bytes[0] == command)
                obey(command);
        return;
    }
    Effect* const one = bytes.empty() ? nullptr : effect(bytes[0]);
    if (one == nullptr)
        return;
    if (id == wire_.set_effect && bytes.size() == wire_.effect_bytes) {
        one->constant = bytes[1] == 1;
        last_duration = one->duration = word_at(bytes, 2);
        const unsigned enables = bytes[wire_.enable_byte];
        one->x = (enables & 1u) != 0;
        one->y = (enables & 2u) != 0;
        one->turned = (enables & 4u) != 0;
        const int angle =
            wire_.direction_bytes == 1 ? bytes[wire_.direction_byte] : word_at(bytes, wire_.direction_byte);
        one->degrees = 360.0 * angle / wire_.whole_turn;
    } else if (id == wire_.constant_force && bytes.size() == 3) {
        one->magnitude = std::clamp<int>(static_cast<std::int16_t>(word_at(bytes, 1)), -wire_.magnitude_full,
                                         wire_.magnitude_full);
    } else if (id == wire_.operation && bytes.size() == 3) {
        one->playing = bytes[1] == 1 || (bytes[1] != 3 && one->playing);
        if (bytes[1] == 1)
            one->left_ms = one->duration == endless && !troubles.expires
                               ? 1e300
                               : std::min<double>(one->duration, longest_ms);
    } else if (id == wire_.free) {
        *one = {};
    }
}

bool ModelJoystick::set_feature(std::span<const std::uint8_t> report) {
    if (report.empty() || report[0] != wire_.create)
        return false;
    load_status_ = 3;
    loaded_ = 0;
    if (report.size() < 2 || report[1] != 1 || troubles.refuses)
        return true;
    load_status_ = 2;
    for (std::size_t i = 0; i < std::min(troubles.room, effects_.size()); ++i)
        if (!effects_[i].held) {
            effects_[i] = {};
            effects_[i].held = true;
            loaded_ = static_cast<std::uint8_t>(i + 1);
            load_status_ = 1;
            break;
        }
    return true;
}

bool ModelJoystick::get_feature(std::uint8_t id, std::vector<std::uint8_t>& report) {
    if (id != wire_.block_load)
        return false;
    report = {id, loaded_, load_status_, 0xFF, 0xFF};
    return true;
}

Vec2 ModelJoystick::pull() const {
    Vec2 force(0.0);
    if (!motors_on())
        return force;
    for (const Effect& one : effects_) {
        if (!one.held || !one.playing || !one.constant)
            continue;
        const double strength = newtons_at_full * one.magnitude / wire_.magnitude_full;
        const double angle = one.degrees * std::numbers::pi / 180.0;
        const Vec2 along =
            one.turned ? Vec2(std::sin(angle), std::cos(angle)) : Vec2(one.x ? 1.0 : 0.0, one.y ? 1.0 : 0.0);
        force += strength * sign * along;
    }
    const double magnitude = length(force);
    return magnitude > newtons_at_full ? newtons_at_full / magnitude * force : force;
}

void ModelJoystick::step() {
    for (Effect& one : effects_)
        if (one.playing && (one.left_ms -= 1.0) <= 0.0)
            one.playing = false;
    force_ = body_.step(plant_, [this](Vec2) { return pull(); });
    for (int i = 0; i < 2; ++i)
        if (const double off = body_.place[i]; std::abs(off) > lever_mm) { // its end
            body_.place[i] = std::copysign(lever_mm, off);
            body_.velocity[i] = 0.0;
        }
    if (std::vector<std::uint8_t> now = axes_report(); speaks_at_rest || now != told_axes_) {
        to_tell_.push_back(now);
        told_axes_ = std::move(now);
    }
    if (std::vector<std::uint8_t> now = state_report(); wire_.has_state && now != told_state_) {
        to_tell_.push_back(now);
        told_state_ = std::move(now);
    }
}

bool ModelJoystick::report(std::vector<std::uint8_t>& bytes) {
    if (to_tell_.empty())
        return false;
    bytes = std::move(to_tell_.front());
    to_tell_.pop_front();
    return true;
}

std::vector<std::uint8_t> ModelJoystick::axes_report() const {
    std::vector<std::uint8_t> bytes(1 + wire_.axes_bytes);
    bytes[0] = wire_.axes;
    const auto value = [this](double mm) {
        return static_cast<int>(std::lround(std::clamp(mm / lever_mm, -1.0, 1.0) * wire_.axis_most));
    };
    put_word(bytes, 1 + wire_.x_byte, value(body_.place.x));
    put_word(bytes, 1 + wire_.y_byte, value(-body_.place.y));
    return bytes;
}

std::vector<std::uint8_t> ModelJoystick::state_report() const {
    const unsigned bits = (enabled_ ? 2u : 0u) | (troubles.safety_switch ? 0u : 4u) |
                          (troubles.no_power ? 0u : 1u << wire_.power_bit);
    std::vector<std::uint8_t> bytes(1 + wire_.state_bytes);
    bytes[0] = wire_.state;
    bytes[1] = static_cast<std::uint8_t>(bits);
    return bytes;
}

} // namespace tp
