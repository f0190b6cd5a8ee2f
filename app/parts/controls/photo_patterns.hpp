// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The photographs that a file dialog shows: `PhotoPatterns.all` in QML.
class PhotoPatterns : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    Q_PROPERTY(QString all READ all CONSTANT)
public:
    explicit PhotoPatterns(QObject* parent = nullptr);

    /// "*.jpg *.jpeg …": what the album takes (core/files/photo_endings.hpp) and what only opens alone.
    static QString all();
};

} // namespace tp
