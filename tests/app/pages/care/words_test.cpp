// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_words.hpp"
#include "app/pages/care/described_in.hpp"
#include "app/pages/care/import_pace.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace words_test {

using namespace tp;

class CareWordsTest : public QObject {
    Q_OBJECT
private slots:
    void a_recording_is_told_by_kind_person_length_speaker_and_date() {
        const Tag tag{"x.flac", {RecordingKind::memo, "Anna", "Tom", "en", "2026-05-01T10:15:00+02:00", {}}, 12.0, 0.0, 0};
        QCOMPARE(CareWords::recording(tag.label), QString("Memo, about Anna"));
        QCOMPARE(CareWords::recording_details(tag), QString("12 seconds, spoken by Tom, Friday, 1 May 2026"));
        QCOMPARE(CareWords::recording_details({"x.flac", {}, 1.0, 0.0, 0}), QString("1 second"));
        QCOMPARE(CareWords::kinds().size(), 5);
    }

    void places_in_a_recording_have_tenths_for_the_ear_and_minutes_for_the_eye() {
        QCOMPARE(CareWords::seconds(1.24), QString("1.2 seconds"));
        QCOMPARE(CareWords::clock(65.9), QString("1:05"));
        QCOMPARE(CareWords::clock(-1.0), QString("0:00"));
    }

    void a_language_is_called_as_those_call_it_who_speak_it() {
        QCOMPARE(CareWords::language("de"), QString("Deutsch"));
        QCOMPARE(CareWords::language("en"), QString("English"));
        QCOMPARE(CareWords::language("ko"), QString("한국어"));
        QCOMPARE(CareWords::language("tlh"), QString("tlh"));
    }

    void a_photograph_is_told_by_people_recordings_and_a_missing_description() {
        PhotoRecord record;
        QCOMPARE(CareWords::photo_details(record, "en"), QString("No description."));
        record.persons = {"Anna", "Tom"};
        record.tags.resize(2);
        record.alt_text["en-GB"] = "Two people";
        QCOMPARE(CareWords::photo_details(record, "en"), QString("Anna, Tom. 2 recording(s)."));
    }

    void what_became_of_an_import_is_one_sentence_with_the_first_fault() {
        ImportReport report;
        QCOMPARE(CareWords::import_report(report), QString("There is no photograph in what you chose."));
        for (int i = 0; i < 12; ++i)
            report.photos.push_back({});
        for (int i = 0; i < 3; ++i)
            report.photos.push_back({{}, {}, ImportedPhoto::Fate::duplicate, {}, {}});
        QCOMPARE(CareWords::import_report(report),
                 QString("12 photograph(s) imported, 3 of them already in the album."));
        report.photos.push_back({{}, {}, ImportedPhoto::Fate::failed, "The card is damaged.", {}});
        QCOMPARE(
            CareWords::import_report(report),
            QString(
                "12 photograph(s) imported, 3 of them already in the album, 1 failed: The card is damaged."));
        report.stopped = true;
        QVERIFY(
            CareWords::import_report(report).endsWith("The import was stopped; you can continue it later."));
    }

    void progress_says_how_much_and_how_long() {
        ImportProgress progress;
        progress.done = 3;
        progress.total = 12;
        progress.bytes_done = 12'340'000;
        progress.bytes_total = 50'000'000;
        QCOMPARE(CareWords::import_progress(progress), QString("3 of 12 photographs, 12.3 of 50.0 megabytes"));
        progress.seconds_left = 40.0;
        QVERIFY(CareWords::import_progress(progress).endsWith(", about 40 seconds left"));
    }

    void long_work_is_told_at_quarters_and_after_a_silent_minute_but_not_all_the_time() {
        ImportPace pace;
        QVERIFY(!pace.due(0.0, 0.0));
        QVERIFY(!pace.due(0.3, 2.0)); // too soon after its begin
        QVERIFY(pace.due(0.3, 6.0));
        QVERIFY(!pace.due(0.4, 20.0));
        QVERIFY(pace.due(0.4, 66.0));
        QVERIFY(!pace.due(0.76, 68.0));
        QVERIFY(pace.due(0.76, 72.0)); // two quarters in one word
        QVERIFY(!pace.due(0.8, 78.0));
        QVERIFY(!pace.due(1.0, 100.0)); // its end is told by the report
        QVERIFY(!pace.due(std::numeric_limits<double>::quiet_NaN(), 101.0));
    }

    void the_language_of_a_description_is_the_nearest_that_is_there() {
        PhotoRecord record;
        QCOMPARE(described_in(record, "de"), std::string("de"));
        record.description["x-default"] = "for all";
        QCOMPARE(described_in(record, "de"), std::string("x-default"));
        record.alt_text["de-AT"] = "Servus";
        QCOMPARE(described_in(record, "de"), std::string("de-AT"));
        record.description["de"] = "Hallo";
        QCOMPARE(described_in(record, "de"), std::string("de"));
        QCOMPARE(text_in(record.description, "de"), QString("Hallo"));
        QCOMPARE(text_in(record.alt_text, "de"), QString());
    }
};

} // namespace words_test

TP_TEST(words_test, CareWordsTest, nothing)
#include "words_test.moc"
