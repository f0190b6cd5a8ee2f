// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace tp {

/// One of the things that are said of a photograph on demand.
struct PhotoDetail {
    QString text;
    std::optional<std::size_t> recording; ///< which one in order, where it is about one
    bool operator==(const PhotoDetail&) const = default;
};

/// What is known of a photograph, in words for a person; names, dates and counts as `locale` writes them.
class PhotoWords {
    Q_DECLARE_TR_FUNCTIONS(PhotoWords)
public:
    explicit PhotoWords(QLocale locale = QLocale()) : locale_(std::move(locale)) {}

    /// "Anna and Tom, May 2026, Vienna; 3 recordings." With nothing known, the file's name stands for it.
    QString summary(const std::filesystem::path& photo, const PhotoRecord& record) const;
    /// People one by one, recordings one by one in the order in which they are played, descriptions, place,
    /// time, keywords, and the file's name.
    std::vector<PhotoDetail> details(const std::filesystem::path& photo, const PhotoRecord& record) const;

    /// "memo by Tom": the kind of a recording, and who speaks.
    QString recording(const Tag& tag) const;
    /// "1 minute 5 seconds"; seconds only below ten minutes.
    QString duration(double seconds) const;
    /// "0:12", "1:02:07"
    static QString clock(double seconds);

private:
    QStringList people(const PhotoRecord& record) const;
    QString month(const QString& taken) const;
    QString moment(const QString& taken) const;
    QString in_our_language(const LanguageTexts& texts) const;

    QLocale locale_;
};

/// The recordings in the order in which they are played.
std::vector<Tag> in_playing_order(const std::vector<Tag>& tags);

} // namespace tp
