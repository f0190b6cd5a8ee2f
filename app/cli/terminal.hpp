// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QJsonObject>

#include <cstdio>
#include <string>
#include <string_view>

namespace tp {

// Everything that a verb shows goes through here, for much of it strangers wrote: names of files, people and contours, words
// of a command line. A terminal obeys control characters, and marks of direction turn what stands round them.

/// The text with blanks in place of these; line ends and tabs stay, and what is no UTF-8 becomes U+FFFD.
std::string for_terminal(std::string_view text);

/// As std::printf and std::fprintf, by way of `for_terminal`.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);
[[gnu::format(printf, 2, 3)]] void print_to(std::FILE* where, const char* format, ...);

/// The object on one line without its end; what `for_terminal` would take out is escaped (RFC 8259, 7), so that nothing is lost.
QByteArray compact_json(const QJsonObject& object);
/// The same with its end, on stdout at once.
void print_json(const QJsonObject& object);

} // namespace tp
