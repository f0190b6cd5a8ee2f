// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/model_steam_pad.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t left = 0;
constexpr std::size_t right = 1;

void put16(std::vector<std::uint8_t>& bytes, std::size_t at, double share) {
    const auto value = static_cast<std::int16_t>(std::lround(32767.0 * std::clamp(share, -1.0, 1.0)));
    bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
    bytes[at + 1] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(value) >> 8);
}

double get16(std::span<const std::uint8_t> bytes, std::size_t at) {
    return bytes[at] + 256.0 * bytes[at + 1];
}

/// What a sensor tells that is itself turned by so many degrees, counterclockwise.
Vec2 turned(Vec2 way, double degrees) {
    const double angle = -degrees / 57.29577951;
    return {std::cos(angle) * way.x - std::sin(angle) * way.y,
            std::sin(angle) * way.x + std::cos(angle) * way.y};
}

} // namespace

bool ModelSteamPad::receive(std::span<const std::uint8_t> report) {
    if (report.size() != 65 || report[0] != 0)
        return false;
    if (kind_ == steam::Kind::receiver && report[1] == 0xB4) {
        std::vector<std::uint8_t> event(64);
        event[0] = 1;
        event[2] = 3;
        event[3] = 1;
        event[4] = on_ ? 2 : 1;
        unsaid_.push_back(std::move(event));
        return true;
    }
    if (!on_)
        return false;
    switch (report[1]) {
    case 0x81:
        keys_ = false;
        break;
    case 0x85:
        keys_ = true;
        break;
    case 0x87:
        for (std::size_t at = 3; at < 3u + report[2] && at + 2 < report.size(); at += 3)
            if (report[at] == 0x08)
                mouse_ = get16(report, at + 1) != 7.0;
        if (!mouse_)
            untold_ms_ = 0.0;
        break;
    case 0x8E:
        mouse_ = true;
        break;
    case 0x8F:
        play(report.subspan(2));
        break;
    default:
        break;
    }
    return true;
}

void ModelSteamPad::play(std::span<const std::uint8_t> command) {
    if (command[0] != 8)
        return;
    const double on = get16(command, 2);
    const double off = get16(command, 4);
    const double count = get16(command, 6);
    const int gain = command[8] < 128 ? command[8] : command[8] - 256; // two's complement
    Playing playing;
    if (on > 0.0 && count > 0.0) {
        playing.left_us = count * (on + off);
        playing.strength = 2.0 * on / (on + off);
        if (kind_ == steam::Kind::deck)
            playing.strength *= std::pow(10.0, (gain - 6) / 20.0);
        ++ticks_;
        longest_ms_ = std::max(longest_ms_, 1e-3 * playing.left_us);
    }
    if (command[1] == 0 || command[1] == 2)
        playing_[right] = playing;
    if (command[1] == 1 || command[1] == 2)
        playing_[left] = playing;
}

void ModelSteamPad::touch(steam::Side side, Vec2 place, bool pressed) {
    thumbs_[static_cast<std::size_t>(side)] = {true, pressed, place};
}

void ModelSteamPad::switch_on(bool on) {
    if (on_ == on)
        return;
    on_ = on;
    playing_ = {};
    keys_ = mouse_ = true;
    std::vector<std::uint8_t> event(64);
    event[0] = 1;
    event[2] = 3;
    event[3] = 1;
    event[4] = on ? 2 : 1;
    unsaid_.push_back(std::move(event));
}

double ModelSteamPad::felt(steam::Side side) const {
    const Playing& playing = playing_[static_cast<std::size_t>(side)];
    return playing.left_us > 0.0 ? playing.strength : 0.0;
}

std::vector<std::uint8_t> ModelSteamPad::state() {
    const bool deck = kind_ == steam::Kind::deck;
    const double half = deck ? 16.25 : 20.0;
    std::vector<std::uint8_t> bytes(64);
    bytes[0] = 1;
    bytes[2] = deck ? 9 : 1;
    bytes[3] = deck ? 64 : 60;
    ++sequence_;
    for (std::size_t i = 0; i < 4; ++i)
        bytes[4 + i] = static_cast<std::uint8_t>(sequence_ >> (8 * i));
    const bool stick = stick_ != Vec2(0.0);
    if (thumbs_[right].there) {
        const Vec2 told = turned(thumbs_[right].place / half, deck ? 0.0 : 15.0);
        put16(bytes, 20, told.x);
        put16(bytes, 22, told.y);
        bytes[10] = static_cast<std::uint8_t>(bytes[10] | (thumbs_[right].pressed ? 0x14 : 0x10));
    }
    // A 2015 controller tells of its stick in every other report while the pad beside it is touched too.
    const bool both = !deck && stick && thumbs_[left].there;
    const bool tells_pad = thumbs_[left].there && (!both || sequence_ % 2 == 0);
    if (tells_pad) {
        const Vec2 told = turned(thumbs_[left].place / half, deck ? 0.0 : -15.0);
        put16(bytes, 16, told.x);
        put16(bytes, 18, told.y);
        bytes[10] = static_cast<std::uint8_t>(bytes[10] | 0x08);
    } else if (!deck && stick) {
        put16(bytes, 16, stick_.x);
        put16(bytes, 18, stick_.y);
    }
    if (thumbs_[left].there && thumbs_[left].pressed)
        bytes[10] = static_cast<std::uint8_t>(bytes[10] | 0x02);
    if (both)
        bytes[10] = static_cast<std::uint8_t>(bytes[10] | 0x80);
    return bytes;
}

void ModelSteamPad::step() {
    ++now_ms_;
    for (Playing& playing : playing_)
        playing.left_us = std::max(0.0, playing.left_us - 1000.0);
    untold_ms_ += 1.0;
    if (kind_ == steam::Kind::deck && untold_ms_ > imitates_again_after_ms)
        mouse_ = keys_ = true;
    if (on_ && now_ms_ % 4 == 0)
        unsaid_.push_back(state());
}

bool ModelSteamPad::report(std::vector<std::uint8_t>& bytes) {
    if (unsaid_.empty())
        return false;
    bytes = std::move(unsaid_.front());
    unsaid_.erase(unsaid_.begin());
    return true;
}

} // namespace tp
