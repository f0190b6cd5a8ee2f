// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/parts/preferences/choices.hpp"
#include "app/photo/seen/seen_photo.hpp"

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
    /// How much is said of what is seen on a photograph, and what first.
    struct Style {
        Choices::Descriptions length = Choices::Descriptions::brief;
        bool place_first = false;
    };
    /// What is seen on a photograph; nothing: nobody has looked yet.
    using Seen = std::optional<SeenPhoto>;

    explicit PhotoWords(QLocale locale = QLocale()) : PhotoWords(Style(), std::move(locale)) {}
    explicit PhotoWords(Style style, QLocale locale = QLocale())
        : style_(style), locale_(std::move(locale)) {}

    /// "Anna and Tom, both smiling, May 2026, Vienna; 3 recordings." With nothing known, the file's name stands for it.
    QString summary(const std::filesystem::path& photo, const PhotoRecord& record,
                    const Seen& seen = {}) const;
    /// What is seen, people one by one, recordings one by one in the order in which they are played, descriptions,
    /// place, time, keywords, and the file's name. Nothing that the summary says whole.
    std::vector<PhotoDetail> details(const std::filesystem::path& photo, const PhotoRecord& record,
                                     const Seen& seen = {}) const;

    /// "Anna and Tom, both smiling.", or whole sentences, as was chosen; empty: nothing is to be said.
    QString seen(const PhotoRecord& record, const Seen& seen) const;

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

    QString known_of(const std::filesystem::path& photo, const PhotoRecord& record) const;
    QString seen_in_short(const std::filesystem::path& photo, const PhotoRecord& record,
                          const SeenPhoto& seen) const;
    QString seen_in_full(const PhotoRecord& record, const SeenPhoto& seen) const;

    Style style_;
    QLocale locale_;
};

/// The recordings in the order in which they are played.
std::vector<Tag> in_playing_order(const std::vector<Tag>& tags);

} // namespace tp
