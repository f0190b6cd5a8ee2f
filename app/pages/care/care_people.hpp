// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The people whom the album knows, offered where a name is asked for.
class CarePeople final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    static constexpr int most_offered = 12; ///< at a time

    /// The album must outlive it.
    explicit CarePeople(OpenAlbum& album) : album_(album) {}

    /// Who may be meant by what was typed, the commonest first; where nothing was typed, all by name.
    Q_INVOKABLE QStringList known(const QString& typed) const;

private:
    OpenAlbum& album_;
};

} // namespace tp
