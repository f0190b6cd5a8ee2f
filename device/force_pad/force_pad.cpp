// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/force_pad.hpp"

#include "device/force_pad/pad_frames.hpp"

#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int most_reports = 64;           ///< that one read drains
constexpr unsigned older_of_a_restart = 8; ///< PROTOCOL.md
constexpr std::uint64_t motors_bit = std::uint64_t{1} << 32;

std::uint64_t packed(const pad::ForceFrame& force) {
    return static_cast<std::uint16_t>(force.x_mn) |
           (static_cast<std::uint64_t>(static_cast<std::uint16_t>(force.y_mn)) << 16) |
           (force.motors ? motors_bit : 0);
}

pad::ForceFrame unpacked(std::uint64_t mail) {
    pad::ForceFrame force;
    force.x_mn = static_cast<std::int16_t>(mail & 0xFFFFu);
    force.y_mn = static_cast<std::int16_t>((mail >> 16) & 0xFFFFu);
    force.motors = (mail & motors_bit) != 0;
    return force;
}

} // namespace

bool ForcePad::Line::send(std::uint64_t message) noexcept {
    pad::ForceFrame force = unpacked(message);
    force.sequence = ++sequence;
    return transport->write(pad::encode(force));
}

ForcePad::ForcePad(Opener opener, LatestWriter::Thread thread)
    : opener_(std::move(opener)), thread_(thread) {}

ForcePad::~ForcePad() { stop(); }

template <typename Answer>
bool ForcePad::ask(const pad::Frame& question, Answer& answer) {
    constexpr int asks = 20;
    constexpr int reads = 20; // states come in between
    constexpr int wait_ms = 5;
    pad::AskFrame asked;
    pad::decode(question, asked);
    for (int i = 0; i < asks; ++i) {
        if (!line_->transport->write(question))
            return false;
        for (int k = 0; k < reads; ++k) {
            pad::Frame frame;
            const ReportTransport::Got got = line_->transport->read(frame, wait_ms);
            if (got == ReportTransport::Got::lost)
                return false;
            if (got != ReportTransport::Got::report || !pad::decode(frame, answer))
                continue;
            if constexpr (requires { answer.page; }) {
                if (answer.page != asked.page)
                    continue;
            }
            return true;
        }
    }
    return false;
}

Result<Capabilities> ForcePad::open() {
    stop();
    Result<std::unique_ptr<ReportTransport>> opened = opener_();
    if (!opened.ok())
        return Error{opened.error()};
    writer_.reset();
    line_ = std::make_shared<Line>();
    line_->transport = std::move(opened).value();
    heard_ = false;
    older_ = 0;
    time_us_ = 0;
    status_.store(0);
    bad_frames_.store(0);

    // Off first: what another program left on it ends here.
    constexpr pad::ForceFrame off;
    line_->transport->write(pad::encode(off));
    const auto question = [](pad::FrameType what, std::uint8_t page = 0) {
        return pad::encode(pad::AskFrame{.what = what, .page = page});
    };
    pad::IdentityFrame identity;
    pad::CapabilitiesFrame can;
    if (!ask(question(pad::FrameType::identity), identity) ||
        !ask(question(pad::FrameType::capabilities), can)) {
        line_->transport.reset();
        return Error{"The device with a force pad's ids does not answer like a force pad. Unplug it and plug "
                     "it in again; if it is not a force pad, choose another device."};
    }
    std::vector<Vec2> outline;
    for (std::uint8_t page = 0; outline.size() < can.corners; ++page) {
        pad::OutlineFrame corners;
        if (!ask(question(pad::FrameType::outline, page), corners) || corners.corners == 0) {
            line_->transport.reset();
            return Error{
                "The force pad did not say which places it reaches. Unplug it and plug it in again."};
        }
        for (int i = 0; i < corners.corners; ++i)
            outline.emplace_back(1e-3 * corners.x_um[i], 1e-3 * corners.y_um[i]);
    }
    Result<Capabilities> made = capabilities_of(can, identity.serial, outline);
    open_ = made.ok();
    if (!open_)
        line_->transport.reset();
    else
        writer_ = std::make_unique<LatestWriter>(line_, packed(off), thread_);
    return made;
}

Result<bool> ForcePad::home() {
    pad::CalibrationFrame calibration;
    if (!open_ || !ask(pad::encode(pad::CalibrateFrame{}), calibration) || !calibration.homed)
        return Error{"The force pad could not be homed. Check that it is plugged in, and try again."};
    return true;
}

/// A state with this number is newer, or the last of those that say that the pad was restarted. A pad that
/// repeats a state, or a few, was not.
bool ForcePad::counts(std::uint16_t sequence) noexcept {
    if (!heard_ || pad::newer(sequence, sequence_))
        return true;
    if (sequence == sequence_ || (older_ > 0 && sequence == older_sequence_))
        return false;
    older_ = older_ > 0 && pad::newer(sequence, older_sequence_) ? older_ + 1 : 1;
    older_sequence_ = sequence;
    return older_ >= older_of_a_restart;
}

void ForcePad::take(const pad::Frame& frame) noexcept {
    pad::StateFrame state;
    if (!pad::decode(frame, state)) {
        const pad::FrameType type = pad::type_of(frame);
        const bool late_answer = type == pad::FrameType::identity || type == pad::FrameType::capabilities ||
                                 type == pad::FrameType::outline || type == pad::FrameType::calibration;
        if (!late_answer)
            bad_frames_.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    if (!counts(state.sequence)) {
        bad_frames_.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    time_us_ += heard_ ? static_cast<std::int32_t>(state.time_us - clock_us_) : std::int64_t{state.time_us};
    clock_us_ = state.time_us;
    heard_ = true;
    fresh_ = true;
    older_ = 0;
    sequence_ = state.sequence;
    state_.time = 1e-6 * static_cast<double>(time_us_);
    state_.position = {1e-3 * state.x_um, 1e-3 * state.y_um};
    state_.buttons = state.buttons;
    status_.store(state.status, std::memory_order_relaxed);
}

std::optional<DeviceState> ForcePad::read(double) noexcept {
    if (!open_)
        return std::nullopt;
    fresh_ = false;
    for (int i = 0; i < most_reports && !lost(); ++i) {
        pad::Frame frame;
        const ReportTransport::Got got = line_->transport->read(frame, 0);
        if (got == ReportTransport::Got::nothing)
            break;
        if (got == ReportTransport::Got::lost)
            writer_->lose();
        else if (got == ReportTransport::Got::odd)
            bad_frames_.fetch_add(1, std::memory_order_relaxed);
        else
            take(frame);
    }
    if (!fresh_)
        return std::nullopt;
    return state_;
}

bool ForcePad::write(const SafeForce& force) noexcept {
    if (!open_ || lost())
        return false;
    writer_->post(packed(force_frame(force)));
    return true;
}

void ForcePad::halt() noexcept {
    if (writer_)
        writer_->halt();
}

void ForcePad::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void ForcePad::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    if (writer_->end()) // one that hangs keeps the transport; the pad's watchdog has taken the
                        // force away
        line_->transport.reset();
}

bool ForcePad::lost() const noexcept { return writer_ && writer_->lost(); }

bool ForcePad::motors_off() const noexcept {
    return heard_ && (status_.load(std::memory_order_relaxed) & pad::status::armed) == 0;
}

std::string ForcePad::complaint() const { return pad_sentence(status_.load(std::memory_order_relaxed)); }

} // namespace tp
