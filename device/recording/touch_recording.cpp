// SPDX-License-Identifier: Apache-2.0
#include "device/recording/touch_recording.hpp"

#include "device/force_pad/protocol/frame.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <type_traits>

namespace tp {

namespace {

constexpr std::string_view first_line = "TouchPhotoTouch 1\n";
constexpr std::size_t longest_header = 4096;
constexpr std::size_t most_corners = 64;
constexpr unsigned char bit_fresh = 1, bit_lost = 2, bit_motors_off = 4, bit_refused = 8;

std::string shortest(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

bool plain(std::string_view text) {
    return std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// Reads the header line by line.
class Header {
public:
    explicit Header(std::string_view text) : left_(text.substr(0, longest_header)) {}

    /// What follows `key ` in the next line; nothing where that is another line.
    std::optional<std::string_view> line(std::string_view key) {
        const std::size_t end = left_.find('\n');
        if (end == std::string_view::npos || !left_.starts_with(key) || end <= key.size() ||
            left_[key.size()] != ' ')
            return std::nullopt;
        const std::string_view value = left_.substr(key.size() + 1, end - key.size() - 1);
        left_.remove_prefix(end + 1);
        return plain(value) ? std::optional(value) : std::nullopt;
    }
    std::optional<std::vector<double>> numbers(std::string_view key) {
        const std::optional<std::string_view> text = line(key);
        if (!text)
            return std::nullopt;
        std::vector<double> values;
        const char* at = text->data();
        const char* const end = at + text->size();
        while (at != end) {
            double value = 0.0;
            const auto [next, problem] = std::from_chars(at, end, value);
            if (problem != std::errc{} || !std::isfinite(value) || (next != end && *next != ' '))
                return std::nullopt;
            values.push_back(value);
            at = next == end ? end : next + 1;
        }
        return values;
    }
    bool number(std::string_view key, double& value) {
        const auto values = numbers(key);
        if (!values || values->size() != 1)
            return false;
        value = values->front();
        return true;
    }
    std::string_view left() const { return left_; }

private:
    std::string_view left_;
};

std::optional<Capabilities> capabilities_in(Header& header) {
    Capabilities device;
    const auto name = header.line("name");
    const auto serial = name ? header.line("serial") : std::nullopt;
    if (!serial)
        return std::nullopt;
    device.name = *name;
    device.serial_number = *serial;
    double calibrated = 0.0;
    if (!header.number("max_force", device.max_force) ||
        !header.number("continuous_force", device.continuous_force) ||
        !header.number("resolution", device.resolution) || !header.number("rate", device.rate) ||
        !header.number("delay", device.delay) || !header.number("calibrated", calibrated))
        return std::nullopt;
    if (header.left().starts_with("damping") &&
        (!header.number("damping", device.damping) || device.damping < 0.0))
        return std::nullopt;
    const auto corners = header.numbers("workspace");
    if (!corners || corners->size() % 2 != 0 || corners->size() > 2 * most_corners || device.rate <= 0.0 ||
        device.max_force < 0.0 || device.delay < 0.0 || (calibrated != 0.0 && calibrated != 1.0))
        return std::nullopt;
    device.calibrated = calibrated == 1.0;
    for (std::size_t i = 0; i + 1 < corners->size(); i += 2)
        device.workspace.emplace_back((*corners)[i], (*corners)[i + 1]);
    return device;
}

template <typename Number>
void put(std::array<char, tick_size>& bytes, std::size_t at, Number number) {
    std::uint64_t raw = 0;
    if constexpr (std::is_same_v<Number, double>)
        raw = std::bit_cast<std::uint64_t>(number);
    else
        raw = number;
    for (std::size_t i = 0; i < sizeof number; ++i)
        bytes[at + i] = static_cast<char>((raw >> (8 * i)) & 0xFF);
}

std::uint64_t whole(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t raw = 0;
    for (std::size_t i = 0; i < size; ++i)
        raw |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return raw;
}

double real(std::string_view bytes, std::size_t at) { return std::bit_cast<double>(whole(bytes, at, 8)); }

std::uint16_t crc_of(std::string_view bytes) {
    return pad::crc16(reinterpret_cast<const std::uint8_t*>(bytes.data()), tick_size - 2);
}

std::optional<RecordedTick> tick_in(std::string_view bytes, std::uint32_t number) {
    const auto flags = static_cast<unsigned char>(bytes[4]);
    if (whole(bytes, 62, 2) != crc_of(bytes) || whole(bytes, 0, 4) != number || flags > 15 ||
        whole(bytes, 5, 3) != 0 || whole(bytes, 44, 2) != 0)
        return std::nullopt;
    RecordedTick tick;
    tick.now = real(bytes, 8);
    tick.fresh = (flags & bit_fresh) != 0;
    tick.lost = (flags & bit_lost) != 0;
    tick.motors_off = (flags & bit_motors_off) != 0;
    tick.refused = (flags & bit_refused) != 0;
    tick.reading = {
        real(bytes, 16), {real(bytes, 24), real(bytes, 32)}, static_cast<std::uint32_t>(whole(bytes, 40, 4))};
    tick.force = {real(bytes, 46), real(bytes, 54)};
    if (!std::isfinite(tick.now) || !std::isfinite(tick.reading.time) || !is_finite(tick.reading.position) ||
        !is_finite(tick.force))
        return std::nullopt;
    return tick;
}

} // namespace

std::string recording_header(const Capabilities& device) {
    const auto clean = [](std::string text) {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
        return text.substr(0, 200);
    };
    std::string text(first_line);
    text += "name " + clean(device.name) + "\nserial " + clean(device.serial_number) + "\nmax_force " +
            shortest(device.max_force) + "\ncontinuous_force " + shortest(device.continuous_force) +
            "\nresolution " + shortest(device.resolution) + "\nrate " + shortest(device.rate) + "\ndelay " +
            shortest(device.delay) + "\ncalibrated " + (device.calibrated ? "1" : "0");
    if (device.damping > 0.0)
        text += "\ndamping " + shortest(device.damping);
    text += "\nworkspace ";
    for (std::size_t i = 0; i < std::min(device.workspace.size(), most_corners); ++i) {
        if (i > 0)
            text += ' ';
        text += shortest(device.workspace[i].x) + ' ' + shortest(device.workspace[i].y);
    }
    return text + "\n\n";
}

std::array<char, tick_size> recorded_bytes(const RecordedTick& tick, std::uint32_t number) {
    std::array<char, tick_size> bytes{};
    put(bytes, 0, number);
    bytes[4] = static_cast<char>((tick.fresh ? bit_fresh : 0) | (tick.lost ? bit_lost : 0) |
                                 (tick.motors_off ? bit_motors_off : 0) | (tick.refused ? bit_refused : 0));
    put(bytes, 8, tick.now);
    put(bytes, 16, tick.reading.time);
    put(bytes, 24, tick.reading.position.x);
    put(bytes, 32, tick.reading.position.y);
    put(bytes, 40, tick.reading.buttons);
    put(bytes, 46, tick.force.x);
    put(bytes, 54, tick.force.y);
    put(bytes, 62, crc_of({bytes.data(), bytes.size()}));
    return bytes;
}

Result<TouchRecording> parse_recording(std::string_view bytes) {
    const Error not_one{
        "This is not a recording of a force device, or it is from a later version of TouchPhoto."};
    if (!bytes.starts_with(first_line))
        return not_one;
    Header header(bytes.substr(first_line.size()));
    const std::optional<Capabilities> device = capabilities_in(header);
    if (!device || !header.left().starts_with('\n'))
        return not_one;
    TouchRecording recording;
    recording.device = *device;
    const auto header_size = static_cast<std::size_t>(header.left().data() - bytes.data()) + 1;
    std::string_view left = bytes.substr(header_size);
    while (left.size() >= tick_size) {
        const auto tick =
            tick_in(left.substr(0, tick_size), static_cast<std::uint32_t>(recording.ticks.size()));
        if (!tick || (!recording.ticks.empty() && tick->now < recording.ticks.back().now))
            break;
        recording.ticks.push_back(*tick);
        left.remove_prefix(tick_size);
    }
    recording.bytes_left = left.size();
    return recording;
}

} // namespace tp
