// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "album_folder.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

namespace tp {

/// A JPEG of 1 × 1 pixel; another `number`, other bytes.
inline std::filesystem::path a_photo(const AlbumFolder& folder, const std::filesystem::path& name,
                                     int number) {
    static constexpr unsigned char head[] = {0xFF, 0xD8, 0xFF, 0xE0, 0x00, 0x10, 'J',  'F',  'I',  'F',
                                             0x00, 0x01, 0x01, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00};
    static constexpr unsigned char frame[] = {0xFF, 0xC0, 0x00, 0x0B, 0x08, 0x00, 0x01, 0x00,
                                              0x01, 0x01, 0x01, 0x11, 0x00, 0xFF, 0xD9};
    const std::string comment = "photograph " + std::to_string(number);
    std::string bytes(reinterpret_cast<const char*>(head), sizeof head);
    bytes += "\xFF\xFE";
    bytes += static_cast<char>((comment.size() + 2) >> 8);
    bytes += static_cast<char>(comment.size() + 2);
    bytes += comment;
    bytes.append(reinterpret_cast<const char*>(frame), sizeof frame);
    return folder.write(name, bytes);
}

/// A WAV file, 48 kHz mono 16 bit, of a tone at -12 dBFS.
inline std::filesystem::path a_sound(const AlbumFolder& folder, const std::filesystem::path& name,
                                     double seconds, double hertz) {
    constexpr int rate = 48'000;
    const auto frames = static_cast<std::uint32_t>(std::lround(seconds * rate));
    const auto number = [](std::uint32_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i)
            text += static_cast<char>(value >> (8 * i));
        return text;
    };
    std::string bytes = "RIFF" + number(36 + 2 * frames, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) +
                        number(1, 2) + number(rate, 4) + number(2 * rate, 4) + number(2, 2) + number(16, 2) +
                        "data" + number(2 * frames, 4);
    for (std::uint32_t i = 0; i < frames; ++i) {
        const double value = 8192.0 * std::sin(2.0 * std::numbers::pi * hertz * i / rate);
        bytes += number(static_cast<std::uint32_t>(std::lround(value)), 2);
    }
    return folder.write(name, bytes);
}

} // namespace tp
