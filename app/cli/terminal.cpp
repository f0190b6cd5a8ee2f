// SPDX-License-Identifier: Apache-2.0
#include "app/cli/terminal.hpp"

#include "core/files/file_words.hpp"

#include <QChar>
#include <QJsonDocument>
#include <QString>

#include <algorithm>
#include <cstdarg>
#include <cstddef>

namespace tp {

namespace {

[[gnu::format(printf, 2, 0)]] void print_all(std::FILE* where, const char* format, std::va_list values) {
    std::va_list again;
    va_copy(again, values);
    const int length = std::vsnprintf(nullptr, 0, format, again);
    va_end(again);
    if (length < 0)
        return;
    std::string text(static_cast<std::size_t>(length), '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, values);
    text = for_terminal(text);
    std::fwrite(text.data(), 1, text.size(), where);
}

} // namespace

std::string for_terminal(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
        shown += readable(text.substr(0, end));
        if (end < text.size())
            shown += text[end];
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return shown;
}

void print(const char* format, ...) {
    std::va_list values;
    va_start(values, format);
    print_all(stdout, format, values);
    va_end(values);
}

void print_to(std::FILE* where, const char* format, ...) {
    std::va_list values;
    va_start(values, format);
    print_all(where, format, values);
    va_end(values);
}

QByteArray compact_json(const QJsonObject& object) {
    const QString text = QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
    QString escaped;
    escaped.reserve(text.size());
    for (const QChar unit : text) // all that is unwelcome is one unit of UTF-16
        if (is_unwelcome(unit.unicode()))
            escaped += QString::asprintf("\\u%04x", unit.unicode());
        else
            escaped += unit;
    return escaped.toUtf8();
}

void print_json(const QJsonObject& object) {
    const QByteArray line = compact_json(object) + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stdout);
    std::fflush(stdout);
}

} // namespace tp
