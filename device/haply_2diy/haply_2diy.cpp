// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/haply_2diy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr double answer_within = 0.005; ///< s; then the next command goes out without it
constexpr double step_within = 0.020;   ///< s without an answer before a board is taken to be out of step
constexpr unsigned most_rounds = 50;    ///< of bringing it back: a second
constexpr std::uint64_t most_under_way = 2;
constexpr std::uint64_t no_torque = 0;
constexpr std::uint64_t bring_into_step =
    1; ///< a bit that is 0 in every sendable torque; the round is above it
constexpr unsigned round_shift = 1;

std::uint64_t packed(const std::array<float, 2>& values) {
    return std::bit_cast<std::uint32_t>(values[0]) |
           static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(values[1])) << 32;
}

std::array<float, 2> unpacked_floats(std::uint64_t bits) {
    return {std::bit_cast<float>(static_cast<std::uint32_t>(bits)),
            std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32))};
}

} // namespace

bool Haply2diy::Wire::beat(bool pulls) noexcept {
    if (board.guard->beat(pulls) == ForceGuard::Word::here)
        return true;
    unguarded->store(true, std::memory_order_release);
    return false;
}

bool Haply2diy::Wire::send(std::uint64_t message) noexcept {
    if ((message & bring_into_step) != 0) {
        board.note.forget();
        beat(true); // what the board pulls until then nobody knows
        const haply::Reply last{haply::usual_id, unpacked_floats(angles.load(std::memory_order_acquire))};
        const auto round = static_cast<unsigned>(message >> round_shift);
        const bool sent =
            board.line->write(resynchronisation(arms.set_up(arms.angles_of(last)), round).view());
        commands.fetch_add(1, std::memory_order_release);
        return sent;
    }
    haply::Command command{haply::usual_id, unpacked_floats(message)};
    const bool pulls = message != no_torque;
    if (pulls && !beat(true))
        command.torque = {};
    if (!board.line->write(encode(command)))
        return false;
    if (!pulls)
        beat(false);
    commands.fetch_add(1, std::memory_order_release);
    return true;
}

Haply2diy::Haply2diy(HaplyGeneration generation, Opener opener, LatestWriter::Thread thread)
    : arms_(generation), opener_(std::move(opener)), thread_(thread) {}

Haply2diy::~Haply2diy() { stop(); }

/// The last nine bytes that come, if they are an answer.
std::optional<haply::Reply> Haply2diy::asked(std::span<const std::uint8_t> question, int wait_ms) {
    std::array<std::uint8_t, 256> bytes{};
    SerialLine& line = *wire_->board.line;
    for (int i = 0; i < 64 && line.read(bytes, 0) > 0; ++i) { // what nobody asked for now
    }
    if (!line.write(question))
        return std::nullopt;
    std::size_t size = 0;
    for (int waited = 0; waited <= wait_ms; ++waited) {
        const int got = line.read(std::span(bytes).subspan(size), 1);
        if (got < 0)
            return std::nullopt;
        size += static_cast<std::size_t>(got);
        if (size >= haply::reply_size) {
            const auto last = std::span(bytes).first(size).last<haply::reply_size>();
            const auto reply = haply::decode_reply(last);
            if (reply && reply->device_id == haply::usual_id && arms_.pose_at(arms_.angles_of(*reply)))
                return reply;
        }
        if (size == bytes.size())
            size = 0;
    }
    return std::nullopt;
}

bool Haply2diy::set_up_in_reference_pose() {
    constexpr unsigned tries = 5;
    constexpr int answer_ms = 50;
    constexpr double still_deg = 1.0;
    const std::array<double, 2> reference = arms_.reference_deg();
    wire_->board.note.forget();
    for (unsigned i = 0; i < tries; ++i) {
        const auto reply = asked(resynchronisation(arms_.set_up(reference), i).view(), answer_ms);
        if (!reply)
            continue;
        const std::array<double, 2> angles = arms_.angles_of(*reply);
        if (std::abs(angles[0] - reference[0]) < still_deg &&
            std::abs(angles[1] - reference[1]) < still_deg) {
            wire_->angles.store(packed(reply->angle_deg));
            return true;
        }
    }
    return false;
}

Result<Capabilities> Haply2diy::open() {
    constexpr int answer_ms = 50;
    stop();
    Result<Board> opened = opener_();
    if (!opened.ok())
        return Error{opened.error()};
    writer_.reset();
    wire_ = std::make_shared<Wire>(arms_, unguarded_);
    wire_->board = std::move(opened).value();
    heard_size_ = 0;
    skipping_ = false;
    believed_at_.reset();
    waiting_since_.reset();
    silent_since_.reset();
    commands_believed_ = 0;
    round_ = 0;
    answers_.store(0);
    bad_answers_.store(0);
    out_of_step_.store(false);
    lost_step_.store(false);
    unguarded_->store(false);

    // No torque first: what another program left on it ends here. A board that answers to that was set up
    // before.
    const auto counts = asked(encode(haply::Command{}), answer_ms);
    if (counts)
        wire_->angles.store(packed(counts->angle_deg));
    homed_.store(counts && wire_->board.note.holds());
    if (!homed_.load() && !set_up_in_reference_pose()) {
        wire_->board = {};
        return Error{"The device at the serial port does not answer like a Haply 2diy. Switch it on, unplug "
                     "it and plug it in again; if it is not a Haply 2diy, choose another device."};
    }
    Capabilities can;
    can.name = "Haply 2diy";
    can.serial_number = wire_->board.serial_number;
    can.workspace = arms_.workspace();
    can.max_force = arms_.force_in_the_middle();
    can.continuous_force = 0.47 * can.max_force; // 0.8 N; its maker names no figure
    can.resolution = arms_.resolution();
    can.delay = 0.002;
    can.calibrated = false; // reckoned from the motors' nominal torque
    writer_ = std::make_unique<LatestWriter>(wire_, no_torque, thread_);
    open_ = true;
    return can;
}

Result<bool> Haply2diy::home() {
    if (!open_ || !set_up_in_reference_pose())
        return Error{
            "The Haply 2diy could not be homed. Check that it is plugged in and switched on, and try again."};
    wire_->board.note.put();
    lost_step_.store(false);
    out_of_step_.store(false);
    believed_at_.reset();
    waiting_since_.reset();
    silent_since_.reset();
    homed_.store(true);
    return true;
}

bool Haply2diy::believable(const haply::Reply& reply, double now) const noexcept {
    if (reply.device_id != haply::usual_id || !arms_.pose_at(arms_.angles_of(reply)))
        return false;
    return !believed_at_ || haply::can_follow(believed_, reply, now - *believed_at_);
}

void Haply2diy::believe(const haply::Reply& reply, double now) noexcept {
    const auto pose = arms_.pose_at(arms_.angles_of(reply));
    believed_ = reply;
    believed_at_ = now;
    waiting_since_.reset();
    silent_since_.reset();
    commands_believed_ = wire_->commands.load(std::memory_order_acquire);
    answers_.store(std::min(answers_.load() + 1, commands_believed_));
    wire_->angles.store(packed(reply.angle_deg), std::memory_order_release);
    out_of_step_.store(false, std::memory_order_release);
    round_ = 0;
    fresh_ = true;
    skipping_ = false;
    state_.position = pose->place;
}

void Haply2diy::take_answers(double now) noexcept {
    std::size_t at = 0;
    while (heard_size_ - at >= haply::reply_size) {
        const auto frame = std::span(heard_).subspan(at).first<haply::reply_size>();
        const auto reply = haply::decode_reply(frame);
        if (reply && believable(*reply, now)) {
            believe(*reply, now);
            at += haply::reply_size;
        } else {
            if (!skipping_)
                bad_answers_.fetch_add(1, std::memory_order_relaxed);
            skipping_ = true;
            ++at;
        }
    }
    std::copy(heard_.begin() + static_cast<std::ptrdiff_t>(at),
              heard_.begin() + static_cast<std::ptrdiff_t>(heard_size_), heard_.begin());
    heard_size_ -= at;
}

void Haply2diy::take_bytes(double now) noexcept {
    constexpr int most_reads = 32;
    for (int i = 0; i < most_reads && !lost(); ++i) {
        const int got = wire_->board.line->read(std::span(heard_).subspan(heard_size_), 0);
        if (got == 0)
            return;
        if (got < 0) {
            writer_->lose();
            return;
        }
        heard_size_ += static_cast<std::size_t>(got);
        take_answers(now);
    }
}

void Haply2diy::keep_in_step(double now) noexcept {
    const std::uint64_t sent = wire_->commands.load(std::memory_order_acquire);
    if (sent != answers_.load()) {
        if (!waiting_since_)
            waiting_since_ = now;
        if (now - *waiting_since_ > answer_within) {
            answers_.store(sent); // lost; nothing is under way any more
            waiting_since_.reset();
            bad_answers_.fetch_add(1, std::memory_order_relaxed);
            heard_size_ = 0;
        }
    }
    if (sent == commands_believed_ || fresh_)
        return;
    if (!silent_since_)
        silent_since_ = now;
    else if (now - *silent_since_ > step_within)
        bring_back(now);
}

void Haply2diy::bring_back(double now) noexcept {
    silent_since_ = now;
    homed_.store(false);
    lost_step_.store(true);
    out_of_step_.store(true);
    if (++round_ > most_rounds)
        writer_->lose();
    else
        writer_->post(bring_into_step | std::uint64_t{round_} << round_shift);
}

std::optional<DeviceState> Haply2diy::read(double now) noexcept {
    if (!open_)
        return std::nullopt;
    fresh_ = false;
    take_bytes(now);
    if (!lost())
        keep_in_step(now);
    if (!fresh_)
        return std::nullopt;
    state_.time = now;
    return state_;
}

bool Haply2diy::write(const SafeForce& force) noexcept {
    if (!open_ || lost())
        return false;
    if (out_of_step_.load(std::memory_order_acquire))
        return true; // what brings it back is on its way, and takes the torque off
    std::uint64_t message = no_torque;
    if (!motors_off()) {
        const haply::Reply here{haply::usual_id,
                                unpacked_floats(wire_->angles.load(std::memory_order_acquire))};
        message = packed(arms_.command_of(arms_.torques(arms_.angles_of(here), force.newtons())).torque);
    }
    const bool pulls = message != no_torque;
    const bool lets_go = pulls_.load() && !pulls; // goes out whatever is under way
    const std::uint64_t under_way = wire_->commands.load(std::memory_order_acquire) - answers_.load();
    if (lets_go || under_way < most_under_way) {
        pulls_.store(pulls);
        writer_->post(message);
    }
    return true;
}

void Haply2diy::halt() noexcept {
    if (writer_)
        writer_->halt();
}

void Haply2diy::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void Haply2diy::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    const bool gone = lost();
    if (!writer_->end())
        return; // it holds the wire itself, and the guard hears nothing any more
    if (!gone && !out_of_step_.load() && !unguarded_->load())
        wire_->board.guard->dismiss();
    wire_->board.guard.reset();
    wire_->board.line.reset();
}

bool Haply2diy::lost() const noexcept { return writer_ && writer_->lost(); }

bool Haply2diy::motors_off() const noexcept {
    return !homed_.load(std::memory_order_acquire) || unguarded_->load(std::memory_order_acquire);
}

std::string Haply2diy::complaint() const {
    if (!open_)
        return {};
    if (unguarded_->load(std::memory_order_acquire))
        return "The program that watches over the motors of the Haply 2diy has ended, so they stay off. "
               "Start the device "
               "again.";
    if (lost_step_.load(std::memory_order_acquire))
        return "The Haply 2diy lost count of where its arms are. Put both arms on their marks and home it.";
    if (!homed_.load(std::memory_order_acquire))
        return "The Haply 2diy does not know where its arms are. Put both arms on their marks and home it.";
    return {};
}

} // namespace tp
