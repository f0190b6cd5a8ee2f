// SPDX-License-Identifier: Apache-2.0
#include "app/cli/names_file.hpp"

#include "core/files/whole_file.hpp"

#include <QByteArray>
#include <QList>

namespace tp {

namespace {

constexpr std::size_t most_bytes = 16 << 20;

} // namespace

Result<std::set<std::string>> names_in(const QString& name, const std::string& of_what) {
    const auto text = read_whole(name.toStdString(), most_bytes);
    if (!text)
        return Error{"The list of " + of_what + " cannot be read: " + text.error()};
    std::set<std::string> names;
    for (const QByteArray& line : QByteArray::fromStdString(*text).split('\n'))
        if (const QByteArray one = line.trimmed(); !one.isEmpty() && !one.startsWith('#'))
            names.insert(one.toStdString());
    return names;
}

} // namespace tp
