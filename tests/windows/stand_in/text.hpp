// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

/// Bytes, as far as tests of rooms without Qt use Qt's class of that name.
class QByteArray : public std::string {
public:
    using std::string::string;
    QByteArray() = default;
    QByteArray(std::string text) : std::string(std::move(text)) {}
    static QByteArray fromStdString(const std::string& text) { return QByteArray(text); }
    template <typename Number>
    static QByteArray number(Number value) {
        return QByteArray(std::to_string(value));
    }
    const char* constData() const { return c_str(); }
    bool contains(const std::string& part) const { return find(part) != npos; }
    int count(const std::string& part) const {
        int times = 0;
        for (std::size_t at = find(part); at != npos; at = find(part, at + 1))
            ++times;
        return times;
    }
    bool isEmpty() const { return empty(); }
    bool isNull() const { return empty(); }
    QByteArray mid(std::size_t at, std::size_t count = npos) const { return QByteArray(substr(at, count)); }
    std::string toStdString() const { return *this; }
    /// The bytes of which those are the digits, two each.
    static QByteArray fromHex(const std::string& digits) {
        QByteArray bytes;
        for (std::size_t at = 0; at + 1 < digits.size(); at += 2)
            bytes += static_cast<char>(std::stoi(digits.substr(at, 2), nullptr, 16));
        return bytes;
    }
    /// Two digits a byte, with `between` between two of them.
    QByteArray toHex(char between) const {
        QByteArray hex;
        for (const char byte : *this) {
            char digits[4];
            std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned char>(byte));
            if (!hex.empty())
                hex += between;
            hex += digits;
        }
        return hex;
    }
};

/// Text, in UTF-8.
class QString : public std::string {
public:
    using std::string::string;
    QString() = default;
    QString(std::string text) : std::string(std::move(text)) {}
    static QString fromStdString(const std::string& text) { return QString(text); }
    template <typename Number>
    static QString number(Number value) {
        return QString(text_of(value));
    }
    static QString number(double value, char format, int precision) {
        const char pattern[] = {'%', '.', '*', format, 0};
        return asprintf(pattern, precision, value);
    }
    template <typename... Values>
    static QString asprintf(const char* format, Values... values) {
        char text[400];
        std::snprintf(text, sizeof text, format, values...);
        return QString(text);
    }
    static QString fromLatin1(const char* ascii) { return QString(ascii); }
    bool contains(const std::string& part) const { return find(part) != npos; }
    bool endsWith(char end) const { return ends_with(end); }
    bool isEmpty() const { return empty(); }

    /// The lowest of %1, %2, … becomes the value.
    template <typename Value>
    QString arg(const Value& value) const {
        for (char digit = '1'; digit <= '9'; ++digit) {
            const char mark[] = {'%', digit, 0};
            if (find(mark) == npos)
                continue;
            QString result = *this;
            for (std::size_t at = result.find(mark); at != npos; at = result.find(mark, at))
                result.replace(at, 2, text_of(value));
            return result;
        }
        return *this;
    }
    template <typename Value, typename Next, typename... More>
    QString arg(const Value& value, const Next& next, const More&... more) const {
        return arg(value).arg(next, more...);
    }

    std::string toStdString() const { return *this; }
    QByteArray toUtf8() const { return QByteArray(static_cast<const std::string&>(*this)); }
    QByteArray toLocal8Bit() const { return toUtf8(); }

private:
    template <typename Value>
    static std::string text_of(const Value& value) {
        if constexpr (std::is_floating_point_v<Value>) {
            char text[40];
            std::snprintf(text, sizeof text, "%g", static_cast<double>(value));
            return text;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            return std::to_string(value);
        } else {
            return std::string(value);
        }
    }
};

using QLatin1String = std::string;

template <typename... Values>
void qInfo(const char* format, Values... values) {
    std::printf("%s\n", QString::asprintf(format, values...).c_str());
}

template <typename... Values>
[[noreturn]] void qFatal(const char* format, Values... values) {
    qInfo(format, values...);
    std::abort();
}

#define QStringLiteral(text) QString(text)
#define qPrintable(text) (text).c_str()
