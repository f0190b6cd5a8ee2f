// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/haptic_pad.hpp"

#include "device/hid/report_descriptor.hpp"
#include "device/open_problem.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr std::uint64_t no_tick = 0;

/// The mailbox carries the ordinal of a waveform, its amplitude in 65 535ths and the number of the tick.
std::uint64_t packed(std::uint8_t ordinal, double amplitude, std::uint8_t tick) {
    return std::uint64_t{ordinal} | static_cast<std::uint64_t>(65535.0 * amplitude) << 16u |
           std::uint64_t{tick} << 32u;
}

const char* const device_words = "touch pad with haptics";

} // namespace

bool HapticPad::Line::send(std::uint64_t message) noexcept {
    const auto number = static_cast<std::uint8_t>(message >> 32u);
    bool taken = true;
    if (message == no_tick)
        taken = transport->send(haptics::stop(layout));
    else if (number != played) { // a writer may see one message twice
        played = number;
        taken = transport->send(haptics::trigger(layout, static_cast<std::uint8_t>(message),
                                                 static_cast<std::uint16_t>(message >> 16u) / 65535.0));
    }
    refuses.store(!taken, std::memory_order_relaxed);
    sent.fetch_add(1, std::memory_order_release);
    return true; // whether the device is gone is seen by reading
}

HapticPad::HapticPad(Opener opener, Identity identity, LatestWriter::Thread thread)
    : opener_(std::move(opener)), identity_(std::move(identity)), thread_(thread) {}

HapticPad::~HapticPad() { stop(); }

Result<TouchCapabilities> HapticPad::open() {
    stop();
    Result<std::unique_ptr<HapticsTransport>> opened = opener_();
    if (!opened.ok())
        return Error{opened.error()};
    writer_.reset();
    line_ = std::make_shared<Line>();
    line_->transport = std::move(opened).value();
    unplugged_.store(false);
    refuses_.store(false);
    watch_.restart();
    touch_ = PadTouch{};
    contact_.reset();

    hid::ReportDescriptor descriptor;
    const char* why_not = "what it says of itself cannot be read";
    if (hid::parse_report_descriptor(line_->transport->descriptor(), descriptor) ==
        hid::DescriptorFault::none)
        why_not = haptics::find_layout(descriptor, line_->layout);
    if (why_not == nullptr) {
        ordinals_ = haptics::read_ordinals(line_->layout, [this](std::uint8_t id, std::size_t bytes) {
            return line_->transport->feature(id, bytes);
        });
        if (!ordinals_.any())
            why_not = "it has no tick that ends by itself";
    }
    if (why_not != nullptr) {
        line_.reset();
        return Error{"The touch pad with haptics cannot be used: " + std::string(why_not) + "."};
    }
    // What another program left playing ends here.
    if (!line_->transport->send(haptics::stop(line_->layout))) {
        line_.reset();
        return Error{sentence(OpenProblem::other, this_system(), device_words)};
    }
    writer_ = std::make_unique<LatestWriter>(line_, no_tick, thread_);
    open_ = true;

    TouchCapabilities can;
    can.name = identity_.product.empty() ? device_words : identity_.product;
    can.serial_number = identity_.serial_number;
    can.means = TouchMeans::ticks;
    can.delay = delay_s;
    can.rate = 50.0;
    can.shortest_s = 0.01; // how long a click is, is the pad's own choice
    if (line_->layout.pad)
        can.pad = Rect{-0.5 * line_->layout.pad->size, 0.5 * line_->layout.pad->size};
    return can;
}

void HapticPad::take(const haptics::Fingers& fingers, double now) noexcept {
    const auto of_contact = [&fingers](auto holds) {
        return std::find_if(fingers.fingers.begin(), fingers.fingers.end(),
                            [&](const haptics::Finger& finger) { return finger.there && holds(finger); });
    };
    auto counts = of_contact([this](const haptics::Finger& finger) { return contact_ == finger.contact; });
    if (counts == fingers.fingers.end())
        counts = of_contact([](const haptics::Finger&) { return true; });
    touch_.time = now;
    touch_.touched = counts != fingers.fingers.end();
    touch_.buttons = fingers.pressed ? 1 : 0;
    contact_ = touch_.touched ? std::optional(counts->contact) : std::nullopt;
    if (touch_.touched)
        touch_.place = counts->place;
}

std::optional<PadTouch> HapticPad::read(double now) noexcept {
    if (!open_)
        return std::nullopt;
    constexpr int most_reports = 64; ///< that one read drains
    bool fresh = false;
    HapticsTransport::Input report;
    for (int i = 0; i < most_reports && !lost(); ++i) {
        const HapticsTransport::Got got = line_->transport->read(report, 0);
        if (got == HapticsTransport::Got::nothing)
            break;
        if (got == HapticsTransport::Got::lost) {
            unplugged_.store(true);
            writer_->lose();
        } else if (const auto fingers = haptics::fingers_in(line_->layout, report.all())) {
            take(*fingers, now);
            fresh = true;
        }
    }
    if (lost())
        return std::nullopt;
    watch_.look(line_->sent.load(std::memory_order_acquire), now);
    refuses_.store(line_->refuses.load(std::memory_order_relaxed), std::memory_order_relaxed);
    return fresh ? std::optional(touch_) : std::nullopt;
}

bool HapticPad::tick(const Tick& tick) noexcept {
    if (!open_ || lost() || watch_.hangs())
        return false; // what is felt much later would tell of another place
    if (tick.empty())
        return true;
    watch_.posted();
    writer_->post(packed(ordinals_.of(tick.sharpness()), tick.amplitude(), ++line_->posted));
    return !refuses_.load(std::memory_order_relaxed);
}

void HapticPad::halt() noexcept {
    if (writer_)
        writer_->halt();
}

void HapticPad::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void HapticPad::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    if (writer_->end()) // one that hangs keeps the transport; the last tick has ended by itself
        line_->transport.reset();
}

std::string HapticPad::complaint() const {
    if (unplugged_.load())
        return sentence(OpenProblem::gone, this_system(), device_words);
    if (refuses_.load(std::memory_order_relaxed) || watch_.hangs())
        return "The touch pad with haptics does not take the ticks. Close other programs that use it.";
    return {};
}

} // namespace tp
