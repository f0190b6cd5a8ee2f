// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/steam_pad.hpp"

#include "device/open_problem.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr double renew_after = 1.0; ///< s; SDL does it about as often
constexpr std::uint64_t nothing_felt = 0;

std::uint64_t packed(const SteamMail& mail) {
    return std::uint64_t{mail.pulses.on_us} | std::uint64_t{mail.pulses.off_us} << 16u |
           std::uint64_t{mail.pulses.count} << 32u |
           std::uint64_t{static_cast<std::uint8_t>(mail.pulses.gain_db)} << 40u |
           std::uint64_t{mail.side == steam::Side::right} << 48u | std::uint64_t{mail.tick} << 49u |
           std::uint64_t{mail.renewal} << 56u;
}

SteamMail unpacked(std::uint64_t word) {
    SteamMail mail;
    mail.pulses.on_us = static_cast<std::uint16_t>(word & 0xFFFFu);
    mail.pulses.off_us = static_cast<std::uint16_t>(word >> 16u & 0xFFFFu);
    mail.pulses.count = static_cast<std::uint8_t>(word >> 32u & 0xFFu);
    mail.pulses.gain_db = static_cast<std::int8_t>(word >> 40u & 0xFFu);
    mail.side = (word >> 48u & 1u) != 0 ? steam::Side::right : steam::Side::left;
    mail.tick = static_cast<std::uint8_t>(word >> 49u & 0x7Fu);
    mail.renewal = static_cast<std::uint8_t>(word >> 56u & 0xFFu);
    return mail;
}

/// From 1 on, so that no message but the one of nothing felt is 0.
std::uint8_t after(std::uint8_t number, std::uint8_t most) {
    return number >= most ? std::uint8_t{1} : static_cast<std::uint8_t>(number + 1);
}

const char* name_of(steam::Kind kind) {
    return kind == steam::Kind::deck ? "Steam Deck" : "Steam Controller";
}

} // namespace

bool SteamPad::Line::send_all(const std::array<steam::Feature, 2>& reports) noexcept {
    return std::all_of(reports.begin(), reports.end(),
                       [this](const steam::Feature& report) { return transport->send(report); });
}

bool SteamPad::Line::send(std::uint64_t message) noexcept {
    const SteamMail mail = unpacked(message);
    bool taken = true;
    if (mail.tick == 0)
        taken = (message != nothing_felt && tick == 0) || transport->send(steam::play_nothing());
    else if (mail.tick != tick)
        taken = transport->send(steam::play(mail.side, mail.pulses));
    tick = mail.tick;
    if (message != nothing_felt && mail.renewal != renewal) {
        renewal = mail.renewal;
        taken = send_all(steam::imitate_nothing(transport->kind())) && taken;
    }
    refuses.store(!taken, std::memory_order_relaxed);
    sent.fetch_add(1, std::memory_order_release);
    return true; // whether the device is gone is seen by reading
}

SteamPad::SteamPad(std::vector<Opener> openers, std::string serial_number, LatestWriter::Thread thread)
    : openers_(std::move(openers)), serial_number_(std::move(serial_number)), thread_(thread) {}

SteamPad::~SteamPad() { stop(); }

/// A receiver is there without a controller; what it answers may be lost among other reports.
Result<bool> SteamPad::begin(const Opener& opener) {
    Result<std::unique_ptr<SteamTransport>> opened = opener();
    if (!opened.ok())
        return Error{opened.error()};
    line_ = std::make_shared<Line>();
    line_->transport = std::move(opened).value();
    kind_ = line_->transport->kind();
    constexpr int asks = 10;
    constexpr int reads = 50;
    constexpr int wait_ms = 20;
    bool heard = kind_ != steam::Kind::receiver;
    for (int i = 0; i < asks && !heard; ++i) {
        line_->transport->send(steam::ask_whether_connected());
        SteamTransport::Input report;
        for (int k = 0; k < reads && !heard; ++k) {
            if (line_->transport->read(report, wait_ms) != SteamTransport::Got::report)
                break;
            const steam::News news = steam::news_of(report.all());
            heard = news.pads_told || news.connected.value_or(false);
            if (news.connected == false)
                return Error{"No Steam Controller is switched on near its receiver. Press its middle button "
                             "and try again."};
        }
    }
    if (heard && line_->send_all(steam::imitate_nothing(kind_)))
        return true;
    line_->send_all(steam::imitate_as_usual()); // one of them may have been taken
    return Error{std::string("The ") + name_of(kind_) +
                 " does not answer. Close other programs that use it, such as Steam, and try again."};
}

Result<TouchCapabilities> SteamPad::open() {
    stop();
    writer_.reset();
    trouble_.store(Trouble::none);
    halted_.store(false);
    refuses_.store(false);
    watch_.restart();
    touch_ = PadTouch{};
    renewed_.reset();
    mail_ = SteamMail{};
    Result<bool> begun = Error{std::string()};
    for (const Opener& opener : openers_)
        if (begun = begin(opener); begun.ok())
            break;
    if (!begun.ok()) {
        line_.reset();
        return Error{begun.error()};
    }
    writer_ = std::make_unique<LatestWriter>(line_, nothing_felt, thread_);
    open_ = true;

    TouchCapabilities can;
    can.name = name_of(kind_);
    can.serial_number = serial_number_;
    can.means = TouchMeans::ticks;
    can.delay = delay_s(kind_);
    can.rate = kind_ == steam::Kind::receiver ? 50.0 : 125.0;
    can.shortest_s = 0.002;
    const double half = 0.5 * steam::pad_width_mm(kind_);
    can.pad = Rect{Vec2(-half), Vec2(half)};
    return can;
}

void SteamPad::take(const steam::News& news, double now) noexcept {
    if (news.connected == false) {
        trouble_.store(Trouble::switched_off);
        writer_->lose();
    }
    if (!news.pads_told)
        return;
    const auto pad_of = [&news](steam::Side side) -> const steam::Pad& {
        return news.pads[static_cast<std::size_t>(side)];
    };
    const steam::Side other = side_ == steam::Side::left ? steam::Side::right : steam::Side::left;
    if (!pad_of(side_).touched && pad_of(other).touched)
        side_ = other;
    const steam::Pad& pad = pad_of(side_);
    touch_.time = now;
    touch_.touched = pad.touched;
    if (pad.touched && pad.place)
        touch_.place = *pad.place;
    touch_.buttons = pad.pressed ? 1 : 0;
    fresh_ = true;
}

void SteamPad::post() noexcept {
    const SteamMail still{{}, mail_.side, 0, mail_.renewal};
    watch_.posted();
    writer_->post(packed(halted_.load() ? still : mail_));
    if (halted_.load()) // by another thread, meanwhile
        writer_->post(packed(still));
}

/// Renews what keeps the pads from imitating a mouse, and notes a writer that hangs.
void SteamPad::keep_up(double now) noexcept {
    watch_.look(line_->sent.load(std::memory_order_acquire), now);
    refuses_.store(line_->refuses.load(std::memory_order_relaxed), std::memory_order_relaxed);
    if (!renewed_)
        renewed_ = now;
    if (now - *renewed_ < renew_after)
        return;
    renewed_ = now;
    mail_.renewal = after(mail_.renewal, 0xFF);
    post();
}

std::optional<PadTouch> SteamPad::read(double now) noexcept {
    if (!open_)
        return std::nullopt;
    constexpr int most_reports = 64; ///< that one read drains
    fresh_ = false;
    SteamTransport::Input report;
    for (int i = 0; i < most_reports && !lost(); ++i) {
        const SteamTransport::Got got = line_->transport->read(report, 0);
        if (got == SteamTransport::Got::nothing)
            break;
        if (got == SteamTransport::Got::report) {
            take(steam::news_of(report.all()), now);
        } else {
            trouble_.store(Trouble::unplugged);
            writer_->lose();
        }
    }
    if (lost())
        return std::nullopt;
    keep_up(now);
    return fresh_ ? std::optional(touch_) : std::nullopt;
}

bool SteamPad::tick(const Tick& tick) noexcept {
    if (!open_ || lost() || watch_.hangs())
        return false; // what is felt much later would tell of another place
    if (tick.empty())
        return true;
    mail_ = SteamMail{steam::pulses_of(tick, kind_), side_, after(mail_.tick, 0x7F), mail_.renewal};
    halted_.store(false);
    post();
    return !refuses_.load(std::memory_order_relaxed);
}

void SteamPad::halt() noexcept {
    halted_.store(true);
    if (writer_)
        writer_->halt();
}

void SteamPad::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void SteamPad::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    const bool gone = lost();
    if (!writer_->end())
        return; // it hangs, and keeps the transport; the last tick has ended by itself
    if (!gone)
        line_->send_all(steam::imitate_as_usual());
    line_->transport.reset();
}

std::string SteamPad::complaint() const {
    const Trouble trouble = trouble_.load();
    if (trouble == Trouble::unplugged)
        return sentence(OpenProblem::gone, this_system(), name_of(kind_));
    if (trouble == Trouble::switched_off)
        return "The Steam Controller was switched off, or is too far from its receiver. Press its middle "
               "button.";
    if (refuses_.load(std::memory_order_relaxed) || watch_.hangs())
        return std::string("The ") + name_of(kind_) +
               " does not take the ticks. Close other programs that use it, such as Steam.";
    return {};
}

} // namespace tp
