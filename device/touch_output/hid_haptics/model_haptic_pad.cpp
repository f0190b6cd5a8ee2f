// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tp {

namespace {

// clang-format off
constexpr std::uint8_t described[] = {
    0x05, 0x0D, 0x09, 0x05, 0xA1, 0x01,       // digitizers, touch pad, application
    0x85, 0x01,                               //   report 1
    0x05, 0x0D, 0x09, 0x22, 0xA1, 0x02,       //   finger
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x09, 0x42, 0x81, 0x02, // tip switch
    0x95, 0x03, 0x81, 0x03,                   //     padding
    0x75, 0x04, 0x95, 0x01, 0x25, 0x0F, 0x09, 0x51, 0x81, 0x02, // contact identifier
    0x05, 0x01, 0x26, 0xFF, 0x0F, 0x75, 0x10, 0x55, 0x0E, 0x65, 0x11, // hundredths of centimetres
    0x35, 0x00, 0x46, 0xE8, 0x03, 0x09, 0x30, 0x81, 0x02,       // x: 1000
    0x46, 0x58, 0x02, 0x26, 0xFF, 0x07, 0x09, 0x31, 0x81, 0x02, // y: 600
    0x55, 0x00, 0x65, 0x00, 0x45, 0x00,
    0xC0,
    0x05, 0x0D, 0x09, 0x22, 0xA1, 0x02,       //   a second finger
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x09, 0x42, 0x81, 0x02,
    0x95, 0x03, 0x81, 0x03,
    0x75, 0x04, 0x95, 0x01, 0x25, 0x0F, 0x09, 0x51, 0x81, 0x02,
    0x05, 0x01, 0x26, 0xFF, 0x0F, 0x75, 0x10, 0x55, 0x0E, 0x65, 0x11,
    0x35, 0x00, 0x46, 0xE8, 0x03, 0x09, 0x30, 0x81, 0x02,
    0x46, 0x58, 0x02, 0x26, 0xFF, 0x07, 0x09, 0x31, 0x81, 0x02,
    0x55, 0x00, 0x65, 0x00, 0x45, 0x00,
    0xC0,
    0x05, 0x09, 0x09, 0x01, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x81, 0x02, // button 1
    0x95, 0x07, 0x81, 0x03,
    0x05, 0x0E, 0x09, 0x01, 0xA1, 0x02,       //   haptics, simple haptics controller
    0x85, 0x02, 0x09, 0x10, 0xA1, 0x02,       //     report 2: waveform list
    0x05, 0x0A, 0x19, 0x03, 0x29, 0x06, 0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x04, 0xB1, 0x02,
    0xC0,
    0x05, 0x0E, 0x09, 0x11, 0xA1, 0x02,       //     duration list
    0x05, 0x0A, 0x19, 0x03, 0x29, 0x06, 0xB1, 0x02,
    0xC0,
    0x85, 0x03, 0x05, 0x0E,                   //     report 3
    0x15, 0x00, 0x25, 0x07, 0x75, 0x08, 0x95, 0x01, 0x09, 0x21, 0x91, 0x02, // manual trigger
    0x25, 0x64, 0x09, 0x23, 0x91, 0x02,       //     intensity
    0x25, 0x05, 0x09, 0x24, 0x91, 0x02,       //     repeat count
    0x26, 0xE8, 0x03, 0x75, 0x10, 0x09, 0x25, 0x91, 0x02, // retrigger period
    0xC0, 0xC0};
// clang-format on

void append16(std::vector<std::uint8_t>& bytes, double share, double most) {
    const auto value = static_cast<unsigned>(std::lround(most * std::clamp(share, 0.0, 1.0)));
    bytes.push_back(static_cast<std::uint8_t>(value));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8u));
}

} // namespace

std::span<const std::uint8_t> ModelHapticPad::descriptor() { return described; }

std::vector<std::uint8_t> ModelHapticPad::descriptor_without_trigger() {
    std::vector<std::uint8_t> bytes(std::begin(described), std::end(described));
    constexpr std::array<std::uint8_t, 4> trigger{0x09, 0x21, 0x91, 0x02};
    const auto at = std::search(bytes.begin(), bytes.end(), trigger.begin(), trigger.end());
    at[1] = 0x20; // auto trigger
    return bytes;
}

void ModelHapticPad::receive(std::span<const std::uint8_t> report) {
    if (report.size() < 6 || report[0] != 3)
        return;
    const unsigned ordinal = report[1];
    if (ordinal == 2)
        left_ms_ = 0;
    if (ordinal < 3 || ordinal > 6)
        return;
    ++ticks_;
    waveform_ = waveforms[ordinal - 3];
    strength_ = report[2] / 100.0;
    const bool goes_on = waveform_ == 0x1004;
    const int once = waveform_ == 0x1008 ? 20 : 10;
    left_ms_ = goes_on ? std::numeric_limits<int>::max() : once * (1 + report[3]);
}

std::vector<std::uint8_t> ModelHapticPad::feature(std::uint8_t id) const {
    if (id != 2)
        return {};
    std::vector<std::uint8_t> report;
    for (const std::uint16_t waveform : waveforms) {
        report.push_back(static_cast<std::uint8_t>(waveform));
        report.push_back(static_cast<std::uint8_t>(waveform >> 8u));
    }
    for (int i = 0; i < 4; ++i) { // of 10 ms
        report.push_back(10);
        report.push_back(0);
    }
    return report;
}

void ModelHapticPad::touch(std::size_t finger, Vec2 place, bool pressed) {
    Finger& one = fingers_[finger];
    if (!one.there)
        one.contact = static_cast<std::uint8_t>(contacts_++ & 0x0F);
    one.there = true;
    one.place = place;
    pressed_ = pressed;
}

void ModelHapticPad::step() {
    ++now_ms_;
    left_ms_ -= left_ms_ > 0 ? 1 : 0;
    const bool touched =
        std::any_of(fingers_.begin(), fingers_.end(), [](const Finger& finger) { return finger.there; });
    if (now_ms_ % 8 != 0 || (!touched && !told_touch_))
        return;
    told_touch_ = touched;
    std::vector<std::uint8_t> bytes{1};
    for (const Finger& finger : fingers_) {
        bytes.push_back(static_cast<std::uint8_t>((finger.there ? 1 : 0) | finger.contact << 4));
        append16(bytes, finger.place.x / 100.0 + 0.5, 4095.0);
        append16(bytes, 0.5 - finger.place.y / 60.0, 2047.0);
    }
    bytes.push_back(pressed_ && touched ? 1 : 0);
    unsaid_.push_back(std::move(bytes));
}

bool ModelHapticPad::report(std::vector<std::uint8_t>& bytes) {
    if (unsaid_.empty())
        return false;
    bytes = std::move(unsaid_.front());
    unsaid_.erase(unsaid_.begin());
    return true;
}

} // namespace tp
