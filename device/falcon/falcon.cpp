// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/falcon.hpp"

#include "core/files/file_words.hpp"
#include "device/falcon/falcon_start.hpp"
#include "device/falcon/firmware_image.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace tp {

using namespace falcon;

namespace {

constexpr int most_packets_a_read = 64;
constexpr double reach_mm =
    50.0; ///< from the middle, in every direction of the plane and 3 cm before and behind it
constexpr int corners = 16;
constexpr unsigned flags_shift = 48;
constexpr std::uint64_t homing_bit = 1;

std::uint64_t message_of(const Command& command) {
    std::uint64_t message = 0;
    for (std::size_t i = 0; i < command.motors.size(); ++i)
        message |= static_cast<std::uint64_t>(static_cast<std::uint16_t>(command.motors[i])) << (16 * i);
    return message | ((command.leds | (command.homing ? homing_bit : 0)) << flags_shift);
}

Command command_of(std::uint64_t message) {
    Command command;
    for (std::size_t i = 0; i < command.motors.size(); ++i)
        command.motors[i] = static_cast<std::int16_t>((message >> (16 * i)) & 0xFFFFu);
    const std::uint64_t flags = message >> flags_shift;
    command.homing = (flags & homing_bit) != 0;
    command.leds = static_cast<std::uint8_t>(flags & ~homing_bit);
    return command;
}

/// The person's main button is the one in the middle.
std::uint32_t buttons_of(std::uint8_t pressed) {
    std::uint32_t buttons = 0;
    constexpr std::array<std::uint8_t, 4> order{button::centre, button::plus, button::forward, button::minus};
    for (std::size_t i = 0; i < order.size(); ++i)
        buttons |= (pressed & order[i]) != 0 ? 1u << i : 0u;
    return buttons;
}

std::vector<Vec2> falcon_workspace() {
    std::vector<Vec2> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        outline.emplace_back(reach_mm * std::cos(angle), reach_mm * std::sin(angle));
    }
    return outline;
}

constexpr const char* not_homed = "The Falcon does not know where its grip is. Home it: pull the grip out as "
                                  "far as it goes, then push it in.";

} // namespace

bool Falcon::Line::send(std::uint64_t message) noexcept {
    Command command = command_of(message);
    constexpr decltype(command.motors) off{};
    return pull->send(command.motors != off, [&](bool with_force) {
        if (!with_force)
            command.motors = off;
        return link->write(encode(command));
    });
}

Falcon::Falcon(Opener opener, Firmware firmware, std::string serial_number, LatestWriter::Thread thread)
    : opener_(std::move(opener)), firmware_(std::move(firmware)), serial_number_(std::move(serial_number)),
      thread_(thread) {}

Falcon::~Falcon() { stop(); }

std::string Falcon::start() {
    const Result<std::vector<std::uint8_t>> image = firmware_();
    FalconStart start(image.ok() ? std::span(*image) : std::span<const std::uint8_t>{});
    constexpr const char* gone = "The Falcon was unplugged while it was started. Plug it in again.";
    while (true) {
        const FalconStart::Step step = start.next();
        switch (step.what) {
        case FalconStart::Step::What::control:
            if (!line_->link->control(step.request))
                return gone;
            break;
        case FalconStart::Step::What::send:
            if (!line_->link->write(step.bytes))
                return gone;
            break;
        case FalconStart::Step::What::listen: {
            UsbPacket packet;
            const UsbGot got = line_->link->read(packet, FalconStart::listen_ms);
            if (got == UsbGot::lost)
                return gone;
            const ftdi::Received received = ftdi::received(packet.content());
            if (got == UsbGot::packet)
                start.heard(received.payload, received.clear_to_send);
            else
                start.silence();
            break;
        }
        case FalconStart::Step::What::running:
            return {};
        case FalconStart::Step::What::failed:
            if (start.trouble() == FalconStart::Trouble::no_image && !image.ok())
                return image.error();
            return start_sentence(start.trouble(), quoted(firmware_file()));
        }
    }
}

Result<Capabilities> Falcon::open() {
    stop();
    Result<std::unique_ptr<FalconLink>> opened = opener_();
    if (!opened.ok())
        return Error{opened.error()};
    writer_.reset();
    line_ = std::make_shared<Line>();
    line_->link = std::move(opened).value();
    touch_ = {};
    homed_.store(false);
    unguarded_.store(false);
    bad_readings_.store(0);

    std::string problem = start();
    if (problem.empty()) {
        const std::optional<Reply> first = exchange(Command{});
        if (first)
            homed_.store(first->homed == 7);
        else
            problem = start_sentence(FalconStart::Trouble::mute_loader, {});
    }
    if (problem.empty())
        problem = begin_to_guard();
    open_ = problem.empty();
    if (!open_) {
        line_->link.reset();
        return Error{problem};
    }
    writer_ = std::make_unique<LatestWriter>(line_, message_of(Command{}), thread_);
    Capabilities made;
    made.name = "Novint Falcon";
    made.serial_number = serial_number_;
    made.workspace = falcon_workspace();
    made.max_force = max_force;
    made.continuous_force = max_force;
    made.resolution = 0.05;
    made.rate = 1000.0;
    made.delay = 0.002;
    made.calibrated = false;
    return made;
}

std::string Falcon::begin_to_guard() {
    Result<std::unique_ptr<ForceGuard>> guard = line_->link->guard(encode(Command{}));
    if (!guard.ok())
        return guard.error();
    line_->pull.emplace(std::move(guard).value());
    return {};
}

std::optional<Reply> Falcon::exchange(const Command& command) {
    constexpr int asks = 10;
    constexpr int packets = 20; // most hold nothing but their status
    constexpr int wait_ms = 5;
    for (int i = 0; i < asks; ++i) {
        if (!line_->link->write(encode(command)))
            return std::nullopt;
        for (int k = 0; k < packets; ++k) {
            UsbPacket packet;
            const UsbGot got = line_->link->read(packet, wait_ms);
            if (got == UsbGot::lost)
                return std::nullopt;
            if (got == UsbGot::nothing)
                break;
            touch_.reply.reset();
            take(packet);
            if (touch_.reply)
                return touch_.reply;
        }
    }
    return std::nullopt;
}

Result<bool> Falcon::home() {
    Command command;
    command.homing = true;
    command.leds = led::blue;
    for (int i = 0; open_ && i < homing_exchanges; ++i) {
        const std::optional<Reply> reply = exchange(command);
        if (!reply)
            return Error{
                "The Falcon does not answer. Check that it is plugged in and has power, and try again."};
        if (reply->homed != 7)
            continue;
        homed_.store(true);
        exchange(Command{});
        return true;
    }
    return Error{
        "The Falcon is not homed yet. Home it again, and while its light is blue pull the grip out as far as "
        "it goes, then push it in."};
}

void Falcon::take(const UsbPacket& packet) noexcept {
    const std::uint64_t strays = touch_.stream.strays();
    for (const std::uint8_t byte : ftdi::received(packet.content()).payload) {
        const std::optional<Packet> whole = touch_.stream.push(byte);
        const std::optional<Reply> reply = whole ? decode_reply(*whole) : std::nullopt;
        if (reply)
            touch_.reply = reply;
        else if (whole)
            bad_readings_.fetch_add(1, std::memory_order_relaxed);
    }
    bad_readings_.fetch_add(touch_.stream.strays() - strays, std::memory_order_relaxed);
}

bool Falcon::locate(const Reply& reply, double now) noexcept {
    Angles angles;
    for (std::size_t i = 0; i < reply.encoders.size(); ++i)
        angles[static_cast<int>(i)] = angle_of(reply.encoders[i]);
    std::optional<Place> place = place_of(angles, touch_.place);
    if (!place)
        place = place_of(angles, middle);
    const std::optional<glm::dmat3> slope = place ? jacobian(*place, angles) : std::nullopt;
    const bool leaps =
        slope && touch_.jacobian && glm::length(*place - touch_.place) > quickest * (1 + touch_.unanswered);
    if (!slope || (leaps && ++touch_.leaps < leaps_of_a_new_place)) {
        bad_readings_.fetch_add(1, std::memory_order_relaxed);
        return false;
    }
    touch_.leaps = 0;
    touch_.place = *place;
    touch_.jacobian = slope;
    touch_.unanswered = 0;
    touch_.pane.feed(now, touch_.place.z);
    touch_.state.position = {1000.0 * touch_.place.x, 1000.0 * touch_.place.y};
    return true;
}

/// False where the reply says no place that can be believed.
bool Falcon::take_place(const Reply& reply, double now) noexcept {
    const bool knows = reply.homed == 7;
    homed_.store(knows, std::memory_order_relaxed);
    if (!knows)
        touch_.jacobian.reset();
    return !knows || locate(reply, now);
}

std::optional<DeviceState> Falcon::read(double now) noexcept {
    if (!open_)
        return std::nullopt;
    touch_.reply.reset();
    for (int i = 0; i < most_packets_a_read && !lost(); ++i) {
        UsbPacket packet;
        const UsbGot got = line_->link->read(packet, 0);
        if (got == UsbGot::nothing)
            break;
        if (got == UsbGot::lost)
            writer_->lose();
        else
            take(packet);
    }
    const bool newer = touch_.reply && take_place(*touch_.reply, now);
    touch_.pane.elapse(now);
    if (!newer)
        return std::nullopt;
    touch_.state.buttons = buttons_of(touch_.reply->buttons);
    touch_.state.time = now;
    return touch_.state;
}

bool Falcon::write(const SafeForce& force) noexcept {
    if (!open_ || lost())
        return false;
    unguarded_.store(line_->pull->unguarded(), std::memory_order_relaxed);
    const bool may_pull = homed() && !unguarded_.load(std::memory_order_relaxed);
    if (may_pull && force.newtons() == Vec2(0.0) && force.share() == 0.0)
        touch_.armed = true;
    else if (!may_pull || line_->pull->let_go())
        touch_.armed = false;
    Command command;
    command.homing = !homed();
    command.leds = touch_.armed ? led::green : led::red;
    touch_.unanswered = std::min(touch_.unanswered + 1, most_unanswered + 1);
    const bool knows = touch_.armed && touch_.jacobian && touch_.unanswered <= most_unanswered;
    const double off_the_pane = touch_.pane.force(knows ? force.share() : 0.0);
    if (knows)
        command.motors = motors_for(*touch_.jacobian, {force.newtons().x, force.newtons().y, off_the_pane});
    writer_->post(message_of(command));
    return true;
}

void Falcon::halt() noexcept {
    if (writer_)
        writer_->halt();
}

void Falcon::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void Falcon::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    if (!writer_->end())
        return;
    if (!lost() && !line_->pull->unguarded())
        line_->pull->dismiss();
    line_->pull.reset();
    line_->link.reset();
}

bool Falcon::lost() const noexcept { return writer_ && writer_->lost(); }

bool Falcon::motors_off() const noexcept { return open_ && !touch_.armed; }

std::string Falcon::complaint() const {
    if (unguarded_.load(std::memory_order_relaxed))
        return "The program that watches over the motors of the Falcon has ended, so they stay off. Start "
               "the device again.";
    return homed() ? std::string() : not_homed;
}

} // namespace tp
