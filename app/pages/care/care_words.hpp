// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/people.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/metadata/photo_record.hpp"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <string>

namespace tp {

/// What the care page shows and says of recordings, photographs and imports.
class CareWords {
    Q_DECLARE_TR_FUNCTIONS(CareWords)
public:
    /// "Memo", "Story", …
    static QString kind(RecordingKind kind);
    /// All kinds, in their order.
    static QStringList kinds();
    /// "Memo about Anna"
    static QString recording(const RecordingLabel& label);
    /// "12 seconds, spoken by Tom, 1 May 2026"
    static QString recording_details(const Tag& tag);
    /// A language in its own words, "Deutsch"; the tag itself (BCP 47) where it is not known.
    static QString language(const QString& tag);
    /// "1.2 seconds"
    static QString seconds(double seconds);
    /// "1:05", for the eye.
    static QString clock(double seconds);
    /// "Anna, Tom. 2 recordings. No description."
    static QString photo_details(const PhotoRecord& record, const QString& language);
    /// "Anna", "Who is this?", "Who is this? Perhaps Anna."
    static QString person(const Person& person);
    /// "23 photographs, 4 of them to confirm"
    static QString person_details(const Person& person);
    /// How many people wait for a name, and who is not among them.
    static QString people(const People& people);
    /// "1 May 2026, to confirm": where nobody has said yet that the face is that of its group's person.
    static QString face_details(const PersonFace& face, bool to_confirm);
    /// "3 of 12 photographs, about 40 seconds left"
    static QString import_progress(const ImportProgress& progress);
    /// "12 photographs imported, 3 were there already, 1 failed: …"
    static QString import_report(const ImportReport& report);

    /// Any text or file name as words.
    static QString text(const std::string& text);
    static QString file_name(const std::filesystem::path& file);
};

} // namespace tp
