// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/description_care.hpp"

#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>

namespace tp {

/// What the program sees on the photograph, in the album's language, offered where no short description is there yet.
/// Nothing of it is kept unless a person takes it.
class DescriptionDraft final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString text READ text NOTIFY changed) ///< empty: nothing to offer
public:
    /// All must outlive it. `language` is that of the album.
    DescriptionDraft(OpenAlbum& album, CaredPhoto& photo, DescriptionCare& descriptions, CareTeller& teller,
                     std::function<QString()> language);

    const QString& text() const { return text_; }
    /// The photograph was looked at meanwhile.
    void looked_at(const std::filesystem::path& photo);
    /// It becomes the short description, to be changed and kept as if it had been typed.
    Q_INVOKABLE void take();

signals:
    void changed();

private:
    void make();

    OpenAlbum& album_;
    CaredPhoto& photo_;
    DescriptionCare& descriptions_;
    CareTeller& teller_;
    std::function<QString()> language_;
    QString text_;
};

} // namespace tp
