// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/model_board.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace tp {

namespace {

float float_of(const std::uint8_t* bytes) {
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < 4; ++i)
        bits |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
    return std::bit_cast<float>(bits);
}

/// As hard as the motors can where it is not a number: nothing says what the board makes of that.
double held_torque(float asked) {
    const double most = Pantograph::greatest_torque;
    return std::isnan(asked) ? most : std::clamp(static_cast<double>(asked), -most, most);
}

} // namespace

ModelBoard::ModelBoard(HaplyGeneration generation, const HaplyPlant& plant)
    : arms_(generation), wiring_(arms_.set_up(arms_.reference_deg())), plant_(plant) {
    const auto pose = arms_.pose_at(arms_.reference_deg());
    place_ = pose ? pose->place : arms_.middle();
    hand_ = place_;
}

void ModelBoard::place_handle(Vec2 place) {
    if (arms_.angles_at(place)) {
        place_ = place;
        hand_ = place;
        velocity_ = Vec2(0.0);
    }
}

void ModelBoard::power_off() {
    frame_.clear();
    sent_.clear();
    set_up_ = {};
    pulled_ = {};
}

double ModelBoard::sense(std::size_t port, haply::Turn turn, bool motor) const {
    const auto& encoder = wiring_.encoders[port];
    const auto truth = motor ? wiring_.motors[port] : encoder ? std::optional(encoder->turn) : std::nullopt;
    return !truth ? 0.0 : turn == *truth ? 1.0 : -1.0;
}

long ModelBoard::true_count(const Port& encoder) const {
    const auto angles = arms_.angles_at(place_);
    if (!angles || encoder.port >= 2)
        return 0;
    const haply::Reply by_port = arms_.reply_of(*angles);
    const auto& wired = wiring_.encoders[encoder.port];
    const double counts = wired ? static_cast<double>(wired->counts_per_turn) : 0.0;
    return std::lround(static_cast<double>(by_port.angle_deg[encoder.port]) / 360.0 * counts);
}

std::optional<std::size_t> ModelBoard::frame_length() const {
    if (frame_.size() < 2)
        return std::nullopt;
    switch (static_cast<haply::FrameType>(frame_[0])) {
    case haply::FrameType::reset:
        return 2;
    case haply::FrameType::set_up:
        return haply::set_up_length(frame_);
    case haply::FrameType::command:
        return 2 + set_up_.output_pins + 4 * set_up_.motors.size();
    }
    return std::nullopt;
}

void ModelBoard::receive(std::uint8_t byte) {
    if (frame_.empty() && byte > static_cast<std::uint8_t>(haply::FrameType::command))
        return;
    frame_.push_back(byte);
    const auto length = frame_length();
    if (length && frame_.size() >= *length) {
        obey();
        frame_.clear();
    }
}

void ModelBoard::obey() {
    switch (static_cast<haply::FrameType>(frame_[0])) {
    case haply::FrameType::reset:
        set_up_ = {};
        break;
    case haply::FrameType::set_up:
        take_set_up();
        break;
    case haply::FrameType::command:
        for (std::size_t i = 0; i < set_up_.motors.size(); ++i) {
            const Port& motor = set_up_.motors[i];
            pulled_[motor.port] = sense(motor.port, motor.turn, true) *
                                  held_torque(float_of(&frame_[2 + set_up_.output_pins + 4 * i]));
        }
        answer();
        break;
    }
}

void ModelBoard::take_set_up() {
    set_up_ = {};
    std::size_t at = 2;
    for (std::vector<Port>* const list : {&set_up_.motors, &set_up_.encoders}) {
        const unsigned mask = frame_[at++];
        for (std::size_t port = 0; port < haply::port_count; ++port)
            if ((mask >> port & 1u) != 0)
                list->push_back(
                    {port, frame_[at++] == 0 ? haply::Turn::clockwise : haply::Turn::counter_clockwise});
    }
    set_up_.sensor_pins = frame_[at];
    at += 1 + set_up_.sensor_pins;
    set_up_.output_pins = frame_[at];
    at += 1 + set_up_.output_pins;
    for (Port& encoder : set_up_.encoders) {
        encoder.offset_deg = float_of(&frame_[at]);
        encoder.counts_per_turn = float_of(&frame_[at + 4]);
        encoder.counted_from = true_count(encoder);
        at += 8;
    }
}

void ModelBoard::answer() {
    constexpr std::size_t most_unread = 4096; // as the system keeps of a line that nobody reads
    const auto say = [this](float value) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (unsigned i = 0; i < 4; ++i)
            sent_.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    };
    sent_.push_back(frame_[1]);
    for (std::size_t i = 0; i < set_up_.sensor_pins; ++i)
        say(0.0f);
    for (const Port& encoder : set_up_.encoders) {
        const auto counted = static_cast<float>(sense(encoder.port, encoder.turn, false)) *
                             static_cast<float>(true_count(encoder) - encoder.counted_from);
        say(encoder.offset_deg + counted * 360.0f / encoder.counts_per_turn);
    }
    while (sent_.size() > most_unread)
        sent_.pop_front();
}

std::array<double, 2> ModelBoard::torques() const {
    haply::Command by_port;
    by_port.torque = {static_cast<float>(pulled_[0]), static_cast<float>(pulled_[1])};
    return arms_.torques_of(by_port);
}

Vec2 ModelBoard::force() const {
    const auto angles = arms_.angles_at(place_);
    const auto pose = angles ? arms_.pose_at(*angles) : std::nullopt;
    if (!pose || !(pose->condition < 1e3))
        return Vec2(0.0);
    // τ = JᵀF the other way round; N·m over mm.
    const std::array<double, 2> torque = torques();
    const Vec2 a = 1e-3 * pose->column[0];
    const Vec2 b = 1e-3 * pose->column[1];
    return Vec2(torque[0] * b.y - torque[1] * a.y, torque[1] * a.x - torque[0] * b.x) / cross(a, b);
}

void ModelBoard::step() {
    constexpr int parts = 4;
    constexpr double dt = 0.001 / parts;
    constexpr double newtons_to_mm = 1000.0; // N/kg = m/s²; the state is in mm
    constexpr double least_y = 5.0;          // the motors stand there
    const Vec2 pull = force();
    for (int i = 0; i < parts; ++i) {
        const Vec2 total = pull + plant_.hand_stiffness * (hand_ - place_) -
                           1e-3 * (plant_.damping + plant_.hand_damping) * velocity_;
        velocity_ += dt * newtons_to_mm / plant_.mass * total;
        const double speed = length(velocity_);
        const double loss = dt * newtons_to_mm / plant_.mass * plant_.coulomb;
        velocity_ *= speed > 0.0 ? std::max(0.0, speed - loss) / speed : 0.0;
        const Vec2 next = place_ + dt * velocity_;
        if (next.y > least_y && arms_.angles_at(next))
            place_ = next;
        else
            velocity_ = Vec2(0.0); // the arms' end stop
    }
}

} // namespace tp
