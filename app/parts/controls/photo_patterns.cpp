// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/photo_patterns.hpp"

#include "core/files/photo_endings.hpp"

#include <QStringList>

namespace tp {

PhotoPatterns::PhotoPatterns(QObject* parent) : QObject(parent) {}

QString PhotoPatterns::all() {
    QStringList patterns;
    for (const std::string_view ending : photo_endings)
        patterns << "*" + QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
    return (patterns << "*.bmp"
                     << "*.jp2")
        .join(' ');
}

} // namespace tp
