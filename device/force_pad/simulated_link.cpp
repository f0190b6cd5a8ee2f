// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/simulated_link.hpp"

namespace tp {

bool SimulatedLink::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

void SimulatedLink::garble(pad::Frame& frame) {
    for (unsigned i = 0; i < 1 + random_() % 8; ++i)
        frame.bytes[random_() % pad::frame_size] = static_cast<std::uint8_t>(random_());
}

void SimulatedLink::advance() {
    constexpr std::size_t most_waiting = 64; // as the system keeps of reports that nobody reads
    ++now_;
    while (!to_pad_.empty() && to_pad_.front().due <= now_) {
        pad_.receive(to_pad_.front().frame);
        to_pad_.pop_front();
    }
    pad_.step();
    pad::Frame frame;
    while (pad_.report(frame)) {
        if (troubles.mute || troubles.unplugged || happens(troubles.drop))
            continue;
        (troubles.repeats ? frame : said_) = troubles.repeats ? said_ : frame;
        if (happens(troubles.garble))
            garble(frame);
        from_pad_.push_back({now_ + delay_ms_, frame});
        if (from_pad_.size() > most_waiting)
            from_pad_.pop_front();
    }
}

ReportTransport::Got SimulatedLink::read(pad::Frame& frame, int wait_ms) noexcept {
    for (;; --wait_ms) {
        if (troubles.unplugged)
            return Got::lost;
        if (!from_pad_.empty() && from_pad_.front().due <= now_) {
            frame = from_pad_.front().frame;
            from_pad_.pop_front();
            return happens(troubles.odd) ? Got::odd : Got::report;
        }
        if (wait_ms <= 0)
            return Got::nothing;
        advance();
    }
}

bool SimulatedLink::write(const pad::Frame& frame) noexcept {
    if (troubles.unplugged)
        return false;
    if (troubles.deaf || happens(troubles.drop))
        return true;
    pad::Frame sent = frame;
    if (happens(troubles.garble))
        garble(sent);
    to_pad_.push_back({now_ + 1 + delay_ms_, sent});
    return true;
}

} // namespace tp
