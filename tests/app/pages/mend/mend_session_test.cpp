// SPDX-License-Identifier: Apache-2.0
#include "core/files/durable_file.hpp"
#include "mend_bench.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTest>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace mend_session_test {

using namespace tp;
using State = MendedPhoto::State;

namespace {

/// A session with a sample portrait in its folder and nothing in hand.
struct PortraitBench : MendGround {
    MendSession session{narrator};
    const QString photo = folder.filePath("anna.jpg");

    PortraitBench() {
        QVERIFY(QFile::copy(tp::test::in_source("resources/samples/anna_smiling.jpg"), photo));
    }
    State state() { return session.photo()->state(); }
};

} // namespace

class MendSessionTest : public QObject {
    Q_OBJECT
private slots:
    void where_one_is_is_told() {
        MendGround ground;
        MendSession session(ground.narrator);
        session.enter();
        QVERIFY(ground.said().contains("no photograph yet"));
        session.show(drawn_mend_photo(ground.folder.path()));
        QCOMPARE(ground.said(), QString("Contours of drawn.png. Selected: left eye. Tab goes from point to "
                                        "point, the arrow keys move it."));
        MendBench nobody(0);
        nobody.selection().whereAmI();
        QCOMPARE(nobody.said(), QString("No face was found in drawn.png. You can add one of the usual shape "
                                        "and move it into place."));
    }

    void every_step_of_every_part_is_undone_to_the_last_byte_and_done_again() {
        MendBench bench;
        MendSelection& selection = bench.selection();
        MendEditing& editing = bench.editing();
        MendHistory& history = *bench.session.history();
        MendDrag& drag = *bench.session.drag();
        const std::vector<std::function<void()>> steps{
            [&] { selection.chooseHandle(0), editing.nudge(1, 0), editing.nudge(0.2, 7); },
            [&] { selection.chooseHandle(3), editing.nudge(-2.5, 0.1); },
            [&] { editing.addPoint(); },
            [&] { editing.addPointAt(300, 200); },
            [&] { selection.chooseHandle(2), editing.deletePoint(); },
            [&] { selection.chooseHandle(0), editing.turnCorner(); },
            [&] { selection.setWholeFeature(true), editing.nudge(4, 4), selection.setWholeFeature(false); },
            [&] {
                const QPointF at = bench.window(1);
                drag.grab(at.x(), at.y(), 10), drag.dragTo(at.x() + 9, at.y() + 1), drag.drop();
            },
            [&] { selection.chooseFeature(mouth_opening), editing.addFeature(); },
            [&] { selection.chooseFeature(nose), editing.addFeature(); },
            [&] { selection.chooseFeature(right_eye), editing.removeFeature(); },
            [&] { selection.chooseFeature(left_eye), editing.resetFeature(); },
            [&] { editing.addFace(); },
            [&] { bench.session.file()->discard(); },
        };
        std::vector<std::string> texts{bench.text()};
        for (const auto& step : steps) {
            step();
            QVERIFY2(bench.text() != texts.back(), qPrintable(bench.said()));
            texts.push_back(bench.text());
        }
        for (std::size_t i = texts.size() - 1; i > 0; --i) {
            QCOMPARE(bench.text(), texts[i]);
            history.undo();
        }
        QCOMPARE(bench.text(), texts[0]);
        QVERIFY(!history.canUndo());
        for (std::size_t i = 1; i < texts.size(); ++i) {
            history.redo();
            QCOMPARE(bench.text(), texts[i]);
        }
        QVERIFY(!history.canRedo());
    }

    void leaving_puts_back_what_is_dragged_and_saves_the_rest() {
        MendBench bench;
        bench.editing().nudgeHandle(0, 1, 0);
        const std::string text = bench.text();
        const QPointF at = bench.window(1);
        MendDrag& drag = *bench.session.drag();
        drag.grab(at.x(), at.y(), 10), drag.dragTo(at.x() + 9, at.y() + 1);
        bench.session.leave();
        QCOMPARE(bench.bytes(), text);
        QCOMPARE(bench.said(), QString("The contours are saved."));
    }
    void no_other_photograph_is_opened_while_this_one_cannot_be_saved() {
        MendBench bench;
        bench.editing().nudgeHandle(0, 1, 0);
        const std::string text = bench.text();
        MendPhoto other = drawn_mend_photo(bench.folder.path(), 2);
        std::filesystem::create_directories(bench.file() / "in the way");
        bench.session.open_file("/nowhere/other.jpg"); // would lose it
        QCOMPARE(bench.session.photo()->state(), State::Ready);
        bench.session.show(std::move(other));
        QCOMPARE(bench.text(), text);
        std::filesystem::remove_all(bench.file());
    }

    void a_portrait_is_read_and_mended() {
        PortraitBench bench;
        bench.session.open_file(bench.photo);
        QCOMPARE(bench.state(), State::Looking);
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), State::Ready, 60000);
        QCOMPARE(bench.session.photo()->picture().size(), QSize(900, 1100));
        MendSelection& selection = *bench.session.selection();
        QVERIFY(selection.featureThere());
        selection.setWholeFeature(true);
        bench.session.editing()->nudge(0, 4);
        QVERIFY(bench.session.file()->save());
        bench.session.open_file(bench.photo);
        QTRY_VERIFY_WITH_TIMEOUT(bench.state() == State::Ready && selection.featureMended(), 60000);
    }
    void who_leaves_while_a_photograph_is_read_finds_what_was_there() {
        PortraitBench bench;
        bench.session.open_file(bench.photo);
        bench.session.leave();
        QCOMPARE(bench.state(), State::Empty);
    }
    void a_photograph_that_is_none_is_said() {
        MendGround ground;
        MendSession session(ground.narrator);
        session.open(QUrl("https://example.org/a.jpg"));
        QVERIFY(ground.said().startsWith("Only a photograph that is a file"));
        session.open_file("/nowhere/at all.jpg");
        QTRY_COMPARE_WITH_TIMEOUT(session.photo()->state(), State::Problem, 60000);
        QVERIFY(ground.said().contains("at all.jpg"));
        session.editing()->addFace();
        session.editing()->nudge(1, 1);
        QVERIFY(session.file()->save());
    }
    void mended_contours_that_cannot_be_read_are_not_written_over() {
        PortraitBench bench;
        const auto contours = correction_file(bench.photo.toStdString());
        QVERIFY(replace_file(contours, "not a drawing").empty());
        bench.session.open_file(bench.photo);
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), State::Problem, 60000);
        bench.session.leave();
        QCOMPARE(*read_whole(contours, 1 << 20), std::string("not a drawing"));
    }
};

} // namespace mend_session_test

TP_TEST(mend_session_test, MendSessionTest, window)
#include "mend_session_test.moc"
