// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/recording_list.hpp"
#include "care_bench.hpp"
#include "full_disk.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace recording_list_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

using Files = std::vector<std::string>;

struct Bench : TwoRecordings {
    Files order() const {
        std::vector<Tag> tags = record().tags;
        std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.order < b.order; });
        Files files;
        for (const Tag& tag : tags)
            files.push_back(tag.file);
        return files;
    }
    RecordingLabel label(const std::string& file) const {
        for (const Tag& tag : record().tags)
            if (tag.file == file)
                return tag.label;
        return {};
    }
    void undo() {
        history.undo();
        QVERIFY(rests());
    }
};

} // namespace

class RecordingListTest : public QObject {
    Q_OBJECT
private slots:
    void they_are_listed_as_they_are_played() {
        Bench bench;
        QCOMPARE(texts(bench.recordings), QStringList({"Memo", "Story"}));
        QCOMPARE(bench.recordings.chosen(), 0);
        QCOMPARE(bench.recordings.chosenText(), QString("Memo"));
        QVERIFY(bench.recordings.canMoveDown() && !bench.recordings.canMoveUp());
        bench.recordings.choose(1);
        QVERIFY(!bench.recordings.canMoveDown() && bench.recordings.canMoveUp());
        QVERIFY2(bench.last_said().startsWith("Story, 1 second"), qPrintable(bench.last_said()));
        QVERIFY(bench.last_said().endsWith(", 2 of 2"));
        const QVariantMap row = bench.recordings.rows().at(1).toMap();
        QVERIFY(row["chosen"].toBool() && !bench.recordings.rows().at(0).toMap()["chosen"].toBool());
        QVERIFY(row["detail"].toString().startsWith("1 second"));
        for (const int none : {-1, 2})
            bench.recordings.choose(none);
        QCOMPARE(bench.recordings.chosen(), 1);
    }
    void the_page_is_told_where_something_changed_and_only_then() {
        Bench bench;
        QSignalSpy changed(&bench.recordings, &RecordingList::changed),
            chosen(&bench.recordings, &RecordingList::chosenChanged);
        bench.cared.read_again();
        QVERIFY(bench.rests());
        bench.recordings.choose(0);
        QVERIFY(changed.isEmpty() && chosen.isEmpty());
        QVERIFY(bench.last_said().startsWith("Memo, 2 seconds")); // who asks gets an answer
        bench.recordings.choose(1);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(chosen.size(), 1);
        bench.recordings.setSpeaker("Tom");
        QVERIFY(bench.rests());
        QCOMPARE(changed.size(), 2);
        QCOMPARE(chosen.size(), 1); // it is the same one
        bench.recordings.remove();
        QVERIFY(bench.rests());
        QCOMPARE(changed.size(), 3);
        QCOMPARE(chosen.size(), 2);
        bench.cared.close();
        QCOMPARE(changed.size(), 4);
        QCOMPARE(chosen.size(), 3);
        bench.cared.close();
        QCOMPARE(changed.size(), 4);
        QCOMPARE(chosen.size(), 3);
    }
    void where_there_is_none_nothing_is_done() {
        CareParts bench;
        for (int opened = 0; opened < 2; ++opened) {
            bench.recordings.remove();
            bench.recordings.setKind(1);
            bench.recordings.setPerson("Anna");
            bench.recordings.setSpeaker("Tom");
            bench.recordings.setLanguage(1);
            QVERIFY(!bench.steps.busy() && bench.voice.said().isEmpty());
            QVERIFY(bench.recordings.rows().isEmpty() && bench.recordings.chosen_tag() == nullptr);
            QCOMPARE(bench.recordings.kind(), -1);
            QCOMPARE(bench.recordings.language(), -1);
            QCOMPARE(bench.recordings.person() + bench.recordings.speaker() + bench.recordings.chosenText(),
                     QString());
            QVERIFY(!bench.recordings.canMoveDown() && !bench.recordings.canMoveUp());
            bench.open();
        }
        bench.recordings.move(1);
        QCOMPARE(bench.last_said(), QString("This is the last one."));
        bench.cared.close();
        bench.recordings.addFiles({url(a_sound(bench.folder, "x.wav", 0.5, 440.0))}, 0);
        QVERIFY(!bench.steps.busy());
    }
    void the_chosen_one_is_moved_and_stays_chosen() {
        Bench bench;
        bench.recordings.choose(1);
        bench.recordings.move(-1);
        QVERIFY(bench.rests());
        QCOMPARE(texts(bench.recordings), QStringList({"Story", "Memo"}));
        QCOMPARE(bench.recordings.chosen(), 0);
        QCOMPARE(bench.order(), (Files{bench.story, bench.memo}));
        QCOMPARE(bench.last_said(), QString("Story is now number 1 of 2."));
        QVERIFY(bench.sounded(Earcon::saved));
        bench.recordings.move(-1);
        QVERIFY(!bench.steps.busy());
        QCOMPARE(bench.last_said(), QString("This is the first one."));
        QVERIFY(bench.sounded(Earcon::error));
        bench.undo();
        QCOMPARE(texts(bench.recordings), QStringList({"Memo", "Story"}));
        QCOMPARE(bench.recordings.chosenText(), QString("Story"));
        bench.recordings.move(1);
        QCOMPARE(bench.last_said(), QString("This is the last one."));
    }
    void each_press_moves_it_by_one_though_the_disk_is_slow() {
        Bench bench;
        const auto added =
            bench.album->keeper_for(bench.photo("a.jpg"))
                .add_recording(bench.photo("a.jpg"), a_sound(bench.folder, "x.wav", 0.5, 440.0),
                               {RecordingKind::ambient, {}, {}, {}, {}, {}});
        bench.cared.read_again();
        QVERIFY(bench.rests());
        bench.recordings.choose(2);
        {
            SlowDisk disk("a.jpg.xmp");
            bench.recordings.move(-1);
            CARE_TRY_VERIFY(disk.waits());
            bench.recordings.move(-1);
            bench.recordings.move(-1);
            QCOMPARE(bench.last_said(), QString("This is the first one."));
            bench.recordings.choose(0); // another, which the list shows there still
            bench.recordings.move(1);
            bench.recordings.choose(2); // the one before once more, which will be the first already
            bench.recordings.move(-1);
        }
        QVERIFY(bench.rests());
        QCOMPARE(bench.order(), (Files{added->tag.file, bench.story, bench.memo}));
        QCOMPARE(bench.recordings.chosen(), 0);
        QVERIFY(bench.voice.said().contains("Memo is now number 3 of 3."));
        QVERIFY2(bench.last_said().endsWith("is now number 1 of 3."), qPrintable(bench.last_said()));
        bench.recordings.move(1); // nothing is under way any more
        QVERIFY(bench.rests());
        QCOMPARE(bench.order(), (Files{bench.story, added->tag.file, bench.memo}));
        bench.recordings.choose(2);
        bench.recordings.move(1);
        QCOMPARE(bench.last_said(), QString("This is the last one."));
    }
    void one_is_deleted_and_brought_back() {
        Bench bench;
        bench.recordings.remove();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Deleted: Memo. Undo brings it back."));
        QVERIFY(bench.sounded(Earcon::deleted));
        QCOMPARE(texts(bench.recordings), QStringList{"Story"});
        QCOMPARE(bench.recordings.chosen(), 0); // the one that came to its place
        QVERIFY(!fs::exists(bench.file(bench.memo)));
        bench.undo();
        QCOMPARE(bench.last_said(), QString("Undone: the memo was deleted."));
        QVERIFY(fs::exists(bench.file(bench.memo)));
        QCOMPARE(texts(bench.recordings), QStringList({"Memo", "Story"}));
        QCOMPARE(bench.recordings.chosenText(), QString("Story")); // it stays
        bench.recordings.remove();
        QVERIFY(bench.rests());
        QCOMPARE(bench.recordings.chosenText(), QString("Memo")); // the last one now
        bench.recordings.remove();
        QVERIFY(bench.rests());
        QCOMPARE(bench.recordings.chosen(), -1);
        QSignalSpy chosen(&bench.recordings, &RecordingList::chosenChanged);
        bench.undo();
        QCOMPARE(bench.recordings.chosenText(), QString("Memo"));
        QCOMPARE(chosen.size(), 1);
    }

    void the_one_that_came_to_its_place_is_chosen_then() {
        Bench bench;
        bench.add_sound("a.jpg", 1.5, 700.0, RecordingKind::place);
        bench.cared.read_again();
        QVERIFY(bench.rests());
        QCOMPARE(texts(bench.recordings), QStringList({"Memo", "Place", "Story"}));
        bench.recordings.choose(1);
        bench.recordings.remove();
        QVERIFY(bench.rests());
        QCOMPARE(bench.recordings.chosenText(), QString("Story"));
    }
    void one_is_chosen_by_its_file_while_its_photograph_is_open() {
        Bench bench;
        bench.recordings.choose(1);
        bench.recordings.choose_file({bench.photo("b.jpg"), nullptr}, bench.memo);
        bench.recordings.choose_file(bench.cared.place(), "nowhere.flac");
        QCOMPARE(bench.recordings.chosen(), 1);
        bench.recordings.choose_file(bench.cared.place(), bench.memo);
        QCOMPARE(bench.recordings.chosen(), 0);
    }

    // --- the label ---

    void its_label_is_changed() {
        Bench bench;
        RecordingList& list = bench.recordings;
        list.setPerson(" Anna ");
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Saved: Memo, about Anna."));
        QVERIFY(bench.sounded(Earcon::saved));
        list.setSpeaker(" Tom ");
        QVERIFY(bench.rests());
        const auto german = static_cast<int>(list.languageNames().indexOf("Deutsch"));
        QVERIFY(german > 0);
        QCOMPARE(list.languageNames().at(0), QString("Not given"));
        list.setLanguage(german);
        QVERIFY(bench.rests());
        list.setKind(static_cast<int>(RecordingKind::place));
        QVERIFY(bench.rests());
        const RecordingLabel label = bench.label(bench.memo);
        QCOMPARE(label.person, std::string("Anna"));
        QCOMPARE(label.speaker, std::string("Tom"));
        QCOMPARE(label.language, std::string("de"));
        QVERIFY(label.kind == RecordingKind::place);
        QCOMPARE(list.person() + list.speaker(), QString("AnnaTom"));
        QCOMPARE(list.language(), german);
        QCOMPARE(list.kind(), static_cast<int>(RecordingKind::place));
        QCOMPARE(list.kinds().at(list.kind()), QString("Place"));
        bench.undo();
        QCOMPARE(list.kind(), static_cast<int>(RecordingKind::memo));
    }
    void the_same_label_again_or_none_that_there_is_is_no_step() {
        Bench bench;
        bench.recordings.setKind(static_cast<int>(RecordingKind::memo));
        bench.recordings.setPerson("");
        bench.recordings.setSpeaker(" ");
        bench.recordings.setLanguage(0);
        for (const int none : {-1, 99}) {
            bench.recordings.setKind(none);
            bench.recordings.setLanguage(none);
        }
        QVERIFY(!bench.steps.busy());
    }
    void labels_that_are_given_while_the_disk_is_slow_all_stay() {
        Bench bench;
        {
            SlowDisk disk("a.jpg.xmp");
            bench.recordings.setPerson("Anna");
            CARE_TRY_VERIFY(disk.waits());
            bench.recordings.setSpeaker("Tom");
            bench.recordings.setKind(static_cast<int>(RecordingKind::place));
            bench.recordings.setKind(static_cast<int>(RecordingKind::memo)); // after all
        }
        QVERIFY(bench.rests());
        const RecordingLabel label = bench.label(bench.memo);
        QCOMPARE(label.person, std::string("Anna"));
        QCOMPARE(label.speaker, std::string("Tom"));
        QVERIFY(label.kind == RecordingKind::memo);
        QCOMPARE(bench.last_said(), QString("Saved: Memo, about Anna."));
        bench.recordings.setSpeaker("Tom");
        QVERIFY(!bench.steps.busy());
    }
    void a_language_of_a_recording_can_be_given_to_others() {
        Bench bench;
        QCOMPARE(AlbumKeeper(bench.root())
                     .label_recording(bench.photo("a.jpg"), bench.story,
                                      {RecordingKind::story, {}, {}, "fi", {}, {}}),
                 std::string());
        QVERIFY(!bench.recordings.languageNames().contains("suomi"));
        bench.cared.read_again(); // another program's
        QVERIFY(bench.rests());
        QVERIFY(bench.recordings.languageNames().contains("suomi"));
    }

    // --- sound files ---

    void sound_files_are_taken_in_and_what_is_none_is_a_sentence() {
        CareParts bench;
        bench.open();
        const fs::path text = bench.folder.write("s/no.wav", "no sound");
        bench.recordings.addFiles({QUrl("https://example.org/x.wav"), url(text),
                                   url(a_sound(bench.folder, "s/x.wav", 0.5, 440.0)),
                                   url(a_sound(bench.folder, "s/y.wav", 1.0, 600.0))},
                                  static_cast<int>(RecordingKind::story));
        QCOMPARE(bench.last_said(), QString("Only a sound that is a file on this computer can be added."));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(bench.rests());
        QVERIFY(bench.voice.said().join('\n').contains("no.wav"));
        bench.sounded(Earcon::saved); // several at once
        QVERIFY2(bench.last_said().startsWith("Added: Story, 1 second"), qPrintable(bench.last_said()));
        QVERIFY(!bench.last_said().endsWith(' '));
        QCOMPARE(texts(bench.recordings), QStringList({"Story", "Story"}));
        QCOMPARE(bench.recordings.chosen(), 1); // the one that came last
        bench.recordings.addFiles({url(text)}, 0);
        QVERIFY(bench.rests());
        QVERIFY(bench.sounded(Earcon::error));
        bench.recordings.addFiles({url(a_sound(bench.folder, "s/z.wav", 1.0, 700.0))}, 99);
        QVERIFY(bench.rests());
        QVERIFY(bench.sounded(Earcon::saved));
        QCOMPARE(bench.recordings.chosenText(), bench.recordings.kinds().last());
    }
    void on_a_full_disk_each_step_says_so_and_nothing_is_changed() {
        Bench bench;
        const PhotoRecord before = bench.record();
        const fs::path sound = a_sound(bench.folder, "s/x.wav", 0.5, 440.0);
        const FullDisk disk("album/");
        const auto step = [&bench](const std::function<void()>& ask) {
            bench.voice.clear();
            bench.sounded(Earcon::error);
            ask();
            QVERIFY(bench.rests());
            QCOMPARE(bench.voice.said().size(), 1);
            QVERIFY2(bench.last_said().contains("the disk is full."), qPrintable(bench.last_said()));
            QVERIFY(bench.sounded(Earcon::error));
        };
        step([&] { bench.recordings.move(1); });
        step([&] { bench.recordings.remove(); });
        step([&] { bench.recordings.setPerson("Anna"); });
        step([&] { bench.recordings.addFiles({url(sound)}, 0); });
        QVERIFY(bench.record() == before);
        QCOMPARE(texts(bench.recordings), QStringList({"Memo", "Story"}));
        QCOMPARE(bench.recordings.person(), QString());
    }
    void with_a_photograph_that_another_program_deleted_steps_are_refused() {
        Bench bench;
        fs::remove(bench.photo("a.jpg"));
        bench.recordings.setPerson("Anna");
        QVERIFY(bench.rests());
        QVERIFY2(!bench.last_said().startsWith("Saved"), qPrintable(bench.last_said()));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(bench.recordings.rows().isEmpty());
    }
    void what_is_done_late_is_told_of_the_photograph_that_it_was_done_to() {
        Bench bench;
        a_photo(bench.folder, "album/b.jpg", 9);
        bench.add_sound("b.jpg", 1.5, 700.0, RecordingKind::place);
        const fs::path sound = a_sound(bench.folder, "s/x.wav", 0.5, 440.0);
        QSignalSpy chosen(&bench.recordings, &RecordingList::chosenChanged);
        {
            SlowDisk disk("a.jpg");
            bench.recordings.move(1);
            CARE_TRY_VERIFY(disk.waits());
            bench.recordings.addFiles({url(sound)}, 0);
            bench.cared.open({bench.photo("b.jpg"), &bench.album->keeper_for(bench.photo("b.jpg"))});
        }
        QVERIFY(bench.rests());
        const QString said = bench.voice.said().join('\n');
        QVERIFY2(said.contains("Memo is now number 2 of 2."), qPrintable(said));
        QVERIFY2(said.contains("Added: Memo"), qPrintable(said));
        QCOMPARE(bench.recordings.chosenText(), QString("Place"));
        QCOMPARE(chosen.size(), 2); // none, then that of the other
    }
};

} // namespace recording_list_test

TP_TEST(recording_list_test, RecordingListTest, window)
#include "recording_list_test.moc"
