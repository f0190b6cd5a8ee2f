// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/time_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace tp {

namespace {

/// Takes what it expects from the start of a text, or fails for good.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    bool ok() const { return ok_; }
    bool at_end() const { return text_.empty(); }

    /// So many digits; 0 when they are not there.
    int digits(std::size_t count) {
        int number = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (text_.empty() || std::isdigit(static_cast<unsigned char>(text_.front())) == 0) {
                ok_ = false;
                return 0;
            }
            number = 10 * number + (text_.front() - '0');
            text_.remove_prefix(1);
        }
        return number;
    }
    bool take(char letter) {
        if (!ok_ || !text_.starts_with(letter))
            return false;
        text_.remove_prefix(1);
        return true;
    }
    void expect(char letter) { ok_ = take(letter); }
    void skip_digits() {
        while (!text_.empty() && std::isdigit(static_cast<unsigned char>(text_.front())) != 0)
            text_.remove_prefix(1);
    }

private:
    std::string_view text_;
    bool ok_ = true;
};

std::string padded(int number, std::size_t width) {
    std::string text = std::to_string(number);
    return text.size() < width ? std::string(width - text.size(), '0') + text : text;
}

bool is_day(int year, int month, int day) {
    constexpr std::array<int, 12> days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (year < 1 || month < 1 || month > 12 || day < 1)
        return false;
    const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    return day <= days[static_cast<std::size_t>(month - 1)] + (month == 2 && leap ? 1 : 0);
}

/// "Z", "+02:00" or "+0200"; empty where there is none. Farther than any place on Earth is from Greenwich:
/// fails.
std::string offset(Scanner& scanner, bool& sound) {
    sound = true;
    if (scanner.take('Z'))
        return "Z";
    const bool east = scanner.take('+');
    if (!east && !scanner.take('-'))
        return {};
    const int hours = scanner.digits(2);
    scanner.take(':');
    const int minutes = scanner.digits(2);
    sound = scanner.ok() && hours <= 15 && minutes <= 59;
    std::string text(1, east ? '+' : '-');
    text += padded(hours, 2);
    text += ':';
    return text += padded(minutes, 2);
}

/// What follows a date: "10:15", "10:15:00" with parts of a second or without, and an offset. `separator` is
/// 0 where the digits follow each other.
std::optional<std::string> clock(Scanner& scanner, char separator) {
    const int hour = scanner.digits(2);
    if (separator != 0)
        scanner.expect(separator);
    const int minute = scanner.digits(2);
    int second = 0;
    if (separator == 0 || scanner.take(separator))
        second = scanner.digits(2);
    if (scanner.take('.') || scanner.take(','))
        scanner.skip_digits();
    bool sound = true;
    const std::string east = offset(scanner, sound);
    if (!scanner.ok() || !sound || !scanner.at_end() || hour > 23 || minute > 59 || second > 60)
        return std::nullopt;
    return padded(hour, 2) + ":" + padded(minute, 2) + ":" + padded(second, 2) + east;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\0'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0'))
        text.remove_suffix(1);
    return text;
}

std::string day_text(int year, int month, int day) {
    return padded(year, 4) + "-" + padded(month, 2) + "-" + padded(day, 2);
}

} // namespace

std::optional<std::string> exif_time(std::string_view date_time, std::string_view offset_text) {
    Scanner scanner(trimmed(date_time));
    const int year = scanner.digits(4);
    scanner.expect(':');
    const int month = scanner.digits(2);
    scanner.expect(':');
    const int day = scanner.digits(2);
    if (!scanner.ok() || !is_day(year, month, day))
        return std::nullopt;
    if (scanner.at_end())
        return day_text(year, month, day);
    scanner.expect(' ');
    const auto time = clock(scanner, ':');
    if (!time)
        return std::nullopt;
    Scanner offset_scanner(trimmed(offset_text));
    bool sound = true;
    const std::string east = offset(offset_scanner, sound);
    return day_text(year, month, day) + "T" + *time + (sound && time->size() == 8 ? east : "");
}

std::optional<std::string> iptc_time(std::string_view date, std::string_view time_text) {
    Scanner scanner(trimmed(date));
    const int year = scanner.digits(4);
    scanner.take('-');
    const int month = scanner.digits(2);
    scanner.take('-');
    const int day = scanner.digits(2);
    if (!scanner.ok() || !scanner.at_end() || !is_day(year, month, day))
        return std::nullopt;
    const std::string_view text = trimmed(time_text);
    Scanner clock_scanner(text);
    const auto time = clock(clock_scanner, text.find(':') == 2 ? ':' : '\0');
    return day_text(year, month, day) + (time ? "T" + *time : "");
}

std::optional<std::string> xmp_time(std::string_view text) {
    Scanner scanner(trimmed(text));
    const int year = scanner.digits(4);
    if (!scanner.ok() || year < 1)
        return std::nullopt;
    if (scanner.at_end())
        return padded(year, 4);
    scanner.expect('-');
    const int month = scanner.digits(2);
    if (!scanner.ok() || !is_day(year, month, 1))
        return std::nullopt;
    if (scanner.at_end())
        return padded(year, 4) + "-" + padded(month, 2);
    scanner.expect('-');
    const int day = scanner.digits(2);
    if (!scanner.ok() || !is_day(year, month, day))
        return std::nullopt;
    if (scanner.at_end())
        return day_text(year, month, day);
    scanner.expect('T');
    const auto time = clock(scanner, ':');
    return time ? std::optional(day_text(year, month, day) + "T" + *time) : std::nullopt;
}

} // namespace tp
