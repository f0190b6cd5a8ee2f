// SPDX-License-Identifier: Apache-2.0
// What the session does with its parts; each of them has its own test.
#include "app/album/keeper/photo_files.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

namespace session_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

QStringList names(const PhotoRows& rows) {
    QStringList names;
    for (int i = 0; i < rows.rowCount(); ++i)
        names << rows.data(rows.index(i), PhotoRows::NameRole).toString();
    return names;
}

} // namespace

class CareSessionTest : public QObject {
    Q_OBJECT
private slots:
    void entering_tells_where_one_is_and_what_can_be_done() {
        CareBench empty({}, false);
        empty.session->enter();
        QCOMPARE(empty.last_said(), QString("Look after the album. It has no folder yet. Import photographs, "
                                            "and choose where to keep them."));
        CareBench two({"a.jpg", "b.jpg"});
        two.session->enter();
        QCOMPARE(two.last_said(),
                 QString("Look after the album. 2 photograph(s). Choose one, or import more."));
        two.open("a.jpg");
        two.session->enter();
        QVERIFY(two.last_said().contains("a.jpg is open"));
    }

    void what_is_done_to_a_photograph_is_in_its_row() {
        CareBench bench;
        PhotoRows& rows = *bench.session->photos();
        QCOMPARE(rows.data(rows.index(0), PhotoRows::DetailRole).toString(), QString("No description."));
        bench.open("a.jpg");
        bench.session->descriptions()->typeAltText("A garden");
        bench.session->descriptions()->save();
        QVERIFY(bench.rests());
        bench.session->recordings()->addFiles({url(a_sound(bench.folder, "x.wav", 0.5, 440.0))}, 0);
        QVERIFY(bench.rests());
        CARE_TRY_COMPARE(rows.data(rows.index(0), PhotoRows::DetailRole).toString(), QString("1 recording(s)."));
    }

    void mending_and_printing_are_asked_for_with_the_photograph() {
        CareBench bench;
        QSignalSpy mend(bench.session.get(), &CareSession::mendAsked), print(bench.session.get(), &CareSession::printAsked);
        bench.session->mend();
        bench.session->print();
        QVERIFY(mend.isEmpty() && print.isEmpty());
        bench.session->openRow(0);
        QVERIFY(bench.session->photoOpen());
        bench.session->mend();
        bench.session->print();
        QCOMPARE(mend.at(0).at(0).toString().toStdString(), bench.photo("a.jpg").string());
        QCOMPARE(print.at(0).at(0).toString().toStdString(), bench.photo("a.jpg").string());
        QVERIFY(bench.rests());
    }

    void a_photograph_is_deleted_and_comes_back_open() {
        CareBench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        bench.session->deletePhoto();
        QVERIFY(bench.rests());
        QVERIFY(!fs::exists(bench.photo("a.jpg")));
        QVERIFY(!bench.session->photoOpen());
        CARE_TRY_COMPARE(names(*bench.session->photos()), QStringList{"b.jpg"});
        CARE_TRY_COMPARE(bench.last_said(), QString("Deleted: a.jpg. Undo brings it back."));
        QCOMPARE(bench.session->history()->undoText(), QString("a.jpg was deleted"));
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QVERIFY(fs::exists(bench.photo("a.jpg")));
        QCOMPARE(bench.session->photoName(), QString("a.jpg"));
        CARE_TRY_COMPARE(bench.session->photos()->rowCount(), 2);
        bench.session->history()->redo();
        QVERIFY(bench.rests());
        QVERIFY(!bench.session->photoOpen());
        CARE_TRY_COMPARE(bench.session->photos()->rowCount(), 1);
    }

    void leaving_the_page_keeps_what_was_typed() {
        CareBench bench;
        bench.open("a.jpg");
        bench.session->descriptions()->typeDescription("More");
        bench.session->leave();
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().description.at("en"), std::string("More"));
    }

    /// What was read before stays: an empty form would be saved over what is there.
    void a_record_that_cannot_be_read_any_more_is_told_and_shown_as_it_was() {
        CareBench bench;
        bench.open("a.jpg");
        bench.session->descriptions()->typeDescription("By the lake");
        bench.session->descriptions()->save();
        QVERIFY(bench.rests());
        const fs::path photo = bench.photo("a.jpg"), kept = bench.folder / "kept.jpg";
        fs::rename(photo, kept);
        fs::create_directory(photo); // there, and no file
        bench.session->enter();
        QVERIFY(bench.rests());
        CARE_TRY_VERIFY(bench.last_said().contains("is not a file"));
        QCOMPARE(bench.session->descriptions()->description(), QString("By the lake"));
        fs::remove(photo);
        fs::rename(kept, photo);
        bench.session->enter();
        QVERIFY(bench.rests());
        CARE_TRY_VERIFY(bench.last_said().contains("a.jpg is open"));
        QCOMPARE(bench.session->descriptions()->description(), QString("By the lake"));
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
        QVERIFY(!fs::exists(bench.photo("a.jpg")));
        QVERIFY(!fs::exists(tags_folder(bench.photo("a.jpg"))));
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

    void what_plays_is_stopped_and_a_recording_silences_it() {
        CareBench bench;
        bench.add_sound("a.jpg", 2.0, 300.0);
        bench.open("a.jpg");
        bench.session->trimming()->playOrStop();
        QVERIFY(bench.session->trimming()->playing());
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.session->trimming()->playing());
        QVERIFY(!bench.session->stop());
        bench.session->trimming()->playOrStop();
        bench.session->take()->start();
        QVERIFY(!bench.session->trimming()->playing());
        bench.hear(0.5);
        QVERIFY(bench.session->stop());
        CARE_TRY_VERIFY(!bench.session->take()->running());
        QVERIFY(bench.rests());
    }
};

} // namespace session_test

TP_TEST(session_test, CareSessionTest, window)
#include "session_test.moc"
