// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/photo_words.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace photo_words_test {

using namespace tp;

namespace {

const QLocale english(QLocale::English, QLocale::UnitedKingdom);
const std::filesystem::path photo = "/album/IMG_1.jpg";

Tag tag(RecordingKind kind, const std::string& speaker, double duration_s, int order = 0) {
    Tag made;
    made.file = std::string(name_of(kind)) + speaker + ".flac";
    made.label.kind = kind;
    made.label.speaker = speaker;
    made.duration_s = duration_s;
    made.order = order;
    return made;
}

PhotoRecord garden() {
    PhotoRecord record;
    record.persons = {"Anna", "Tom"};
    record.faces = {{0.3, 0.3, 0.1, 0.1, "Anna"}, {0.5, 0.3, 0.1, 0.1, "Tom"}, {0.7, 0.3, 0.1, 0.1, ""}};
    record.taken = "2026-05-01T10:15:00+02:00";
    record.place_name = "Vienna, Austria";
    record.alt_text = {
        {"de", "Zwei Menschen"}, {"en-GB", "Two people in a garden"}, {"x-default", "somebody"}};
    record.keywords = {"garden", "spring"};
    record.tags = {tag(RecordingKind::ambient, "", 3.0), tag(RecordingKind::story, "Ben", 65.0),
                   tag(RecordingKind::memo, "Tom", 12.4)};
    return record;
}

/// Two who smile, of whom nobody has said who they are.
SeenPhoto smiling_people() {
    SeenPhoto seen;
    seen.width = 4000;
    seen.height = 3000;
    seen.faces.resize(2);
    seen.faces[0].part = {Vec2(0.05, 0.05), Vec2(0.25, 0.3)};
    seen.faces[1].part = {Vec2(0.75, 0.05), Vec2(0.95, 0.3)};
    for (SeenFace& face : seen.faces)
        face.mien = Mien::smiling;
    return seen;
}

QStringList texts(const std::vector<PhotoDetail>& details) {
    QStringList all;
    for (const PhotoDetail& detail : details)
        all << detail.text;
    return all;
}

} // namespace

class PhotoWordsTest : public QObject {
    Q_OBJECT
private slots:
    void the_summary_says_who_when_where_and_how_much_can_be_heard() {
        const PhotoWords words(english);
        QCOMPARE(words.summary(photo, garden()),
                 QString("Anna, Tom and 1 more face(s), May 2026, Vienna; 3 recording(s)."));
        PhotoRecord record = garden();
        record.faces.pop_back();
        record.tags.clear();
        QCOMPARE(words.summary(photo, record), QString("Anna and Tom, May 2026, Vienna; no recordings yet."));
        record.persons = {};
        record.faces = {FaceRegion{}, FaceRegion{}};
        QCOMPARE(words.summary(photo, record), QString("2 face(s), May 2026, Vienna; no recordings yet."));
    }

    void with_nothing_known_the_file_has_a_name() {
        const PhotoWords words(english);
        QCOMPARE(words.summary(photo, {}), QString("IMG_1.jpg; no recordings yet."));
        QCOMPARE(texts(words.details(photo, {})), QStringList("File: IMG_1.jpg."));
        QCOMPARE(words.summary("/album/f\xF6o\n.jpg", {}),
                 QString::fromUtf8("f\xEF\xBF\xBDo .jpg; no recordings yet."));
    }

    /// What is seen is said with the names, and nothing twice.
    void what_is_seen_is_said_after_the_names_and_before_the_recordings() {
        PhotoRecord record = garden();
        record.tags.clear();
        record.faces.clear();
        const PhotoWords brief(english);
        QCOMPARE(brief.summary(photo, record, smiling_people()),
                 QString("Anna and Tom, both smiling, May 2026, Vienna; no recordings yet."));
        QCOMPARE(brief.summary(photo, {}, smiling_people()),
                 QString("Two people, both smiling; no recordings yet."));
        const QStringList details = texts(brief.details(photo, {}, smiling_people()));
        QCOMPARE(
            details,
            QStringList({"Two people: one at the left, smiling; one at the right, smiling. A wide picture.",
                         "File: IMG_1.jpg."}));
        const PhotoWords full({Choices::Descriptions::full, true}, english);
        QCOMPARE(full.summary(photo, record, smiling_people()),
                 QString("A Friday morning in May 2026, in Vienna. Two people: one at the left, smiling; one "
                         "at the right, "
                         "smiling; named: Anna and Tom. A wide picture. No recordings yet."));
        QVERIFY(full.summary(photo, garden(), smiling_people()).endsWith(" A wide picture. 3 recording(s)."));
        QCOMPARE(texts(full.details(photo, {}, smiling_people())), QStringList("File: IMG_1.jpg."));
    }

    void who_wants_no_descriptions_hears_none() {
        const PhotoWords words({Choices::Descriptions::none, false}, english);
        QCOMPARE(words.summary(photo, garden(), smiling_people()), words.summary(photo, garden()));
        QVERIFY(words.details(photo, garden(), smiling_people()) == words.details(photo, garden()));
        const PhotoWords brief(english);
        QCOMPARE(brief.summary(photo, garden(), SeenPhoto()),
                 brief.summary(photo, garden())); // it could not be read
    }

    void a_photograph_on_which_nothing_is_seen_keeps_its_name() {
        SeenPhoto nothing = smiling_people();
        nothing.faces.clear();
        QCOMPARE(PhotoWords(english).summary(photo, {}, nothing),
                 QString("No faces, IMG_1.jpg; no recordings yet."));
        PhotoRecord record;
        record.taken = "2026-05-01";
        QCOMPARE(PhotoWords(english).summary(photo, record, nothing),
                 QString("No faces, May 2026; no recordings yet."));
    }

    void names_and_months_are_written_as_the_person_writes_them() {
        PhotoRecord record = garden();
        record.faces.clear();
        QCOMPARE(PhotoWords(QLocale(QLocale::German, QLocale::Germany)).summary(photo, record),
                 QString("Anna und Tom, Mai 2026, Vienna; 3 recording(s)."));
        record.persons = {"Anna %n", " Tom\n%1 "};
        QCOMPARE(PhotoWords(english).summary(photo, record),
                 QString("Anna %n and Tom %1, May 2026, Vienna; 3 recording(s)."));
    }

    void details_come_in_the_order_of_what_people_ask_first() {
        const QStringList said = texts(PhotoWords(english).details(photo, garden()));
        QCOMPARE(said.mid(0, 3), QStringList({"Anna", "Tom", "1 face(s) without a name."}));
        QCOMPARE(said.mid(3, 3), QStringList({"Recording 1 of 3: memo by Tom, 12 second(s).",
                                              "Recording 2 of 3: story by Ben, 1 minute(s) 5 second(s).",
                                              "Recording 3 of 3: background sounds, 3 second(s)."}));
        QCOMPARE(said[6], QString("Two people in a garden"));
        QCOMPARE(said[7], QString("Place: Vienna, Austria."));
        QVERIFY2(said[8].startsWith("Taken: ") && said[8].contains("1 May 2026") && said[8].contains("10:15"),
                 qPrintable(said[8]));
        QCOMPARE(said.mid(9), QStringList({"Keywords: garden, spring.", "File: IMG_1.jpg."}));
    }

    void details_of_recordings_name_them_by_their_place() {
        const auto details = PhotoWords(english).details(photo, garden());
        QCOMPARE(details[2].recording, std::optional<std::size_t>());
        QCOMPARE(details[3].recording, std::optional<std::size_t>(0));
        QCOMPARE(details[5].recording, std::optional<std::size_t>(2));
    }

    void a_persons_own_order_comes_before_the_usual_one() {
        const std::vector<Tag> ordered =
            in_playing_order({tag(RecordingKind::memo, "a", 1.0), tag(RecordingKind::ambient, "b", 1.0, 2),
                              tag(RecordingKind::story, "c", 1.0, 1), tag(RecordingKind::person, "d", 1.0),
                              tag(RecordingKind::memo, "e", 1.0)});
        QString speakers;
        for (const Tag& one : ordered)
            speakers += QString::fromStdString(one.label.speaker);
        QCOMPARE(speakers, QString("cbaed"));
    }

    void every_kind_of_recording_has_words_with_and_without_a_speaker() {
        const PhotoWords words(english);
        for (const auto kind :
             {RecordingKind::memo, RecordingKind::person, RecordingKind::place, RecordingKind::story}) {
            QVERIFY(!words.recording(tag(kind, "", 1.0)).isEmpty());
            QVERIFY(words.recording(tag(kind, "Ben", 1.0)).endsWith("by Ben"));
        }
        Tag about = tag(RecordingKind::person, "Ben", 1.0);
        about.label.person = "Anna";
        QCOMPARE(words.recording(about), QString("about Anna, by Ben"));
    }

    void a_date_without_a_time_or_that_is_none() {
        PhotoRecord record;
        record.taken = "2026-05-01";
        QVERIFY(texts(PhotoWords(english).details(photo, record))[0].endsWith("1 May 2026."));
        record.taken = "yesterday";
        QCOMPARE(PhotoWords(english).summary(photo, record), QString("IMG_1.jpg; no recordings yet."));
        record.place = Place{48.2, 16.37};
        QVERIFY(texts(PhotoWords(english).details(photo, record))[0].contains("48.2000"));
    }

    void times() {
        QCOMPARE(PhotoWords::clock(0.0), QString("0:00"));
        QCOMPARE(PhotoWords::clock(65.4), QString("1:05"));
        QCOMPARE(PhotoWords::clock(3727.0), QString("1:02:07"));
        QCOMPARE(PhotoWords::clock(-1.0), QString("0:00"));
        QCOMPARE(PhotoWords(english).duration(4980.0), QString("1 hour(s) 23 minute(s)"));
        QCOMPARE(PhotoWords(english).duration(0.2), QString("0 second(s)"));
    }
};

} // namespace photo_words_test

TP_TEST(photo_words_test, PhotoWordsTest, event_loop)
#include "photo_words_test.moc"
