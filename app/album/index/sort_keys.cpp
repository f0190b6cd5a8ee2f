// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/sort_keys.hpp"

#include "core/files/file_words.hpp"

#include <QString>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>

namespace tp {

namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

/// Takes exactly `count` digits off the front.
bool take_number(std::string_view& text, std::size_t count, int& number) {
    if (text.size() < count || !std::all_of(text.begin(), text.begin() + static_cast<long>(count), digit))
        return false;
    std::from_chars(text.data(), text.data() + count, number);
    text.remove_prefix(count);
    return true;
}

bool take(std::string_view& text, char c) {
    if (!text.starts_with(c))
        return false;
    text.remove_prefix(1);
    return true;
}

/// Thousandths of a second of a fraction of any length.
int take_fraction(std::string_view& text) {
    int ms = 0;
    for (int weight = 100; !text.empty() && digit(text.front()); weight /= 10) {
        ms += (text.front() - '0') * weight;
        text.remove_prefix(1);
    }
    return ms;
}

/// Minutes east of UTC; 0 where it says nothing.
int offset_minutes(std::string_view text) {
    int hours = 0, minutes = 0;
    const int sign = text.starts_with('-') ? -1 : 1;
    if (text.empty() || (text.front() != '+' && text.front() != '-'))
        return 0;
    text.remove_prefix(1);
    if (!take_number(text, 2, hours))
        return 0;
    take(text, ':');
    take_number(text, 2, minutes);
    return sign * (hours * 60 + minutes);
}

} // namespace

std::string folded(std::string_view text) {
    const QString parts = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))
                              .normalized(QString::NormalizationForm_KD)
                              .toCaseFolded();
    QString result;
    result.reserve(parts.size());
    for (const QChar c : parts)
        if (c.category() != QChar::Mark_NonSpacing)
            result += c;
    return result.toStdString();
}

std::string sort_key(std::string_view name) {
    const std::string text = folded(readable(name));
    std::string key;
    for (std::size_t i = 0; i < text.size();) {
        if (!digit(text[i])) {
            key += text[i++];
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && digit(text[end]))
            ++end;
        while (i + 1 < end && text[i] == '0')
            ++i;
        const std::size_t length =
            end - i; // a longer number is the greater one; names have at most 255 bytes
        key += {static_cast<char>('0' + length / 100), static_cast<char>('0' + length / 10 % 10),
                static_cast<char>('0' + length % 10)};
        key.append(text, i, length);
        i = end;
    }
    return key;
}

std::vector<std::string> word_starts(std::string_view folded_text) {
    constexpr std::size_t most = 8;
    const QString text = QString::fromUtf8(folded_text.data(), static_cast<qsizetype>(folded_text.size()));
    std::vector<std::string> starts;
    for (qsizetype i = 0; i < text.size() && starts.size() < most; ++i) {
        const auto in_word = [&](qsizetype at) {
            return text[at].isLetterOrNumber() || text[at].isSurrogate();
        };
        if (in_word(i) && (i == 0 || !in_word(i - 1)))
            starts.push_back(text.mid(i).toStdString());
    }
    return starts;
}

std::optional<Moment> moment_of(std::string_view iso) {
    using namespace std::chrono;
    int year_number = 0, month_number = 1, day_number = 1, hour = 0, minute = 0, second = 0, ms = 0;
    if (!take_number(iso, 4, year_number))
        return std::nullopt;
    if (take(iso, '-') && take_number(iso, 2, month_number) && take(iso, '-') &&
        take_number(iso, 2, day_number) && take(iso, 'T') && take_number(iso, 2, hour) && take(iso, ':') &&
        take_number(iso, 2, minute) && take(iso, ':') && take_number(iso, 2, second) && take(iso, '.'))
        ms = take_fraction(iso);
    const year_month_day date{year(year_number), month(static_cast<unsigned>(month_number)),
                              day(static_cast<unsigned>(day_number))};
    if (!date.ok() || hour > 23 || minute > 59 || second > 60)
        return std::nullopt;
    const sys_time<milliseconds> time = sys_days(date) + hours(hour) + minutes(minute - offset_minutes(iso)) +
                                        seconds(second) + milliseconds(ms);
    return Moment{time.time_since_epoch().count(), year_number};
}

} // namespace tp
