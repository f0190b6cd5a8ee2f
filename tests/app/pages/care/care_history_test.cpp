// SPDX-License-Identifier: Apache-2.0
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

namespace care_history_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench : CareParts {
    using CareParts::CareParts;

    /// The open photograph; closed first, as the page does it.
    void remove() {
        const PhotoPlace place = cared.place();
        cared.close();
        history.delete_photo(place);
        QVERIFY(rests());
    }
    void describe(const std::string& text) {
        cared.change(
            cared.place(),
            [text](AlbumKeeper& keeper, const fs::path& photo) {
                return keeper.describe(photo, "en", text, "");
            },
            [](const QString& problem) { QCOMPARE(problem, QString()); });
        QVERIFY(rests());
    }
    void undo() {
        history.undo();
        QVERIFY(rests());
    }
    void redo() {
        history.redo();
        QVERIFY(rests());
    }
    std::string shown() const { return cared.place().photo.filename().string(); }
    std::string described() const {
        const LanguageTexts& texts = cared.record().alt_text;
        return texts.contains("en") ? texts.at("en") : std::string();
    }
};

} // namespace

class CareHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void with_nothing_to_take_back_it_is_told() {
        Bench bench;
        bench.undo();
        QCOMPARE(bench.last_said(), QString("There is nothing to undo."));
        bench.redo();
        QCOMPARE(bench.last_said(), QString("There is nothing to redo."));
        bench.open();
        bench.undo();
        QCOMPARE(bench.last_said(), QString("There is nothing to undo."));
        QVERIFY(bench.history.undoText().isEmpty() && bench.history.redoText().isEmpty());
    }
    void a_step_is_taken_back_and_done_again_and_what_is_shown_follows() {
        Bench bench;
        bench.open();
        QSignalSpy changed(&bench.history, &CareHistory::changed);
        bench.describe("A garden");
        QCOMPARE(bench.history.undoText(), QString("a.jpg was described"));
        QVERIFY(!changed.isEmpty());
        bench.undo();
        QCOMPARE(bench.last_said(), QString("Undone: a.jpg was described."));
        QVERIFY(bench.sounded(Earcon::undone));
        QCOMPARE(bench.described(), std::string());
        QCOMPARE(bench.history.redoText(), QString("a.jpg was described"));
        bench.redo();
        QCOMPARE(bench.last_said(), QString("Redone: a.jpg was described."));
        QCOMPARE(bench.described(), std::string("A garden"));
        QCOMPARE(bench.shown(), std::string("a.jpg"));
    }
    void a_photograph_that_comes_back_is_opened_and_one_that_goes_is_closed() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        bench.remove();
        for (int i = 0; i < 2; ++i) {
            bench.undo();
            QCOMPARE(bench.shown(), std::string("a.jpg"));
            bench.redo();
            QVERIFY(!bench.cared.is_open());
            QVERIFY(!fs::exists(bench.photo("a.jpg")));
        }
        bench.open("b.jpg");
        bench.undo();
        QCOMPARE(bench.shown(), std::string("a.jpg"));
    }
    void a_photograph_that_cannot_be_deleted_is_opened_again() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        fs::remove(bench.photo("a.jpg")); // by somebody else
        bench.remove();
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY2(!bench.last_said().startsWith("Deleted"), qPrintable(bench.last_said()));
        QCOMPARE(bench.shown(), std::string("a.jpg"));
        bench.undo();
        QCOMPARE(bench.last_said(), QString("There is nothing to undo."));
    }
    void a_photograph_that_stays_away_is_not_opened() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.open("b.jpg");
        bench.remove();
        bench.open("a.jpg");
        bench.describe("A garden");
        bench.undo();
        QCOMPARE(bench.shown(), std::string("a.jpg"));
    }
    void what_cannot_be_taken_back_says_why() {
        Bench bench;
        bench.open();
        bench.remove();
        QVERIFY(bench.sounded(Earcon::deleted));
        a_photo(bench.folder, "album/a.jpg", 9); // another photograph in its place
        bench.undo();
        QVERIFY(!bench.last_said().startsWith("Undone"));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(!bench.cared.is_open());
    }
    void nothing_is_taken_back_under_a_recording() {
        Bench bench;
        bench.open();
        bench.describe("A garden");
        bench.take.start();
        bench.hear(1.0);
        bench.undo();
        QCOMPARE(bench.last_said(), QString("A recording is being made. Finish it first."));
        bench.redo();
        QCOMPARE(bench.described(), std::string("A garden"));
        QVERIFY(bench.take.running());
        bench.recording.stop();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.rests());
    }
};

} // namespace care_history_test

TP_TEST(care_history_test, CareHistoryTest, window)
#include "care_history_test.moc"
