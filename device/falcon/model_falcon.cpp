// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/model_falcon.hpp"

#include "device/falcon/plane_force.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tp {

using namespace falcon;

namespace {

constexpr std::size_t most_packets = 64;     ///< as the computer keeps of those that nobody reads
constexpr std::uint64_t clear_after_ms = 30; ///< from the loader's second baud rate to CTS
constexpr std::uint64_t begins_after_ms =
    40; ///< from the last byte of the image to the firmware's first answer
constexpr double mark_angle = 55.0 * std::numbers::pi / 180.0; ///< where an arm learns where it is: far out
constexpr std::array<double, 3> counts_lost{-700.0, 310.0, 1250.0}; ///< before it was homed

/// Its angles there, where its stops let it go.
std::optional<Angles> within_stops(const Place& place) {
    const bool within = place.z > 0.075 && place.z < 0.172 && std::hypot(place.x, place.y) < 0.065;
    return within ? angles_at(place) : std::nullopt;
}

} // namespace

ModelFalcon::ModelFalcon(std::vector<std::uint8_t> image, const FalconPlant& plant)
    : image_(std::move(image)), plant_(plant), angles_(*angles_at(middle)) {
    if (plant_.units_per_newton_metre == 0.0)
        plant_.units_per_newton_metre = units_per_newton_metre;
    restart();
}

void ModelFalcon::restart() {
    state_ = State::greeting;
    heard_.clear();
    homed_ = 0;
    lost_counts_ = counts_lost;
    command_ = {};
}

void ModelFalcon::run_firmware(bool homed) {
    state_ = State::firmware;
    homed_ = homed ? 7 : 0;
    lost_counts_ = homed ? std::array<double, 3>{} : counts_lost;
    command_ = {};
}

void ModelFalcon::place_grip(const Place& place) {
    const std::optional<Angles> there = within_stops(place);
    if (!there)
        return;
    place_ = place;
    angles_ = *there;
    hand_ = place;
    velocity_ = glm::dvec3(0.0);
}

std::uint16_t ModelFalcon::its_baud() const {
    switch (state_) {
    case State::greeting:
        return ftdi::baud_9600.value;
    case State::greeted:
    case State::loading:
        return ftdi::baud_142857.value;
    default:
        return ftdi::baud_1500000.value;
    }
}

double ModelFalcon::bytes_per_ms() const {
    if (baud_ == ftdi::baud_9600.value)
        return 0.96;
    return baud_ == ftdi::baud_142857.value ? 14.3 : 150.0;
}

void ModelFalcon::control(const ftdi::Request& request) {
    if (request == ftdi::purge_received)
        to_computer_.clear();
    else if (request == ftdi::purge_to_send)
        to_falcon_.clear();
    else if (request == ftdi::dtr_low)
        dtr_ = false;
    else if (request == ftdi::dtr_high) {
        if (!dtr_)
            restart(); // the line of its reset
        dtr_ = true;
    } else if (request.request == ftdi::baud_9600.request) {
        baud_ = request.value;
        clear_from_ms_ = baud_ == ftdi::baud_142857.value ? now_ms_ + clear_after_ms : 0;
    } else if (request.request == ftdi::latency(0).request) {
        latency_ms_ = std::max<std::uint16_t>(1, request.value);
    }
}

void ModelFalcon::send(std::span<const std::uint8_t> bytes) {
    to_falcon_.insert(to_falcon_.end(), bytes.begin(), bytes.end());
}

void ModelFalcon::say(std::span<const std::uint8_t> bytes) {
    to_computer_.insert(to_computer_.end(), bytes.begin(), bytes.end());
}

void ModelFalcon::hear(std::uint8_t byte) {
    if (baud_ != its_baud())
        byte = static_cast<std::uint8_t>(~byte); // at another rate it hears something else
    heard_.push_back(byte);
    const auto ends_with = [this](std::span<const std::uint8_t> wanted) {
        return heard_.size() >= wanted.size() &&
               std::equal(wanted.begin(), wanted.end(),
                          heard_.end() - static_cast<std::ptrdiff_t>(wanted.size()));
    };
    constexpr std::array<std::uint8_t, 3> greeting{0x0A, 0x43, 0x0D};
    constexpr std::array<std::uint8_t, 5> answer{0x00, 0x0A, 0x44, 0x2C, 0x0D};
    switch (state_) {
    case State::greeting:
        if (ends_with(greeting) && dtr_ && !troubles.mute_loader) {
            say(std::span(answer).subspan(troubles.eager_zero ? 0 : 1));
            state_ = State::greeted;
            heard_.clear();
        }
        break;
    case State::greeted: {
        const bool listens = troubles.never_clear || (clear_from_ms_ != 0 && now_ms_ >= clear_from_ms_);
        if (listens && !dtr_ && byte == 0x41) {
            say(std::array<std::uint8_t, 1>{0x41});
            state_ = State::loading;
            ++loads_begun_;
            spoiled_ = false;
        }
        heard_.clear();
        break;
    }
    case State::loading: {
        const bool spoils = !spoiled_ && heard_.size() == image_.size() / 2;
        if (spoils && troubles.broken_loads > 0) {
            --troubles.broken_loads;
            spoiled_ = true;
            heard_.back() = static_cast<std::uint8_t>(heard_.back() ^ 0x10);
        } else if (spoils && troubles.lossy_loads > 0) {
            --troubles.lossy_loads;
            spoiled_ = true;
            heard_.pop_back();
            break;
        }
        say(std::span(heard_).last(1));
        if (heard_.size() < image_.size())
            break;
        state_ = heard_ == image_ && !troubles.dead_firmware ? State::starting : State::dead;
        starts_at_ms_ = now_ms_ + begins_after_ms;
        heard_.clear();
        break;
    }
    case State::firmware:
        heard_.clear();
        if (const std::optional<Packet> packet = stream_.push(byte))
            if (const std::optional<Command> command = decode_command(*packet))
                obey(*command);
        break;
    case State::starting:
    case State::dead:
        heard_.clear();
        break;
    }
    if (heard_.size() > image_.size())
        heard_.clear();
}

void ModelFalcon::obey(const Command& command) {
    command_ = command;
    commanded_ms_ = now_ms_;
    Reply reply;
    for (std::size_t i = 0; i < 3; ++i)
        reply.encoders[i] =
            static_cast<std::int16_t>(std::lround(counts_of(angles_[static_cast<int>(i)]) + lost_counts_[i]));
    reply.homed = homed_;
    say(encode(reply));
}

glm::dvec3 ModelFalcon::pull() const {
    if (state_ != State::firmware || command_.motors == std::array<std::int16_t, 3>{})
        return glm::dvec3(0.0);
    const std::optional<glm::dmat3> j = jacobian(place_, angles_);
    if (!j)
        return glm::dvec3(0.0);
    const glm::dvec3 torque = -glm::dvec3(command_.motors[0], command_.motors[1], command_.motors[2]) /
                              plant_.units_per_newton_metre;
    return glm::inverse(glm::transpose(*j)) * torque;
}

void ModelFalcon::pass_marks(const Angles& before, const Angles& after) {
    for (std::size_t i = 0; i < 3; ++i) {
        const int k = static_cast<int>(i);
        if (command_.homing && (before[k] < mark_angle) != (after[k] < mark_angle)) {
            homed_ = static_cast<std::uint8_t>(homed_ | (1u << i));
            lost_counts_[i] = 0.0;
        }
    }
}

void ModelFalcon::pull_and_push() {
    for (const double z : {0.165, middle.z}) {
        const Angles before = angles_;
        place_grip({0.0, 0.0, z});
        pass_marks(before, angles_);
    }
}

void ModelFalcon::move(double dt) {
    force_ = pull();
    const glm::dvec3 total = force_ + plant_.hand_stiffness * (hand_ - place_) -
                             (plant_.damping + plant_.hand_damping) * velocity_;
    velocity_ += dt / plant_.mass * total;
    const double speed = glm::length(velocity_);
    velocity_ *= speed > 0.0 ? std::max(0.0, speed - dt / plant_.mass * plant_.coulomb) / speed : 0.0;
    const Place next = place_ + dt * velocity_;
    const std::optional<Angles> there = within_stops(next);
    if (!there) {
        velocity_ = glm::dvec3(0.0);
        return;
    }
    pass_marks(angles_, *there);
    place_ = next;
    angles_ = *there;
}

void ModelFalcon::step() {
    constexpr int parts = 2;
    ++now_ms_;
    if (state_ == State::starting && now_ms_ >= starts_at_ms_)
        run_firmware(false);
    if (plant_.watchdog_ms > 0 && now_ms_ - commanded_ms_ > static_cast<std::uint64_t>(plant_.watchdog_ms))
        command_.motors = {};
    in_hand_ = std::min(in_hand_ + bytes_per_ms(), 150.0);
    for (; in_hand_ >= 1.0 && !to_falcon_.empty(); in_hand_ -= 1.0) {
        const std::uint8_t byte = to_falcon_.front();
        to_falcon_.pop_front();
        hear(byte);
    }
    while (now_ms_ >= packet_due_ms_ || to_computer_.size() >= ftdi::most_payload) {
        packet_due_ms_ = now_ms_ + latency_ms_;
        UsbPacket packet;
        const bool clear = clear_from_ms_ != 0 && now_ms_ >= clear_from_ms_ && !troubles.never_clear;
        packet.bytes[0] = clear ? 0x11 : 0x01;
        packet.bytes[1] = 0x60;
        const std::size_t count = std::min(to_computer_.size(), ftdi::most_payload);
        std::copy_n(to_computer_.begin(), count, packet.bytes.begin() + ftdi::status_size);
        to_computer_.erase(to_computer_.begin(), to_computer_.begin() + static_cast<std::ptrdiff_t>(count));
        packet.size = ftdi::status_size + count;
        packets_.push_back(packet);
        if (packets_.size() > most_packets)
            packets_.pop_front();
    }
    for (int i = 0; i < parts; ++i)
        move(0.001 / parts);
}

bool ModelFalcon::packet(UsbPacket& packet) {
    if (packets_.empty())
        return false;
    packet = packets_.front();
    packets_.pop_front();
    return true;
}

} // namespace tp
