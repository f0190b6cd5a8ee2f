// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/photo_words.hpp"

#include "app/photo/words/description.hpp"
#include "core/files/file_words.hpp"

#include <QDate>
#include <QDateTime>
#include <QTime>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tp {

namespace {

QString file_name(const std::filesystem::path& photo) {
    return QString::fromStdString(readable(photo.filename().string()));
}

QString plain(const std::string& text) { return QString::fromStdString(text).simplified(); }

/// Faces to whom nobody has given a name.
int unnamed(const PhotoRecord& record) {
    return static_cast<int>(std::count_if(record.faces.begin(), record.faces.end(),
                                          [](const FaceRegion& face) { return face.name.empty(); }));
}

/// The date without its time, for a camera's clock knows no more than its owner set.
QDate date_of(const QString& taken) { return QDate::fromString(taken.left(10), Qt::ISODate); }

DescriptionOrder order_of(const PhotoWords::Style& style) {
    return style.place_first ? DescriptionOrder::place_first : DescriptionOrder::people_first;
}

QString begun_large(const QString& text) { return text.left(1).toUpper() + text.mid(1); }

} // namespace

std::vector<Tag> in_playing_order(const std::vector<Tag>& tags) {
    std::vector<Tag> ordered = tags;
    std::stable_sort(ordered.begin(), ordered.end(), [](const Tag& a, const Tag& b) {
        const auto rank = [](const Tag& tag) {
            return tag.order > 0 ? std::pair(tag.order, RecordingKind::memo)
                                 : std::pair(std::numeric_limits<int>::max(), tag.label.kind);
        };
        return rank(a) < rank(b);
    });
    return ordered;
}

QStringList PhotoWords::people(const PhotoRecord& record) const {
    QStringList names;
    for (const std::string& person : record.persons)
        if (const QString name = plain(person); !name.isEmpty())
            names << name;
    for (const FaceRegion& face : record.faces)
        if (const QString name = plain(face.name); !name.isEmpty() && !names.contains(name))
            names << name;
    return names;
}

QString PhotoWords::summary(const std::filesystem::path& photo, const PhotoRecord& record,
                            const Seen& seen) const {
    const int recordings = static_cast<int>(record.tags.size());
    const bool looked = seen && seen->width > 0;
    if (looked && style_.length == Choices::Descriptions::full) {
        const QString count =
            record.tags.empty() ? tr("No recordings yet.") : tr("%n recording(s).", nullptr, recordings);
        return tr("%1 %2", "two sentences").arg(seen_in_full(record, *seen), count);
    }
    const QString what = looked && style_.length == Choices::Descriptions::brief
                             ? seen_in_short(photo, record, *seen)
                             : known_of(photo, record);
    return record.tags.empty() ? tr("%1; no recordings yet.").arg(what)
                               : tr("%1; %n recording(s).", nullptr, recordings).arg(what);
}

QString PhotoWords::known_of(const std::filesystem::path& photo, const PhotoRecord& record) const {
    QStringList who = people(record);
    if (const int more = unnamed(record); more > 0)
        who << (who.isEmpty() ? tr("%n face(s)", nullptr, more) : tr("%n more face(s)", nullptr, more));
    QStringList known;
    if (!who.isEmpty())
        known << locale_.createSeparatedList(who);
    if (const QString when = month(QString::fromStdString(record.taken)); !when.isEmpty())
        known << when;
    if (const QString place = plain(record.place_name).section(QStringLiteral(", "), 0, 0); !place.isEmpty())
        known << place;
    if (known.isEmpty())
        known << file_name(photo);
    return known.join(tr(", ", "between who, when and where"));
}

QString PhotoWords::seen_in_short(const std::filesystem::path& photo, const PhotoRecord& record,
                                  const SeenPhoto& seen) const {
    const PhotoView view = view_of(seen, record, locale_.language());
    QString text = short_description(view, locale_.language(), order_of(style_));
    if (view.people.empty() && view.elsewhere.isEmpty() && !view.date.isValid() && view.town.isEmpty())
        text += tr(", ", "between who, when and where") + file_name(photo);
    return begun_large(text);
}

QString PhotoWords::seen(const PhotoRecord& record, const Seen& seen) const {
    if (!seen || seen->width <= 0 || style_.length == Choices::Descriptions::none)
        return {};
    if (style_.length == Choices::Descriptions::full)
        return seen_in_full(record, *seen);
    PhotoView view = view_of(*seen, record, locale_.language());
    view.date = QDate(); // said before
    view.town.clear();
    return begun_large(short_description(view, locale_.language())) + QLatin1Char('.');
}

QString PhotoWords::seen_in_full(const PhotoRecord& record, const SeenPhoto& seen) const {
    return full_description(view_of(seen, record, locale_.language()), locale_.language(), order_of(style_));
}

std::vector<PhotoDetail> PhotoWords::details(const std::filesystem::path& photo, const PhotoRecord& record,
                                             const Seen& seen) const {
    std::vector<PhotoDetail> details;
    const auto add = [&](const QString& text) {
        if (!text.isEmpty())
            details.push_back({text, {}});
    };
    const bool looked = seen && seen->width > 0 && style_.length != Choices::Descriptions::none;
    if (looked && style_.length == Choices::Descriptions::brief)
        add(seen_in_full(record, *seen));
    for (const QString& name : people(record))
        add(name);
    if (const int faces = unnamed(record); faces > 0 && !looked)
        add(tr("%n face(s) without a name.", nullptr, faces));
    const std::vector<Tag> tags = in_playing_order(record.tags);
    for (std::size_t i = 0; i < tags.size(); ++i)
        details.push_back({tr("Recording %1 of %2: %3, %4.")
                               .arg(i + 1)
                               .arg(tags.size())
                               .arg(recording(tags[i]), duration(tags[i].duration_s)),
                           i});
    add(in_our_language(record.alt_text));
    add(in_our_language(record.description));
    if (const QString place = plain(record.place_name); !place.isEmpty())
        add(tr("Place: %1.").arg(place));
    else if (record.place)
        add(tr("Place: %1 degrees north, %2 degrees east.")
                .arg(locale_.toString(record.place->latitude, 'f', 4),
                     locale_.toString(record.place->longitude, 'f', 4)));
    if (const QString when = moment(QString::fromStdString(record.taken)); !when.isEmpty())
        add(tr("Taken: %1.").arg(when));
    if (!record.keywords.empty()) {
        QStringList words;
        for (const std::string& keyword : record.keywords)
            words << plain(keyword);
        add(tr("Keywords: %1.").arg(words.join(tr(", ", "between keywords"))));
    }
    add(tr("File: %1.").arg(file_name(photo)));
    return details;
}

QString PhotoWords::recording(const Tag& tag) const {
    const QString speaker = plain(tag.label.speaker), person = plain(tag.label.person);
    switch (tag.label.kind) {
    case RecordingKind::memo:
        return speaker.isEmpty() ? tr("memo") : tr("memo by %1").arg(speaker);
    case RecordingKind::person:
        if (person.isEmpty())
            return speaker.isEmpty() ? tr("about a person") : tr("about a person, by %1").arg(speaker);
        return speaker.isEmpty() ? tr("about %1").arg(person) : tr("about %1, by %2").arg(person, speaker);
    case RecordingKind::place:
        return speaker.isEmpty() ? tr("about the place") : tr("about the place, by %1").arg(speaker);
    case RecordingKind::story:
        return speaker.isEmpty() ? tr("story") : tr("story by %1").arg(speaker);
    case RecordingKind::ambient:
        return tr("background sounds");
    }
    return {};
}

QString PhotoWords::duration(double seconds) const {
    const long long exact = std::llround(std::max(seconds, 0.0));
    const long long whole = exact < 600 ? exact : (exact + 30) / 60 * 60;
    const int hours = static_cast<int>(whole / 3600), minutes = static_cast<int>(whole / 60 % 60),
              rest = static_cast<int>(whole % 60);
    QStringList words;
    if (hours > 0)
        words << tr("%n hour(s)", nullptr, hours);
    if (minutes > 0)
        words << tr("%n minute(s)", nullptr, minutes);
    if (rest > 0 || words.isEmpty())
        words << tr("%n second(s)", nullptr, rest);
    return words.join(QLatin1Char(' '));
}

QString PhotoWords::clock(double seconds) {
    const long long whole = std::llround(std::max(seconds, 0.0));
    const QString end = QStringLiteral("%1").arg(whole % 60, 2, 10, QLatin1Char('0'));
    if (whole < 3600)
        return QStringLiteral("%1:%2").arg(whole / 60).arg(end);
    return QStringLiteral("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(end);
}

QString PhotoWords::month(const QString& taken) const {
    const QDate date = date_of(taken);
    return date.isValid() ? tr("%1 %2", "the month's name and the year")
                                .arg(locale_.standaloneMonthName(date.month()))
                                .arg(date.year())
                          : QString();
}

QString PhotoWords::moment(const QString& taken) const {
    const QDate date = date_of(taken);
    if (!date.isValid())
        return {};
    const QTime time = QTime::fromString(taken.mid(11, 5), QStringLiteral("HH:mm"));
    const QString day = locale_.toString(date, QLocale::LongFormat);
    return time.isValid()
               ? tr("%1, %2", "a day and a time").arg(day, locale_.toString(time, QLocale::ShortFormat))
               : day;
}

QString PhotoWords::in_our_language(const LanguageTexts& texts) const {
    if (texts.empty())
        return {};
    const std::string ours = QLocale::languageToCode(locale_.language()).toStdString();
    for (const auto& [language, text] : texts)
        if (language == ours || language.starts_with(ours + "-"))
            return plain(text);
    const auto everybodys = texts.find("x-default");
    return plain((everybodys != texts.end() ? everybodys : texts.begin())->second);
}

} // namespace tp
