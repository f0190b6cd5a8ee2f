// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/path_text.hpp"

#include "core/files/file_name.hpp"

#include <QByteArray>

#include <string>

namespace tp {

namespace fs = std::filesystem;

QString path_text(const fs::path& path) {
    const QByteArray bytes = QByteArray::fromStdString(name_in_utf8(path));
    const QString text = QString::fromUtf8(bytes);
    if (text.toUtf8() == bytes && !text.contains(QLatin1Char('%')) && !bytes.contains('\0'))
        return text;
    return percent_encoded(path);
}

Result<fs::path> path_of(const QString& text) {
    const fs::path path = is_percent_encoded(text) ? percent_decoded(text) : path_named(text.toStdString());
    if (path_text(path) != text)
        return Error{"It names a file in a way that TouchPhoto does not write."};
    return path;
}

QString percent_encoded(const fs::path& path) {
    const QByteArray bytes = QByteArray::fromStdString(name_in_utf8(path));
    return QStringLiteral("%:") + QString::fromLatin1(bytes.toPercentEncoding("/"));
}

bool is_percent_encoded(const QString& text) { return text.startsWith(QStringLiteral("%:")); }

fs::path percent_decoded(const QString& text) {
    return path_named(QByteArray::fromPercentEncoding(text.mid(2).toLatin1()).toStdString());
}

bool stays_below(const fs::path& path) {
    if (path.empty() || path.is_absolute() || path.native().find('\0') != std::string::npos)
        return false;
    for (const fs::path& part : path)
        if (part.empty() || part == "." || part == "..")
            return false;
    return true;
}

} // namespace tp
