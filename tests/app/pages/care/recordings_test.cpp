// SPDX-License-Identifier: Apache-2.0
#include "album_parts.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "care_bench.hpp"

#include <QSignalSpy>

#include <cmath>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// An album whose photograph has a memo of 2 s and a story of 1 s.
struct TwoRecordings : CareBench {
    std::string memo, story;
    TwoRecordings() {
        memo = add_sound("a.jpg", 2.0, 300.0, RecordingKind::memo);
        story = add_sound("a.jpg", 1.0, 500.0, RecordingKind::story);
        open("a.jpg");
    }
    RecordingList& list() { return *session->recordings(); }
    std::vector<std::string> order() const {
        std::vector<Tag> tags = record().tags;
        std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.order < b.order; });
        std::vector<std::string> files;
        for (const Tag& tag : tags)
            files.push_back(tag.file);
        return files;
    }
};

using Files = std::vector<std::string>;

} // namespace

class CareRecordingsTest : public QObject {
    Q_OBJECT
private slots:
    void they_are_listed_as_they_are_played() {
        TwoRecordings bench;
        QCOMPARE(texts(bench.list()), QStringList({"Memo", "Story"}));
        QCOMPARE(bench.list().chosen(), 0);
        bench.list().choose(1);
        QVERIFY(bench.last_said().startsWith("Story, 1 second"));
        QVERIFY(bench.last_said().endsWith(", 2 of 2"));
        bench.list().choose(7);
        QCOMPARE(bench.list().chosen(), 1);
    }

    void the_chosen_one_is_moved_and_stays_chosen() {
        TwoRecordings bench;
        bench.list().choose(1);
        bench.list().move(-1);
        QVERIFY(bench.rests());
        QCOMPARE(texts(bench.list()), QStringList({"Story", "Memo"}));
        QCOMPARE(bench.list().chosen(), 0);
        QCOMPARE(bench.order(), (Files{bench.story, bench.memo}));
        QCOMPARE(bench.last_said(), QString("Story is now number 1 of 2."));
        QVERIFY(bench.sounded(Earcon::saved));
        bench.list().move(-1);
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("This is the first one."));
        QVERIFY(bench.sounded(Earcon::error));
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QCOMPARE(texts(bench.list()), QStringList({"Memo", "Story"}));
    }

    void one_is_deleted_and_brought_back() {
        TwoRecordings bench;
        bench.list().remove();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Deleted: Memo. Undo brings it back."));
        QVERIFY(bench.sounded(Earcon::deleted));
        QCOMPARE(texts(bench.list()), QStringList{"Story"});
        QCOMPARE(bench.list().chosen(), 0);
        QVERIFY(!fs::exists(tags_folder(bench.photo("a.jpg")) / bench.memo));
        QCOMPARE(bench.session->history()->undoText(), QString("the memo was deleted"));
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Undone: the memo was deleted."));
        QVERIFY(bench.sounded(Earcon::undone));
        QVERIFY(fs::exists(tags_folder(bench.photo("a.jpg")) / bench.memo));
        QCOMPARE(texts(bench.list()), QStringList({"Memo", "Story"}));
        QCOMPARE(bench.session->history()->redoText(), QString("the memo was deleted"));
        bench.session->history()->redo();
        QVERIFY(bench.rests());
        QCOMPARE(texts(bench.list()), QStringList{"Story"});
        QCOMPARE(bench.last_said(), QString("Redone: the memo was deleted."));
    }

    void its_label_is_changed() {
        TwoRecordings bench;
        bench.list().setPerson(" Anna ");
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Saved: Memo, about Anna."));
        bench.list().setSpeaker("Tom");
        QVERIFY(bench.rests());
        const auto german = static_cast<int>(bench.list().languageNames().indexOf("Deutsch"));
        QVERIFY(german > 0);
        bench.list().setLanguage(german);
        QVERIFY(bench.rests());
        bench.list().setKind(static_cast<int>(RecordingKind::place));
        QVERIFY(bench.rests());
        const auto record = bench.record();
        const auto tag = std::find_if(record.tags.begin(), record.tags.end(), [&](const Tag& one) { return one.file == bench.memo; });
        QVERIFY(tag != record.tags.end());
        QCOMPARE(tag->label.person, std::string("Anna"));
        QCOMPARE(tag->label.speaker, std::string("Tom"));
        QCOMPARE(tag->label.language, std::string("de"));
        QVERIFY(tag->label.kind == RecordingKind::place);
        QCOMPARE(bench.list().language(), german);
        QCOMPARE(bench.list().kind(), static_cast<int>(RecordingKind::place));
    }

    void the_same_label_again_is_no_step() {
        TwoRecordings bench;
        const QString before = bench.session->history()->undoText();
        bench.list().setKind(static_cast<int>(RecordingKind::memo));
        bench.list().setPerson("");
        bench.list().setLanguage(0);
        QVERIFY(!bench.session->busy());
        QCOMPARE(bench.session->history()->undoText(), before);
    }

    void sound_files_are_taken_in_and_what_is_none_is_a_sentence() {
        CareBench bench;
        bench.open("a.jpg");
        const fs::path sound = a_sound(bench.folder, "s/x.wav", 0.5, 440.0);
        const fs::path text = bench.folder.write("s/no.wav", "no sound");
        bench.session->recordings()->addFiles({QUrl::fromLocalFile(QString::fromStdString(text.string())),
                                               QUrl::fromLocalFile(QString::fromStdString(sound.string()))},
                                              static_cast<int>(RecordingKind::story));
        QVERIFY(bench.rests());
        QVERIFY(bench.voice.said().join('\n').contains("no.wav"));
        QVERIFY(bench.last_said().startsWith("Added: Story"));
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
        bench.session->recordings()->addFiles({QUrl("https://example.org/x.wav")}, 0);
        QCOMPARE(bench.last_said(), QString("Only a sound that is a file on this computer can be added."));
    }

    // --- recording ---

    void a_photograph_that_is_deleted_takes_the_recording_that_is_being_made_along() {
        CareBench bench;
        bench.open("a.jpg");
        bench.session->take()->start();
        bench.hear(1.0);
        bench.session->deletePhoto();
        QVERIFY(!bench.session->photoOpen());
        CARE_TRY_COMPARE(bench.last_said(), QString("Deleted: a.jpg. Undo brings it back."));
        QVERIFY(bench.rests());
        QVERIFY(!std::filesystem::exists(bench.photo("a.jpg")));
        QVERIFY(!std::filesystem::exists(tags_folder(bench.photo("a.jpg"))));
        bench.session->history()->undo();
        CARE_TRY_VERIFY(bench.session->photoOpen());
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
        QCOMPARE(bench.record().tags[0].duration_s, 1.0);
    }

    void nothing_is_taken_back_under_a_recording_and_none_begins_meanwhile() {
        CareBench bench;
        bench.open("a.jpg");
        bench.session->deletePhoto();
        QVERIFY(bench.rests());
        bench.session->history()->undo();
        CARE_TRY_VERIFY(bench.session->photoOpen());
        QVERIFY(bench.rests());
        bench.session->history()->redo();
        bench.session->take()->start();
        QVERIFY(!bench.session->take()->running());
        QCOMPARE(bench.last_said(), QString("The album is still being changed. Try again in a moment."));
        QVERIFY(bench.rests());
        QVERIFY(!bench.session->photoOpen());
        bench.session->history()->undo();
        CARE_TRY_VERIFY(bench.session->photoOpen());
        QVERIFY(bench.rests());
        bench.session->take()->start();
        bench.hear(1.0);
        bench.session->history()->undo();
        bench.session->history()->redo();
        QCOMPARE(bench.last_said(), QString("A recording is being made. Finish it first."));
        bench.session->take()->finish();
        CARE_TRY_VERIFY(!bench.session->take()->running());
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
    }

    void a_take_belongs_to_the_photograph_that_it_was_begun_for() {
        CareBench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        bench.session->take()->start();
        bench.hear(1.0);
        bench.open("b.jpg"); // ends and keeps it
        CARE_TRY_VERIFY(!bench.session->take()->running());
        QVERIFY(bench.rests());
        QCOMPARE(bench.record("a.jpg").tags.size(), std::size_t{1});
        QVERIFY(bench.record("b.jpg").tags.empty());
        QCOMPARE(bench.session->recordings()->count(), 0);
    }

    void leaving_the_page_keeps_what_was_recorded() {
        CareBench bench;
        bench.open("a.jpg");
        bench.session->take()->start();
        bench.hear(1.0);
        bench.session->leave();
        CARE_TRY_VERIFY(!bench.session->take()->running());
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
    }

    void the_microphone_is_off_behind_the_page_also_where_a_folder_was_being_chosen() {
        CareBench bench;
        bench.open("a.jpg");
        bench.session->take()->start();
        bench.hear(1.0);
        bench.session->folders()->importFolder();
        bench.session->leave();
        QVERIFY(!bench.session->folders()->choosing());
        CARE_TRY_VERIFY(!bench.session->take()->running());
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
    }

    // --- listening and trimming ---

    void the_chosen_one_is_played_and_stopped() {
        TwoRecordings bench;
        bench.session->trimming()->playOrStop();
        QVERIFY(bench.session->trimming()->playing());
        QCOMPARE(bench.player.state(), Player::State::playing);
        bench.loudspeaker.play(1.0);
        QVERIFY(bench.session->trimming()->position() > 0.5);
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.session->trimming()->playing());
        QCOMPARE(bench.player.state(), Player::State::stopped);
        QVERIFY(!bench.session->stop());
    }

    void it_ends_by_itself() {
        TwoRecordings bench;
        bench.session->trimming()->playOrStop();
        bench.loudspeaker.play(4.0);
        QVERIFY(!bench.session->trimming()->playing());
    }

    void only_what_stays_is_listened_to() {
        TwoRecordings bench;
        bench.session->trimming()->setBegin(0.5);
        bench.session->trimming()->setEnd(1.5);
        bench.session->trimming()->playPartOrStop();
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.session->trimming()->position() >= 0.5);
        bench.loudspeaker.play(2.0);
        QVERIFY(!bench.session->trimming()->playing());
        double loud = 0.0;
        for (const float sample : bench.loudspeaker.heard)
            loud += std::abs(sample) > 0.001F ? 1.0 / sound_rate : 0.0;
        QVERIFY2(loud > 0.9 && loud < 1.2, qPrintable(QString::number(loud)));
    }

    void its_waveform_comes_and_the_ends_are_told_in_seconds() {
        TwoRecordings bench;
        Trimming& trimming = *bench.session->trimming();
        CARE_TRY_VERIFY(!trimming.peaks().isEmpty());
        QCOMPARE(trimming.peaks().size(), 400);
        QVERIFY(std::abs(trimming.peaks().at(200) - 0.25F) < 0.01F);
        QCOMPARE(trimming.duration(), 2.0);
        QVERIFY(!trimming.cuts());
        trimming.setBegin(0.3);
        QCOMPARE(bench.last_said(), QString("From 0.3 seconds"));
        trimming.setEnd(1.2);
        QCOMPARE(bench.last_said(), QString("To 1.2 seconds"));
        QCOMPARE(trimming.staysText(), QString("0.9 seconds of 2.0 seconds stay."));
        trimming.setBegin(5.0); // not beyond the end
        QVERIFY(std::abs(trimming.begin() - 1.1) < 1e-9);
        trimming.setEnd(-1.0);
        QVERIFY(std::abs(trimming.end() - 1.2) < 1e-9);
        trimming.setBegin(-1.0);
        QCOMPARE(trimming.begin(), 0.0);
        trimming.whole();
        QVERIFY(!trimming.cuts());
        trimming.cut();
        QVERIFY(bench.last_said().startsWith("All of it stays"));
    }

    void the_part_stays_and_undo_brings_the_whole_back() {
        TwoRecordings bench;
        Trimming& trimming = *bench.session->trimming();
        trimming.setBegin(0.5);
        trimming.setEnd(1.25);
        trimming.cut();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Trimmed: 0.8 seconds stay. Undo brings the rest back."));
        QCOMPARE(bench.list().chosen_tag()->duration_s, 0.75);
        QCOMPARE(trimming.duration(), 0.75);
        QVERIFY(!trimming.cuts());
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Undone: the memo was trimmed."));
        QCOMPARE(bench.list().chosen_tag()->duration_s, 2.0);
        QCOMPARE(trimming.duration(), 2.0);
    }

    void recording_silences_what_plays() {
        TwoRecordings bench;
        bench.session->trimming()->playOrStop();
        bench.session->take()->start();
        QVERIFY(!bench.session->trimming()->playing());
        bench.hear(0.5);
        QVERIFY(bench.session->stop());
        CARE_TRY_VERIFY(!bench.session->take()->running());
        QVERIFY(bench.rests());
    }
};

QTEST_MAIN(CareRecordingsTest)
#include "recordings_test.moc"
