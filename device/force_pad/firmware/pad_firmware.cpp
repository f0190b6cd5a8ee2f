// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/pad_firmware.hpp"

namespace tp::pad {

namespace {

constexpr float two_pi = 6.2831853f;
constexpr uint8_t version_major = 1;
constexpr uint8_t version_minor = 0;

/// Counts wrap as the encoders' registers do.
int32_t moved(int32_t now, int32_t before) {
    return static_cast<int32_t>(static_cast<uint32_t>(now) - static_cast<uint32_t>(before));
}

int32_t rounded(float value) { return static_cast<int32_t>(value < 0 ? value - 0.5f : value + 0.5f); }

constexpr float most_in_a_word = 2e9f;

/// In thousandths, at most `most` of them; what is not a number is 0.
int32_t thousandths(float value, float most = most_in_a_word) {
    const float scaled = 1000.0f * value;
    return scaled == scaled ? rounded(clamped(scaled, -most, most)) : 0;
}

uint16_t unsigned_thousandths(float value) {
    return static_cast<uint16_t>(thousandths(larger(value, 0.0f), 65535.0f));
}

void name(PadConfig& config, const char* serial) {
    for (size_t i = 0; i < serial_size && serial[i] != 0; ++i)
        config.serial[i] = serial[i];
}

void rectangle(PadConfig& config, Vec<float> low, Vec<float> high) {
    config.corners = 4;
    config.outline[0] = low;
    config.outline[1] = {high.x, low.y};
    config.outline[2] = high;
    config.outline[3] = {low.x, high.y};
}

} // namespace

PadConfig cable_pad() {
    PadConfig config;
    config.cables.exits[0] = {-150, -110};
    config.cables.exits[1] = {150, -110};
    config.cables.exits[2] = {150, 110};
    config.cables.exits[3] = {-150, 110};
    config.cables.least_tension = 0.3f;
    config.cables.greatest_tension = 4.0f;
    config.cables.rest_tension = 0.6f;
    rectangle(config, {-100, -75}, {100, 75});
    name(config, "TPC-0001");
    return config;
}

PadConfig pantograph_pad() {
    PadConfig config;
    config.kind = PadKind::pantograph;
    config.bars.proximal = 70;
    config.bars.distal = 90;
    config.bars.base = 38;
    config.mark_angles[0] = 2.2689280f; // 130°
    config.mark_angles[1] = 0.8726646f; // 50°
    config.counts_per_turn = 16384;
    config.greatest_torque = 123;
    rectangle(config, {-41, 75}, {79, 135});
    config.resolution_um = 30;
    name(config, "TPP-0001");
    return config;
}

void PadFirmware::receive(const Frame& frame) {
    ForceFrame force;
    AskFrame ask;
    CalibrateFrame calibrate;
    if (decode(frame, force))
        take(force);
    else if (decode(frame, ask))
        reply(ask);
    else if (decode(frame, calibrate))
        take(calibrate);
    else
        bad_frame_ = true;
}

void PadFirmware::take(const ForceFrame& force) {
    if (!force.motors) { // off is obeyed whatever its number
        armed_ = false;
        return;
    }
    if (armed_ && !newer(force.sequence, heard_))
        return;
    if (!armed_) {
        // Motors come on only at no force, so that nothing that waited somewhere on the way starts them with
        // a jerk.
        if (force.x_mn != 0 || force.y_mn != 0 || !may_be_armed())
            return;
        armed_ = true;
        tripped_ = 0;
        allowed_ = {};
    }
    heard_ = force.sequence;
    heard_at_us_ = sensors_.time_us;
    asked_ = {0.001f * static_cast<float>(force.x_mn), 0.001f * static_cast<float>(force.y_mn)};
}

void PadFirmware::take(const CalibrateFrame& calibrate) {
    armed_ = false;
    if (calibrate.action == CalibrateAction::home) {
        for (int i = 0; i < most_motors; ++i)
            home_[i] = sensors_.counts[i];
        homed_ = stepped_;
        place_ = config_.mark;
    } else {
        permille_[calibrate.motor] = calibrate.permille;
    }
    answer_ = calibration();
    answer_due_ = true;
}

Frame PadFirmware::calibration() const {
    CalibrationFrame frame;
    frame.sequence = sequence_;
    frame.homed = homed_;
    for (int i = 0; i < most_motors; ++i)
        frame.permille[i] = permille_[i];
    return encode(frame);
}

void PadFirmware::reply(const AskFrame& ask) {
    answer_due_ = true;
    switch (ask.what) {
    case FrameType::capabilities: {
        CapabilitiesFrame frame;
        frame.sequence = sequence_;
        frame.kind = config_.kind;
        frame.firmware_major = version_major;
        frame.firmware_minor = version_minor;
        frame.corners = config_.corners;
        frame.max_force_mn = unsigned_thousandths(config_.max_force);
        frame.continuous_force_mn = unsigned_thousandths(config_.continuous_force);
        frame.resolution_um = config_.resolution_um;
        frame.rate_hz = config_.rate_hz;
        frame.delay_us = config_.delay_us;
        frame.watchdog_ms = static_cast<uint8_t>(config_.watchdog_us / 1000);
        answer_ = encode(frame);
        return;
    }
    case FrameType::outline: {
        OutlineFrame frame;
        frame.sequence = sequence_;
        frame.page = ask.page;
        for (int i = ask.page * corners_per_page; i < config_.corners && frame.corners < corners_per_page;
             ++i) {
            frame.x_um[frame.corners] = thousandths(config_.outline[i].x);
            frame.y_um[frame.corners] = thousandths(config_.outline[i].y);
            ++frame.corners;
        }
        answer_ = encode(frame);
        return;
    }
    case FrameType::identity: {
        IdentityFrame frame;
        frame.sequence = sequence_;
        for (size_t i = 0; i < serial_size; ++i)
            frame.serial[i] = config_.serial[i];
        answer_ = encode(frame);
        return;
    }
    case FrameType::calibration:
        answer_ = calibration();
        return;
    default:
        answer_due_ = false; // the state comes by itself
    }
}

void PadFirmware::find_place() {
    const float per_count = two_pi / config_.counts_per_turn;
    if (config_.kind == PadKind::cables) {
        float lengths[cable_count];
        for (int i = 0; i < cable_count; ++i)
            lengths[i] =
                length(config_.cables.exits[i] - config_.mark) +
                config_.drum_radius * per_count * static_cast<float>(moved(sensors_.counts[i], home_[i]));
        const CablePlace<float> found = locate(config_.cables, lengths, place_);
        place_ = found.place;
        residual_ = found.residual;
        if (!found.converged || !(residual_ <= config_.greatest_residual)) // also what is not a number
            flags_ |= status::unsure;
        if (!(dot(place_, place_) < 1e8f))
            place_ = config_.mark; // a search that ran away begins anew
    } else {
        float angles[arm_count];
        for (int i = 0; i < arm_count; ++i)
            angles[i] = config_.mark_angles[i] +
                        per_count * static_cast<float>(moved(sensors_.counts[i], home_[i]) %
                                                       static_cast<int32_t>(config_.counts_per_turn));
        pose_ = locate(config_.bars, angles);
        place_ = pose_.place;
        if (!pose_.reachable)
            flags_ |= status::unsure;
        if (!(pose_.spread >= config_.least_spread))
            flags_ |= status::singular;
    }
}

bool PadFirmware::inside_outline() const {
    bool inside = false;
    for (int i = 0; i < config_.corners; ++i) {
        const Vec<float> a = config_.outline[i];
        const Vec<float> b = config_.outline[i + 1 < config_.corners ? i + 1 : 0];
        if ((a.y > place_.y) != (b.y > place_.y) &&
            place_.x < (b.x - a.x) * (place_.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

bool PadFirmware::may_be_armed() const {
    return stepped_ &&
           (flags_ & (status::not_homed | status::hot | status::over_current | status::unsure)) == 0;
}

Drive PadFirmware::step(const Sensors& sensors) {
    const uint32_t elapsed_us = sensors.time_us - sensors_.time_us;
    sensors_ = sensors;
    stepped_ = true;

    flags_ = 0;
    if (!homed_)
        flags_ |= status::not_homed;
    too_hot_ = sensors.celsius >= (too_hot_ ? config_.cool : config_.hot);
    if (too_hot_)
        flags_ |= status::hot;
    for (const uint16_t current : sensors.current_ma)
        if (current > config_.greatest_current_ma)
            flags_ |= status::over_current;
    find_place();
    if (!inside_outline())
        flags_ |= status::outside;

    if (armed_ && !may_be_armed()) {
        armed_ = false;
        tripped_ = flags_ & (status::over_current | status::unsure);
    }
    if (armed_ && sensors.time_us - heard_at_us_ > config_.watchdog_us) {
        armed_ = false;
        tripped_ = status::watchdog;
    }
    limit_force(1e-6f * static_cast<float>(smaller(elapsed_us, uint32_t{10000})));
    return pull();
}

void PadFirmware::limit_force(float seconds) {
    if (!armed_ || (asked_.x == 0 && asked_.y == 0)) {
        allowed_ = {};
        return;
    }
    Vec<float> wanted = asked_;
    const float magnitude = length(wanted);
    if (magnitude > config_.max_force) {
        wanted = (config_.max_force / magnitude) * wanted;
        flags_ |= status::limited;
    }
    const Vec<float> change = wanted - allowed_;
    const float size = length(change);
    const float most = config_.max_force_rate * seconds;
    allowed_ = size > most ? allowed_ + (most / size) * change : wanted;
}

int32_t PadFirmware::torque(int motor, float newton_mm) const {
    const float scaled = newton_mm * 0.001f * static_cast<float>(permille_[motor]);
    return thousandths(clamped(scaled, -config_.greatest_torque, config_.greatest_torque));
}

Drive PadFirmware::pull_cables() {
    Drive drive;
    const Tensions<float> found = distribute(config_.cables, place_, allowed_);
    if (!found.feasible) {
        flags_ |= status::limited;
        // Where even the least tensions pull harder than was asked for (near the frame), no pull is right.
        if (dot(found.force, found.force) > dot(allowed_, allowed_)) {
            flags_ |= status::singular;
            return drive;
        }
    }
    for (int i = 0; i < cable_count; ++i)
        drive.torque_unm[i] = torque(i, config_.drum_radius * found.newtons[i]);
    made_ = found.force;
    drive.powered = true;
    return drive;
}

Drive PadFirmware::turn_bars() {
    Drive drive;
    const Torques<float> found = torques(pose_, allowed_, config_.greatest_torque, config_.least_spread);
    if (found.limited)
        flags_ |= status::limited;
    for (int i = 0; i < arm_count; ++i)
        drive.torque_unm[i] = torque(i, found.newton_mm[i]);
    made_ = found.force;
    drive.powered = true;
    return drive;
}

Drive PadFirmware::pull() {
    made_ = {};
    if (!armed_)
        return {};
    return config_.kind == PadKind::cables ? pull_cables() : turn_bars();
}

Frame PadFirmware::state() {
    StateFrame frame;
    frame.sequence = ++sequence_;
    frame.time_us = sensors_.time_us;
    frame.x_um = thousandths(place_.x);
    frame.y_um = thousandths(place_.y);
    frame.force_x_mn = static_cast<int16_t>(thousandths(made_.x, 32767.0f));
    frame.force_y_mn = static_cast<int16_t>(thousandths(made_.y, 32767.0f));
    frame.residual_um = unsigned_thousandths(residual_);
    frame.status = static_cast<uint16_t>(flags_ | tripped_ | (armed_ ? status::armed : 0) |
                                         (bad_frame_ ? status::bad_frame : 0));
    frame.heard = heard_;
    frame.celsius = sensors_.celsius;
    frame.buttons = sensors_.buttons;
    bad_frame_ = false;
    return encode(frame);
}

bool PadFirmware::answer(Frame& frame) {
    if (!answer_due_)
        return false;
    frame = answer_;
    answer_due_ = false;
    return true;
}

} // namespace tp::pad
