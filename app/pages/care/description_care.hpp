// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"

#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>

namespace tp {

/// The short and the long description of the photograph (IPTC alt text and extended description) in the album's
/// language: what is typed, and keeping it.
class DescriptionCare final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString altText READ altText NOTIFY changed)
    Q_PROPERTY(QString description READ description NOTIFY changed)
    Q_PROPERTY(bool unsaved READ unsaved NOTIFY changed)
    Q_PROPERTY(QString languageName READ languageName NOTIFY changed)
public:
    /// Longest short description that screen readers are known to read in one piece, characters (IPTC Photo Metadata User
    /// Guide: "less than 250 characters").
    static constexpr int alt_text_characters = 250;

    /// Both must outlive it. `language` is that of the album, BCP 47.
    DescriptionCare(CaredPhoto& photo, CareTeller& teller, std::function<QString()> language);

    QString altText() const { return typed_.alt_text; }
    QString description() const { return typed_.description; }
    bool unsaved() const { return typed_ != kept_; }
    QString languageName() const;

    /// What stands in the fields now; kept by save().
    Q_INVOKABLE void typeAltText(const QString& text);
    Q_INVOKABLE void typeDescription(const QString& text);
    /// Nothing where nothing was changed.
    Q_INVOKABLE void save();

signals:
    void changed();

private:
    struct Texts {
        QString alt_text, description;
        bool operator==(const Texts&) const = default;
    };
    void read();

    CaredPhoto& photo_;
    CareTeller& teller_;
    std::function<QString()> language_;
    PhotoPlace place_; ///< of what is typed
    Texts typed_;
    Texts kept_;                  ///< as the sidecar has them, as far as is known
    std::optional<Texts> saving_; ///< what is on its way to the disk, the newest
    std::map<std::filesystem::path, Texts>
        unkept_; ///< of photographs that were left: the disk did not take it
};

} // namespace tp
