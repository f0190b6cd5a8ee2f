// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/pid_joystick.hpp"

#include "device/hid/report_descriptor.hpp"
#include "device/hid_pid/pid_layout.hpp"
#include "device/open_problem.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int most_input_reports = 64;    ///< that one read drains
constexpr int full_queue = 63;            ///< reports, of hidraw, which then drops what comes
constexpr double start_anew_after = 30.0; ///< s; less than half of 65.5 s
constexpr double enable_every = 0.25;     ///< s, while the motors are off
constexpr double stuck_after = 0.020;     ///< s without a message that the device took

/// Messages after which a force that did not change is told again: one that got lost does not stay for long.
constexpr unsigned tell_again_after = 16;

constexpr std::array both_axes{hid::Along::x, hid::Along::y};

constexpr unsigned count_mask = 0xFF;
constexpr std::uint64_t no_shares = 0; ///< JoystickMessage{}.word()

std::string joystick_is_gone() { return sentence(OpenProblem::gone, this_system(), "force stick"); }

int whole_share(double share) { return static_cast<int>(std::clamp(share, -1.0, 1.0) * hid::full_share); }

} // namespace

std::uint64_t PidJoystick::JoystickMessage::word() const {
    const auto bits = [](int one) { return std::uint64_t{static_cast<std::uint16_t>(one)}; };
    return bits(share[0]) | bits(share[1]) << 16 | std::uint64_t{starts[0] & count_mask} << 32 |
           std::uint64_t{starts[1] & count_mask} << 40 | std::uint64_t{enables & count_mask} << 48;
}

PidJoystick::JoystickMessage PidJoystick::JoystickMessage::of(std::uint64_t word) {
    const auto bits = [word](int shift) { return static_cast<std::int16_t>(word >> shift & 0xFFFFu); };
    const auto count = [word](int shift) { return static_cast<unsigned>(word >> shift) & count_mask; };
    return {{bits(0), bits(16)}, {count(32), count(40)}, count(48)};
}

bool PidJoystick::Line::send(std::uint64_t word) noexcept {
    JoystickMessage message = JoystickMessage::of(word);
    const bool whole = pull->send(message.pulls(), [&](bool with_force) {
        if (!with_force)
            message.share = {};
        return write(message);
    });
    if (whole)
        taken.fetch_add(1, std::memory_order_release);
    return whole;
}

bool PidJoystick::Line::write(const JoystickMessage& message) noexcept {
    bool whole = true;
    // Each message tells at least one force, as a sign of life: where none has changed, the one told longer
    // ago.
    const std::size_t older = untold[1] > untold[0] ? 1 : 0;
    const bool none_changed = share == message.share;
    for (std::size_t i = 0; i < 2 && whole; ++i) {
        const bool changed = std::exchange(share[i], message.share[i]) != message.share[i];
        if (++untold[i]; changed || (none_changed && i == older) || untold[i] >= tell_again_after) {
            whole = transport->write(hid::force_report(layout, block[i], share[i]));
            untold[i] = 0;
        }
    }
    const bool enabled_anew = std::exchange(enables, message.enables) != message.enables;
    if (enabled_anew && layout.control.enable.there())
        whole = whole && transport->write(hid::control_report(layout, layout.control.enable));
    for (std::size_t i = 0; i < 2 && whole; ++i)
        if (std::exchange(starts[i], message.starts[i]) != message.starts[i] || enabled_anew)
            whole = transport->write(hid::start_report(layout, block[i]));
    return whole;
}

PidJoystick::PidJoystick(Opener opener, Identity identity, const JoystickScale& scale,
                         LatestWriter::Thread thread)
    : opener_(std::move(opener)), identity_(std::move(identity)), scale_(scale), thread_(thread) {}

PidJoystick::~PidJoystick() { stop(); }

bool PidJoystick::control(const hid::Choice& what) {
    return !what.there() || line_->transport->write(hid::control_report(line_->layout, what));
}

PidJoystick::Loading PidJoystick::load_effect(hid::Along along) {
    constexpr int asks = 20; // a device may take a while
    PidTransport& transport = *line_->transport;
    if (!transport.set_feature(hid::create_report(line_->layout)))
        return Loading::refused;
    for (int i = 0; i < asks; ++i) {
        hid::Report answer = hid::asking_for(line_->layout.block_load.report);
        if (!transport.get_feature(answer))
            continue;
        const hid::LoadedBlock loaded = hid::loaded_block(line_->layout, answer.all());
        if (loaded.status == hid::LoadedBlock::Status::full)
            return Loading::full;
        if (loaded.status != hid::LoadedBlock::Status::success)
            continue;
        line_->block[along == hid::Along::x ? 0 : 1] = loaded.block;
        return Loading::done;
    }
    return Loading::refused;
}

std::string PidJoystick::put_effects_on_it() {
    const hid::PidLayout& layout = line_->layout;
    PidTransport& transport = *line_->transport;
    Loading loading = Loading::full;
    for (int attempt = 0; attempt < 2 && loading == Loading::full; ++attempt) {
        line_->block = {};
        // What another program left on it ends here.
        if (!control(layout.control.stop_all) || !control(layout.control.reset) ||
            !control(layout.control.enable) ||
            (layout.gain.report.there() && !transport.write(hid::full_gain_report(layout))))
            return joystick_is_gone();
        if (attempt > 0 && layout.free.report.there())
            for (std::int64_t block = 1; block <= std::min<std::int64_t>(layout.free.block.most, 255);
                 ++block)
                transport.write(hid::free_report(layout, static_cast<std::uint8_t>(block)));
        for (const hid::Along along : both_axes) {
            loading = load_effect(along);
            if (loading != Loading::done)
                break;
        }
    }
    if (loading == Loading::full)
        return "The force stick has no room for a force. Close other programs that use it, unplug it and "
               "plug it in again.";
    if (loading != Loading::done || line_->block[0] == line_->block[1])
        return "The force stick does not take up a force. Unplug it and plug it in again.";
    for (std::size_t i = 0; i < 2; ++i) {
        const std::uint8_t block = line_->block[i];
        no_force_[i] = hid::force_report(layout, block, 0);
        if (!transport.write(hid::effect_report(layout, block, both_axes[i])) ||
            !transport.write(no_force_[i]) || !transport.write(hid::start_report(layout, block)))
            return joystick_is_gone();
    }
    return {};
}

std::vector<hid::Report> PidJoystick::effects_away() const {
    const hid::PidLayout& layout = line_->layout;
    std::vector<hid::Report> reports;
    for (const std::uint8_t block : line_->block) {
        if (block != 0 && layout.operation.stop.there())
            reports.push_back(hid::stop_report(layout, block));
        if (block != 0 && layout.free.report.there())
            reports.push_back(hid::free_report(layout, block));
    }
    if (layout.control.disable.there())
        reports.push_back(hid::control_report(layout, layout.control.disable));
    return reports;
}

void PidJoystick::take_effects_away() noexcept {
    for (const std::uint8_t block : line_->block)
        if (block != 0)
            line_->transport->write(hid::force_report(line_->layout, block, 0));
    for (const hid::Report& report : effects_away())
        line_->transport->write(report);
}

std::string PidJoystick::begin_to_guard() {
    Result<std::unique_ptr<ForceGuard>> guard = line_->transport->guard(no_force_, effects_away());
    if (!guard.ok())
        return guard.error();
    line_->pull.emplace(std::move(guard).value());
    return {};
}

bool PidJoystick::assume(double newtons_at_full, Vec2 sign) noexcept {
    share_per_newton_[0].store(sign.x / newtons_at_full, std::memory_order_relaxed);
    share_per_newton_[1].store(sign.y / newtons_at_full, std::memory_order_relaxed);
    return true;
}

Result<Capabilities> PidJoystick::open() {
    stop();
    Result<std::unique_ptr<PidTransport>> opened = opener_();
    if (!opened.ok())
        return Error{opened.error()};
    writer_.reset();
    line_ = std::make_shared<Line>();
    line_->transport = std::move(opened).value();
    assume(scale_.newtons_at_full, scale_.sign);
    ticked_ = heard_ = safety_switch_off_ = stuck_ = off_ = false;
    stamps_ = {};
    motors_on_ = true;
    taken_ = 0;
    starts_ = {};
    enables_ = 0;
    trouble_.store(Trouble::none);

    const auto unusable = [this](const std::string& why) {
        line_->transport.reset();
        return Error{"The force stick cannot be used: " + why + "."};
    };
    hid::ReportDescriptor descriptor;
    if (hid::parse_report_descriptor(line_->transport->descriptor(), descriptor) !=
        hid::DescriptorFault::none)
        return unusable("what it reports of itself makes no sense");
    if (const char* const lacks = hid::find_layout(descriptor, line_->layout); lacks != nullptr)
        return unusable(lacks);
    std::string why = put_effects_on_it();
    if (why.empty())
        why = begin_to_guard();
    if (!why.empty()) {
        take_effects_away();
        line_->transport.reset();
        return Error{why};
    }
    const hid::PidLayout& layout = line_->layout;
    if (hid::Report report = hid::asking_for(layout.stick.report);
        line_->transport->input_now(report) == PidTransport::Got::report)
        take(report);

    Capabilities can;
    can.name = "force stick";
    can.serial_number = identity_.serial_number;
    can.workspace = {
        {-lever_mm, -lever_mm}, {lever_mm, -lever_mm}, {lever_mm, lever_mm}, {-lever_mm, lever_mm}};
    can.max_force =
        scale_.measured ? std::min(most_newtons, scale_.newtons_at_full) : most_newtons_unmeasured;
    can.continuous_force = can.max_force;
    for (const hid::Slot& axis : layout.stick.axis)
        can.resolution =
            std::max(can.resolution, 2.0 * lever_mm / static_cast<double>(axis.most - axis.least));
    can.rate = 1000.0;
    can.delay = 0.004; // two reports of a full-speed interface each way
    can.calibrated = scale_.measured;
    writer_ = std::make_unique<LatestWriter>(line_, no_shares, thread_);
    halting_.store(line_->transport.get());
    open_ = true;
    return can;
}

bool PidJoystick::take(const hid::Report& report) noexcept {
    const hid::JoystickNews news = hid::joystick_news(line_->layout, report.all());
    if (news.axes) {
        heard_ = true;
        state_.position = lever_mm * Vec2(news.axes->x, -news.axes->y);
        state_.buttons = news.buttons;
    }
    if (news.motors_on) {
        motors_on_ = *news.motors_on;
        safety_switch_off_ = news.safety_switch_off;
    }
    return news.axes.has_value();
}

bool PidJoystick::take_reports() noexcept {
    for (int i = 0; i < most_input_reports && !lost(); ++i) {
        hid::Report report;
        const PidTransport::Got got = line_->transport->read(report, 0);
        if (got == PidTransport::Got::nothing)
            return i < full_queue;
        if (got == PidTransport::Got::lost)
            writer_->lose();
        else if (take(report))
            stamps_.reported(report, now_);
    }
    return false;
}

void PidJoystick::watch_the_writer() noexcept {
    const std::uint32_t taken = line_->taken.load(std::memory_order_acquire);
    if (taken != std::exchange(taken_, taken))
        taken_at_ = now_;
    stuck_ = now_ - taken_at_ > stuck_after;
}

std::optional<DeviceState> PidJoystick::read(double now) noexcept {
    if (!open_)
        return std::nullopt;
    now_ = now;
    if (!std::exchange(ticked_, true)) {
        taken_at_ = enabled_at_ = now;
        started_at_ = {now, now - 0.5 * start_anew_after}; // never both in one message
    }
    const bool newest = take_reports();
    watch_the_writer();
    const bool unguarded = line_->pull->unguarded();
    trouble_.store(unguarded            ? Trouble::unguarded
                   : stuck_             ? Trouble::takes_nothing
                   : safety_switch_off_ ? Trouble::safety_switch
                   : !motors_on_        ? Trouble::actuators_off
                                        : Trouble::none,
                   std::memory_order_relaxed);
    off_ = off_ || stuck_ || !motors_on_ || unguarded || line_->pull->let_go();
    if (lost() || !heard_ || !newest)
        return std::nullopt;
    const std::optional<double> stamp = stamps_.next(taken_at_);
    if (!stamp)
        return std::nullopt;
    state_.time = *stamp;
    return state_;
}

void PidJoystick::keep_the_effects_alive(bool given_no_force) noexcept {
    for (std::size_t i = 0; i < 2; ++i)
        if (now_ - started_at_[i] >= start_anew_after) {
            started_at_[i] = now_;
            ++starts_[i];
        }
    if (!motors_on_ && given_no_force && now_ - enabled_at_ >= enable_every) {
        enabled_at_ = now_;
        ++enables_;
    }
}

void PidJoystick::post(Vec2 newtons) noexcept {
    JoystickMessage message;
    message.share = {whole_share(share_per_newton_[0].load(std::memory_order_relaxed) * newtons.x),
                     whole_share(share_per_newton_[1].load(std::memory_order_relaxed) * newtons.y)};
    message.starts = starts_;
    message.enables = enables_;
    writer_->post(message.word());
}

bool PidJoystick::write(const SafeForce& force) noexcept {
    if (!open_ || lost())
        return false;
    const bool given_no_force = force.newtons() == Vec2(0.0);
    keep_the_effects_alive(given_no_force);
    if (given_no_force)
        off_ = stuck_ || !motors_on_ || line_->pull->unguarded();
    post(off_ ? Vec2(0.0) : force.newtons());
    return true;
}

void PidJoystick::halt() noexcept {
    PidTransport* const transport = halting_.load();
    if (transport == nullptr)
        return;
    writer_->halt();
    for (const hid::Report& none : no_force_)
        transport->write_from_signal(none);
}

void PidJoystick::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void PidJoystick::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    const bool ended = writer_->end();
    halting_.store(nullptr);
    PidTransport& transport = *line_->transport;
    if (!ended) {
        for (const hid::Report& none : no_force_)
            transport.write_from_signal(none);
        return;
    }
    if (!lost()) {
        take_effects_away();
        if (!line_->pull->unguarded())
            line_->pull->dismiss();
    }
    line_->pull.reset();
    line_->transport.reset();
}

bool PidJoystick::lost() const noexcept { return writer_ && writer_->lost(); }

bool PidJoystick::motors_off() const noexcept { return open_ && off_; }

std::string PidJoystick::complaint() const {
    switch (trouble_.load(std::memory_order_relaxed)) {
    case Trouble::none:
        return {};
    case Trouble::safety_switch:
        return "The force stick's safety switch keeps its motors off. Hold the grip as its maker says, or "
               "release the "
               "switch.";
    case Trouble::actuators_off:
        return "The force stick has switched its motors off. Check that its power supply is plugged in and "
               "that no other "
               "program uses it.";
    case Trouble::unguarded:
        return "The program that watches over the motors of the force stick has ended, so they stay off. "
               "Start "
               "the device again.";
    case Trouble::takes_nothing:
        return "The force stick does not take what this computer sends. It goes on by itself when it does.";
    }
    return {};
}

} // namespace tp
