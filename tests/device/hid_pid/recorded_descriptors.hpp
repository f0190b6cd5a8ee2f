// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tp::testing {

/// A report descriptor as a device gave it, and who published it.
struct RecordedDescriptor {
    const char* device;
    const char* source;
    std::string_view hex;
};

/// Whitespace between bytes does not count.
inline std::vector<std::uint8_t> bytes_of(std::string_view hex) {
    const auto digit = [](char c) { return c <= '9' ? c - '0' : (c & ~0x20) - 'A' + 10; };
    std::vector<std::uint8_t> bytes;
    int high = -1;
    for (const char c : hex) {
        if (c == ' ')
            continue;
        if (high < 0) {
            high = digit(c);
        } else {
            bytes.push_back(static_cast<std::uint8_t>(high * 16 + digit(c)));
            high = -1;
        }
    }
    return bytes;
}

// clang-format off
inline constexpr RecordedDescriptor sidewinder_force_feedback_2{
    "Microsoft SideWinder Force Feedback 2, 045E:001B",
    "the notes on joystick details of the project adapt-ffb-joy",
    "05 01 09 04 A1 01 85 01 09 01 A1 00 66 00 00 55 00 16 00 FE 26 FF 01 35 00 46 FF 03 95 01 75 0A "
    "09 30 81 02 75 06 81 01 09 31 75 0A 81 02 75 06 95 01 81 01 15 E0 25 1F 35 00 45 3F 66 14 00 09 "
    "35 81 02 75 02 81 01 66 00 00 C0 75 07 95 01 15 00 25 7F 35 00 45 7F 09 36 81 02 75 01 81 01 09 "
    "39 15 00 25 07 35 00 46 3B 01 66 14 00 75 04 95 01 81 42 95 01 81 01 66 00 00 05 09 19 01 29 08 "
    "15 00 25 01 35 00 45 01 95 08 75 01 81 02 95 04 75 08 81 01 05 0F 09 92 A1 02 85 02 09 9F 09 A0 "
    "09 A4 09 A5 09 A6 15 00 25 01 35 00 45 01 75 01 95 05 81 02 95 03 81 03 09 94 15 00 25 01 35 00 "
    "45 01 75 01 95 01 81 02 09 22 15 01 25 28 35 01 45 28 75 07 95 01 81 02 C0 09 21 A1 02 85 01 09 "
    "22 15 01 25 28 35 01 45 28 75 08 95 01 91 02 09 25 A1 02 09 26 09 27 09 30 09 31 09 32 09 33 09 "
    "34 09 40 09 41 09 42 09 43 09 28 25 0C 15 01 35 01 45 0C 75 08 95 01 91 00 C0 09 50 09 54 09 51 "
    "15 00 26 FF 7F 35 00 46 FF 7F 66 03 10 55 FD 75 10 95 03 91 02 55 00 66 00 00 09 52 15 00 26 FF "
    "00 35 00 46 10 27 75 08 95 01 91 02 09 53 15 01 25 08 35 01 45 08 75 08 95 01 91 02 09 55 A1 02 "
    "05 01 09 30 09 31 15 00 25 01 75 01 95 02 91 02 C0 05 0F 09 56 95 01 91 02 95 05 91 03 09 57 A1 "
    "02 0B 01 00 0A 00 0B 02 00 0A 00 66 14 00 55 FE 15 00 26 FF 00 35 00 47 A0 8C 00 00 66 00 00 75 "
    "08 95 02 91 02 55 00 66 00 00 C0 05 0F 09 A7 66 03 10 55 FD 15 00 26 FF 7F 35 00 46 FF 7F 75 10 "
    "95 01 91 02 66 00 00 55 00 C0 05 0F 09 5A A1 02 85 02 09 22 15 01 25 28 35 01 45 28 75 08 95 01 "
    "91 02 09 5B 09 5D 15 00 26 FF 00 35 00 46 10 27 95 02 91 02 09 5C 09 5E 66 03 10 55 FD 26 FF 7F "
    "46 FF 7F 75 10 91 02 45 00 66 00 00 55 00 C0 09 5F A1 02 85 03 09 22 15 01 25 28 35 01 45 28 75 "
    "08 95 01 91 02 09 23 15 00 25 01 35 00 45 01 75 04 95 01 91 02 09 58 A1 02 0B 01 00 0A 00 0B 02 "
    "00 0A 00 75 02 95 02 91 02 C0 15 80 25 7F 36 F0 D8 46 10 27 09 60 75 08 95 01 91 02 36 F0 D8 46 "
    "10 27 09 61 09 62 95 02 91 02 15 00 26 FF 00 35 00 46 10 27 09 63 09 64 75 08 95 02 91 02 09 65 "
    "46 10 27 95 01 91 02 C0 09 6E A1 02 85 04 09 22 15 01 25 28 35 01 45 28 75 08 95 01 91 02 09 70 "
    "15 00 26 FF 00 35 00 46 10 27 75 08 95 01 91 02 09 6F 15 80 25 7F 36 F0 D8 46 10 27 95 01 91 02 "
    "09 71 66 14 00 55 FE 15 00 26 FF 00 35 00 47 A0 8C 00 00 91 02 09 72 26 FF 7F 46 FF 7F 66 03 10 "
    "55 FD 75 10 95 01 91 02 66 00 00 55 00 C0 09 73 A1 02 85 05 09 22 15 01 25 28 35 01 45 28 75 08 "
    "95 01 91 02 09 70 16 01 FF 26 FF 00 36 F0 D8 46 10 27 75 10 95 01 91 02 C0 09 74 A1 02 85 06 09 "
    "22 15 01 25 28 35 01 45 28 75 08 95 01 91 02 09 75 09 76 15 80 25 7F 36 F0 D8 46 10 27 75 08 95 "
    "02 91 02 C0 09 68 A1 02 85 07 09 22 15 01 25 28 35 01 45 28 75 08 95 01 91 02 09 6C 15 00 26 10 "
    "27 35 00 46 10 27 75 10 95 01 91 02 09 69 15 81 25 7F 35 00 46 FF 00 75 08 95 0C 92 02 01 C0 09 "
    "66 A1 02 85 08 05 01 09 30 09 31 15 81 25 7F 35 00 46 FF 00 75 08 95 02 91 02 C0 05 0F 09 77 A1 "
    "02 85 0A 09 22 15 01 25 28 35 01 45 28 75 08 95 01 91 02 09 78 A1 02 09 79 09 7A 09 7B 15 01 25 "
    "03 75 08 95 01 91 00 C0 09 7C 15 00 26 FF 00 35 00 46 FF 00 91 02 C0 09 90 A1 02 85 0B 09 22 25 "
    "28 15 01 35 01 45 28 75 08 95 01 91 02 C0 09 96 A1 02 85 0C 09 97 09 98 09 99 09 9A 09 9B 09 9C "
    "15 01 25 06 75 08 95 01 91 00 C0 09 7D A1 02 85 0D 09 7E 15 00 26 FF 00 35 00 46 10 27 75 08 95 "
    "01 91 02 C0 09 6B A1 02 85 0E 09 22 15 01 25 28 35 01 45 28 75 08 95 01 91 02 09 6D 15 00 26 FF "
    "00 35 00 46 FF 00 75 08 95 01 91 02 09 51 66 03 10 55 FD 15 00 26 FF 7F 35 00 46 FF 7F 75 10 95 "
    "01 91 02 55 00 66 00 00 C0 09 AB A1 02 85 01 09 25 A1 02 09 26 09 27 09 30 09 31 09 32 09 33 09 "
    "34 09 40 09 41 09 42 09 43 09 28 25 0C 15 01 35 01 45 0C 75 08 95 01 B1 00 C0 05 01 09 3B 15 00 "
    "26 FF 01 35 00 46 FF 01 75 0A 95 01 B1 02 75 06 B1 01 C0 05 0F 09 89 A1 02 85 02 09 22 25 28 15 "
    "01 35 01 45 28 75 08 95 01 B1 02 09 8B A1 02 09 8C 09 8D 09 8E 25 03 15 01 35 01 45 03 75 08 95 "
    "01 B1 00 C0 09 AC 15 00 27 FF FF 00 00 35 00 47 FF FF 00 00 75 10 95 01 B1 00 C0 09 7F A1 02 85 "
    "03 09 80 75 10 95 01 15 00 35 00 27 FF FF 00 00 47 FF FF 00 00 B1 02 09 83 26 FF 00 46 FF 00 75 "
    "08 95 01 B1 02 09 A9 09 AA 75 01 95 02 15 00 25 01 35 00 45 01 B1 02 75 06 95 01 B1 03 C0 C0"};

/// Has constant forces for its two rumble motors, without any direction.
inline constexpr RecordedDescriptor saitek_rumble_pad{
    "Saitek gamepad, 06A3:FF0D",
    "hid-tools, hidtools/device/base_gamepad.py, GPL-2.0",
    "05 01 09 04 A1 01 09 01 A1 00 85 01 09 30 15 00 26 FF 00 35 00 46 FF 00 75 08 95 01 81 02 09 31 "
    "81 02 05 02 09 BA 81 02 09 BB 81 02 05 09 19 01 29 0C 25 01 45 01 75 01 95 0C 81 02 95 01 75 00 "
    "81 03 05 01 09 39 25 07 46 3B 01 55 00 65 44 75 04 81 42 65 00 C0 05 0F 09 92 A1 02 85 02 09 A0 "
    "09 9F 25 01 45 00 75 01 95 02 81 02 75 06 95 01 81 03 09 22 75 07 25 7F 81 02 09 94 75 01 25 01 "
    "81 02 C0 09 21 A1 02 85 0B 09 22 26 FF 00 75 08 91 02 09 53 25 0A 91 02 09 50 27 FE FF 00 00 47 "
    "FE FF 00 00 75 10 55 FD 66 01 10 91 02 55 00 65 00 09 54 55 FD 66 01 10 91 02 55 00 65 00 09 A7 "
    "55 FD 66 01 10 91 02 55 00 65 00 C0 09 5A A1 02 85 0C 09 22 26 FF 00 45 00 75 08 91 02 09 5C 26 "
    "10 27 46 10 27 75 10 55 FD 66 01 10 91 02 55 00 65 00 09 5B 25 7F 75 08 91 02 09 5E 26 10 27 75 "
    "10 55 FD 66 01 10 91 02 55 00 65 00 09 5D 25 7F 75 08 91 02 C0 09 73 A1 02 85 0D 09 22 26 FF 00 "
    "45 00 91 02 09 70 15 81 25 7F 36 F0 D8 46 10 27 91 02 C0 09 6E A1 02 85 0E 09 22 15 00 26 FF 00 "
    "35 00 45 00 91 02 09 70 25 7F 46 10 27 91 02 09 6F 15 81 36 F0 D8 91 02 09 71 15 00 26 FF 00 35 "
    "00 46 68 01 91 02 09 72 75 10 26 10 27 46 10 27 55 FD 66 01 10 91 02 55 00 65 00 C0 09 77 A1 02 "
    "85 51 09 22 25 7F 45 00 75 08 91 02 09 78 A1 02 09 7B 09 79 09 7A 15 01 25 03 91 00 C0 09 7C 15 "
    "00 26 FE 00 91 02 C0 09 92 A1 02 85 52 09 96 A1 02 09 9A 09 99 09 97 09 98 09 9B 09 9C 15 01 25 "
    "06 91 00 C0 C0 05 FF 0A 01 03 A1 02 85 40 0A 02 03 A1 02 1A 11 03 2A 20 03 25 10 91 00 C0 0A 03 "
    "03 15 00 27 FF FF 00 00 75 10 91 02 C0 05 0F 09 7D A1 02 85 43 09 7E 26 80 00 46 10 27 75 08 91 "
    "02 C0 09 7F A1 02 85 0B 09 80 26 FF 7F 45 00 75 0F B1 03 09 A9 25 01 75 01 B1 03 09 83 26 FF 00 "
    "75 08 B1 03 C0 09 AB A1 03 85 15 09 25 A1 02 09 26 09 30 09 32 09 31 09 33 09 34 15 01 25 06 B1 "
    "00 C0 C0 09 89 A1 03 85 16 09 8B A1 02 09 8C 09 8D 09 8E 25 03 B1 00 C0 09 22 15 00 26 FE 00 B1 "
    "02 C0 09 90 A1 03 85 50 09 22 26 FF 00 91 02 C0 C0"};

inline constexpr RecordedDescriptor logitech_g29{
    "Logitech G29 wheel as a PlayStation controller, 046D:C260",
    "issue 146 of J2Kbr/TitanTwo",
    "05 01 09 04 A1 01 85 01 09 30 09 31 09 32 09 35 15 00 26 FF 00 75 08 95 04 81 02 09 39 15 00 25 07 35 00 46 3B "
    "01 65 14 75 04 95 01 81 42 65 00 05 09 19 01 29 0E 15 00 25 01 75 01 95 0E 81 02 06 00 FF 09 20 75 06 95 01 81 "
    "02 05 01 09 33 09 34 15 00 26 FF 00 75 08 95 02 81 02 06 00 FF 09 21 95 36 81 02 85 05 09 22 95 1F 91 02 85 03 "
    "0A 21 27 95 2F B1 02 C0 06 F0 FF 09 40 A1 01 85 F0 09 47 95 3F B1 02 85 F1 09 48 95 3F B1 02 85 F2 09 49 95 0F "
    "B1 02 85 F3 0A 01 47 95 07 B1 02 C0"};

inline constexpr RecordedDescriptor saitek_x52{
    "Saitek X52 flight controller, 06A3:075C",
    "an article on a decoder for the USB X52, by usbhid-dump",
    "05 01 09 04 A1 01 09 01 A1 00 09 30 09 31 15 00 26 FF 07 75 0B 95 02 81 02 09 35 15 00 26 FF 03 75 0A 95 01 81 "
    "02 09 32 09 33 09 34 09 36 15 00 26 FF 00 75 08 95 04 81 02 05 09 19 01 29 22 15 00 25 01 95 22 75 01 81 02 75 "
    "02 95 01 81 01 05 01 09 39 15 01 25 08 35 00 46 3B 01 66 14 00 75 04 95 01 81 42 05 05 09 24 09 26 15 00 25 0F "
    "75 04 95 02 81 02 C0 C0"};

inline constexpr RecordedDescriptor sony_dualshock_3{
    "Sony DualShock 3, 054C:0268",
    "Chromium, services/device/public/cpp/test/test_report_descriptors.cc, BSD-3-Clause",
    "05 01 09 04 A1 01 A1 02 85 01 75 08 95 01 15 00 26 FF 00 81 03 75 01 95 13 15 00 25 01 35 00 45 01 05 09 19 01 "
    "29 13 81 02 75 01 95 0D 06 00 FF 81 03 15 00 26 FF 00 05 01 09 01 A1 00 75 08 95 04 35 00 46 FF 00 09 30 09 31 "
    "09 32 09 35 81 02 C0 05 01 75 08 95 27 09 01 81 02 75 08 95 30 09 01 91 02 75 08 95 30 09 01 B1 02 C0 A1 02 85 "
    "02 75 08 95 30 09 01 B1 02 C0 A1 02 85 EE 75 08 95 30 09 01 B1 02 C0 A1 02 85 EF 75 08 95 30 09 01 B1 02 C0 C0"};

inline constexpr RecordedDescriptor logitech_unifying_receiver{
    "Logitech Unifying receiver, its vendor interface",
    "Chromium, services/device/public/cpp/test/test_report_descriptors.cc, BSD-3-Clause",
    "06 00 FF 09 01 A1 01 85 10 75 08 95 06 15 00 26 FF 00 09 01 81 00 09 01 91 00 C0 06 00 FF 09 02 A1 01 85 11 75 "
    "08 95 13 15 00 26 FF 00 09 02 81 00 09 02 91 00 C0 06 00 FF 09 04 A1 01 85 20 75 08 95 0E 15 00 26 FF 00 09 41 "
    "81 00 09 41 91 00 85 21 95 1F 15 00 26 FF 00 09 42 81 00 09 42 91 00 C0"};

inline constexpr RecordedDescriptor dragonrise_gamepad{
    "DragonRise gamepad, 0079:0011",
    "a test of the project SerialPundit",
    "05 01 09 04 A1 01 A1 02 14 75 08 95 03 81 01 26 FF 00 95 02 09 30 09 31 81 02 75 01 95 04 81 01 25 01 95 0A 05 "
    "09 19 01 29 0A 81 02 95 0A 81 01 C0 C0"};

inline constexpr RecordedDescriptor microsoft_transceiver{
    "Microsoft 2.4GHz Transceiver v9.0, a mouse with resolution multipliers, 045E:07A5",
    "Linux, Documentation/hid, by hid-recorder",
    "05 01 09 02 a1 01 05 01 09 02 a1 02 85 1a 09 01 a1 00 05 09 19 01 29 05 95 05 75 01 15 00 25 01 81 02 75 03 95 "
    "01 81 01 05 01 09 30 09 31 95 02 75 10 16 01 80 26 ff 7f 81 06 a1 02 85 12 09 48 95 01 75 02 15 00 25 01 35 01 "
    "45 0c b1 02 85 1a 09 38 35 00 45 00 95 01 75 10 16 01 80 26 ff 7f 81 06 c0 a1 02 85 12 09 48 75 02 15 00 25 01 "
    "35 01 45 0c b1 02 35 00 45 00 75 04 b1 01 85 1a 05 0c 95 01 75 10 16 01 80 26 ff 7f 0a 38 02 81 06 c0 c0 c0 c0 "
    "05 0c 09 01 a1 01 05 01 09 02 a1 02 85 1f 05 0c 0a 38 02 95 01 75 10 16 01 80 26 ff 7f 81 06 85 17 06 00 ff 0a "
    "06 ff 0a 0f ff 15 00 25 01 35 01 45 0c 95 02 75 02 b1 02 0a 04 ff 35 00 45 00 95 01 75 01 b1 02 75 03 b1 01 c0 "
    "c0"};

inline constexpr RecordedDescriptor logitech_g500s{
    "Logitech G500s mouse, 046D:C24E",
    "hid-tools, tests/test_cli_decode.py",
    "05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 10 15 00 25 01 95 10 75 01 81 02 05 01 16 01 80 26 ff 7f 75 10 95 "
    "02 09 30 09 31 81 06 15 81 25 7f 75 08 95 01 09 38 81 06 05 0c 0a 38 02 95 01 81 06 c0 c0"};

inline constexpr RecordedDescriptor media_keys{
    "the media keys of a keyboard",
    "the notes of a synthesizer project with a USB host",
    "05 01 09 80 A1 01 85 02 09 81 09 82 09 83 25 01 15 00 75 01 95 03 81 06 75 05 95 01 81 01 C0 05 0C 09 01 A1 01 "
    "85 03 15 00 25 01 19 B5 29 B7 09 CD 09 E2 09 E5 09 E7 0A 83 01 09 E9 09 EA 0A 52 01 0A 53 01 0A 54 01 0A 55 01 "
    "0A 8A 01 0A 92 01 0A 94 01 0A 21 02 1A 23 02 2A 27 02 0A 2A 02 95 18 75 01 81 02 C0"};

inline constexpr RecordedDescriptor kxd_gamepad{
    "KXD gamepad",
    "the notes of a synthesizer project with a USB host",
    "05 01 09 04 A1 01 A1 02 75 08 95 05 15 00 26 FF 00 35 00 46 FF 00 09 30 09 31 09 32 09 32 09 35 81 02 75 04 95 "
    "01 25 07 46 3B 01 65 14 09 39 81 42 65 00 75 01 95 0C 25 01 45 01 05 09 19 01 29 0C 81 02 06 00 FF 75 01 95 08 "
    "25 01 45 01 09 01 81 02 C0 A1 02 75 08 95 07 46 FF 00 26 FF 00 09 02 91 02 C0 C0"};

inline constexpr RecordedDescriptor blaze_gamepad{
    "Blaze gamepad",
    "the notes of a synthesizer project with a USB host",
    "05 01 09 04 A1 01 A1 02 85 01 75 08 95 01 15 00 26 FF 00 81 03 75 01 95 0D 15 00 25 01 35 00 45 01 05 09 19 01 "
    "29 0D 81 02 75 01 95 03 06 00 FF 81 03 05 01 25 07 46 3B 01 75 04 95 01 65 14 09 39 81 42 65 00 75 01 95 0C 06 "
    "00 FF 81 03 15 00 26 FF 00 05 01 09 01 A1 00 75 08 95 04 15 00 15 00 15 00 35 00 35 00 46 FF 00 09 30 09 31 09 "
    "32 09 35 81 02 C0 05 01 75 08 95 27 09 01 81 02 75 08 95 30 09 01 91 02 75 08 95 30 09 01 B1 02 C0 A1 02 85 02 "
    "75 08 95 30 09 01 B1 02 C0 A1 02 85 EE 75 08 95 30 09 01 B1 02 C0 A1 02 85 EF 75 08 95 30 09 01 B1 02 C0 C0"};
// clang-format on

inline constexpr std::array recorded_descriptors{
    sidewinder_force_feedback_2,
    saitek_rumble_pad,
    logitech_g29,
    saitek_x52,
    sony_dualshock_3,
    logitech_unifying_receiver,
    dragonrise_gamepad,
    microsoft_transceiver,
    logitech_g500s,
    media_keys,
    kxd_gamepad,
    blaze_gamepad,
};

} // namespace tp::testing
