// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_words.hpp"

#include "app/pages/care/described_in.hpp"
#include "audio/sentences/sentences.hpp"
#include "audio/sound/sound_words.hpp"
#include "core/files/file_words.hpp"

#include <QDateTime>
#include <QHash>
#include <QLocale>
#include <QTimeZone>

#include <algorithm>
#include <cmath>

namespace tp {

QString CareWords::text(const std::string& text) { return QString::fromStdString(readable(text)); }

QString CareWords::file_name(const std::filesystem::path& file) { return text(file.filename().string()); }

QString CareWords::kind(RecordingKind kind) {
    switch (kind) {
    case RecordingKind::memo:
        return tr("Memo");
    case RecordingKind::person:
        return tr("Who it is");
    case RecordingKind::place:
        return tr("Place");
    case RecordingKind::story:
        return tr("Story");
    case RecordingKind::ambient:
        return tr("Background sounds");
    }
    return {};
}

QStringList CareWords::kinds() {
    QStringList all;
    for (const RecordingKind one : {RecordingKind::memo, RecordingKind::person, RecordingKind::place,
                                    RecordingKind::story, RecordingKind::ambient})
        all << kind(one);
    return all;
}

QString CareWords::recording(const RecordingLabel& label) {
    return label.person.empty() ? kind(label.kind) : tr("%1, about %2").arg(kind(label.kind), text(label.person));
}

QString CareWords::recording_details(const Tag& tag) {
    QStringList details{duration_words(tag.duration_s)};
    if (!tag.label.speaker.empty())
        details << tr("spoken by %1").arg(text(tag.label.speaker));
    if (const QDateTime when = QDateTime::fromString(QString::fromStdString(tag.label.recorded), Qt::ISODate);
        when.isValid())
        details << QLocale().toString(when.date(), QLocale::LongFormat);
    return details.join(", ");
}

QString CareWords::language(const QString& tag) {
    // Where Qt takes a tag without a country for one with it.
    static const QHash<QString, QString> plain{{"en", "English"}, {"es", "español"}, {"pt", "português"}, {"zh", "中文"}};
    if (const auto name = plain.constFind(tag); name != plain.constEnd())
        return *name;
    const QLocale locale(tag);
    return locale == QLocale::c() || locale.nativeLanguageName().isEmpty() ? tag : locale.nativeLanguageName();
}

QString CareWords::seconds(double seconds) { return tr("%1 seconds").arg(QLocale().toString(seconds, 'f', 1)); }

QString CareWords::clock(double seconds) {
    const auto whole = static_cast<long long>(std::floor(std::max(seconds, 0.0)));
    return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
}

QString CareWords::photo_details(const PhotoRecord& record, const QString& language) {
    QStringList people, sentences;
    for (const std::string& person : record.persons)
        people << text(person);
    if (!people.isEmpty())
        sentences << tr("%1.").arg(people.join(", "));
    if (!record.tags.empty())
        sentences << tr("%n recording(s).", nullptr, static_cast<int>(record.tags.size()));
    const std::string key = described_in(record, language);
    if (text_in(record.alt_text, key).isEmpty() && text_in(record.description, key).isEmpty())
        sentences << tr("No description.");
    return sentences.join(' ');
}

QString CareWords::person(const Person& person) {
    if (!person.name.empty())
        return text(person.name);
    return person.perhaps.empty() ? tr("Who is this?")
                                  : tr("Who is this? Perhaps %1.").arg(text(person.perhaps));
}

QString CareWords::person_details(const Person& person) {
    const QString photos = tr("%n photograph(s)", nullptr, static_cast<int>(person.photos));
    if (person.name.empty() || person.to_confirm == 0)
        return photos;
    return tr("%1, %2").arg(photos, tr("%n to confirm", nullptr, static_cast<int>(person.to_confirm)));
}

QString CareWords::people(const People& people) {
    const auto unnamed = static_cast<int>(
        std::ranges::count_if(people.persons, [](const Person& person) { return person.name.empty(); }));
    QStringList sentences;
    if (people.persons.empty())
        sentences << tr("Nobody was seen on two photographs yet.");
    else
        sentences << (unnamed > 0 ? tr("%n person(s) without a name.", nullptr, unnamed)
                                  : tr("Everybody here has a name."));
    std::size_t to_confirm = 0;
    for (const Person& person : people.persons)
        to_confirm += person.name.empty() ? 0 : person.to_confirm;
    if (to_confirm > 0)
        sentences << tr("%n face(s) to confirm.", nullptr, static_cast<int>(to_confirm));
    if (people.to_look > 0) {
        if (people.persons.empty())
            sentences.clear();
        sentences << tr("%n photograph(s) still to be looked at.", nullptr, static_cast<int>(people.to_look));
    }
    if (people.alone > 0)
        sentences << tr("%n face(s) on one photograph only.", nullptr, static_cast<int>(people.alone));
    if (people.not_guessed > 0)
        sentences << tr("%n face(s) too small, blurred, turned or covered to be compared.", nullptr,
                        static_cast<int>(people.not_guessed));
    return sentences.join(' ');
}

QString CareWords::face_details(const PersonFace& face, bool to_confirm) {
    const QString day = QLocale().toString(
        QDateTime::fromMSecsSinceEpoch(face.moment_ms, QTimeZone::utc()).date(), QLocale::LongFormat);
    return to_confirm ? tr("%1, to confirm").arg(day) : day;
}

QString CareWords::import_progress(const ImportProgress& progress) {
    const auto megabytes = [](std::uintmax_t bytes) {
        return QLocale().toString(static_cast<double>(bytes) / 1e6, 'f', 1);
    };
    const QString count = tr("%1 of %2 photographs, %3 of %4 megabytes")
                              .arg(progress.done)
                              .arg(progress.total)
                              .arg(megabytes(progress.bytes_done), megabytes(progress.bytes_total));
    return progress.seconds_left && progress.done < progress.total
               ? tr("%1, about %2 left").arg(count, duration_words(*progress.seconds_left))
               : count;
}

QString CareWords::import_report(const ImportReport& report) {
    const auto number = [&](ImportedPhoto::Fate fate) { return static_cast<int>(report.count(fate)); };
    const int imported = number(ImportedPhoto::Fate::imported);
    const int there = number(ImportedPhoto::Fate::duplicate);
    const int failed = number(ImportedPhoto::Fate::failed);
    if (report.photos.empty())
        return report.stopped ? tr("The import was stopped before the first photograph.")
                              : tr("There is no photograph in what you chose.");
    QStringList parts;
    if (imported > 0 || (there == 0 && failed == 0))
        parts << tr("%n photograph(s) imported", nullptr, imported);
    if (there > 0)
        parts << tr("%n of them already in the album", nullptr, there);
    if (const auto replies = static_cast<int>(report.count_replies()); replies > 0)
        parts << tr("%n of these with something new", nullptr, replies);
    if (failed > 0)
        parts << tr("%n failed", nullptr, failed);
    QString words = tr("%1.").arg(parts.join(", "));
    if (failed > 0) {
        const auto first = std::find_if(report.photos.begin(), report.photos.end(), [](const ImportedPhoto& photo) {
            return photo.fate == ImportedPhoto::Fate::failed;
        });
        words = tr("%1: %2").arg(parts.join(", "), in_persons_language(first->problem));
    }
    if (report.stopped)
        words = tr("%1 The import was stopped; you can continue it later.").arg(words);
    return words;
}

} // namespace tp
