// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/path_text.hpp"

#include <QByteArray>

#include <string>

namespace tp {

namespace fs = std::filesystem;

QString path_text(const fs::path& path) {
    const QByteArray bytes = QByteArray::fromStdString(path.string());
    const QString text = QString::fromUtf8(bytes);
    if (text.toUtf8() == bytes && !text.contains(QLatin1Char('%')) && !bytes.contains('\0'))
        return text;
    return QStringLiteral("%:") + QString::fromLatin1(bytes.toPercentEncoding("/"));
}

Result<fs::path> path_of(const QString& text) {
    fs::path path;
    if (text.startsWith(QStringLiteral("%:")))
        path = fs::path(QByteArray::fromPercentEncoding(text.mid(2).toLatin1()).toStdString());
    else
        path = fs::path(text.toStdString());
    if (path_text(path) != text)
        return Error{"It names a file in a way that TouchPhoto does not write."};
    return path;
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
