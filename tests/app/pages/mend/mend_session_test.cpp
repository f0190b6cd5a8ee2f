// SPDX-License-Identifier: Apache-2.0
#include "mend_bench.hpp"

#include "core/files/durable_file.hpp"
#include "core/svg/contour_sheet.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include <filesystem>
#include <functional>
#include <vector>

using namespace tp;

namespace {

constexpr int left_eye = 0, right_eye = 1, lips = 2, mouth_opening = 3, outline = 4, nose = 5;

/// Whether this run is root's, whom no permission stops.
bool nothing_is_forbidden(const QString& folder) {
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::ExeOwner);
    QFile probe(folder + "/probe");
    const bool writes = probe.open(QIODevice::WriteOnly);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    probe.remove();
    return writes;
}

} // namespace

class MendSessionTest : public QObject {
    Q_OBJECT
private slots:
    void where_one_is_is_told() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        MendSession session(narrator);
        session.enter();
        QVERIFY(voice.said().back().contains("no photograph yet"));
        QTemporaryDir folder;
        session.show(drawn_mend_photo(folder.path()));
        QCOMPARE(voice.said().back(),
                 QString("Contours of drawn.png. In hand: left eye. Tab goes from point to point, the arrow keys move it."));
        QCOMPARE(session.features(),
                 QStringList({"left eye", "right eye", "lips", "mouth opening", "face outline", "nose"}));
        QVERIFY(session.featureThere());
        QVERIFY(!session.unsaved());
        QCOMPARE(session.handle(), -1);
    }
    void several_faces_are_told_apart() {
        MendBench bench(2);
        QCOMPARE(bench.session.features().size(), 12);
        QCOMPARE(bench.session.features()[6], QString("left eye of face 2"));
        bench.session.chooseFeature(6);
        QVERIFY(bench.said().startsWith("left eye of face 2, "));
    }

    void tab_goes_from_point_to_point_and_out() {
        MendBench bench;
        const int count = bench.session.handles()->rowCount();
        for (int i = 0; i < count; ++i)
            QVERIFY(bench.session.stepHandle(1));
        QVERIFY(bench.said().contains(QString("%1 of %1").arg(count)));
        QVERIFY(!bench.session.stepHandle(1));
        QVERIFY(bench.session.stepHandle(-1));
        QCOMPARE(bench.session.handle(), count - 1);
    }
    void a_nudge_moves_the_point_and_tells_its_place() {
        MendBench bench;
        bench.session.nudge(1, 0);
        QVERIFY(bench.said().startsWith("No point is in hand"));
        QVERIFY(!bench.session.unsaved());
        bench.session.chooseHandle(0);
        QCOMPARE(bench.said(), "Corner 1 of " + QString::number(bench.session.handles()->rowCount()) + ": 212 across, 120 down.");
        bench.session.nudge(10, 0);
        bench.session.nudge(0.2, -1);
        QCOMPARE(bench.said(), QString("222.2 across, 119 down."));
        QVERIFY(length(bench.node(0).at - Vec2(222.2, 119)) < 1e-9);
        QVERIFY(bench.session.unsaved());
        QVERIFY(bench.session.featureMended());
        const QPointF shown = bench.session.handles()->rows()[0].place;
        QCOMPARE(shown, QPointF(bench.node(0).at.x, bench.node(0).at.y));
    }
    void a_drag_moves_the_point_by_as_much_as_the_hand() {
        MendBench bench;
        const QPointF from = bench.window(2) + QPointF(5, 3);
        const Vec2 before = bench.node(2).at;
        QVERIFY(bench.session.grab(from.x(), from.y(), 30.0));
        QCOMPARE(bench.session.handle(), 2);
        for (int i = 1; i <= 10; ++i)
            bench.session.dragTo(from.x() + 4.0 * i, from.y() - 2.0 * i);
        bench.session.drop();
        const Vec2 by = Vec2(40, -20) / bench.session.viewScale();
        QVERIFY(length(bench.node(2).at - before - by) < 1e-9);
        const std::string moved = bench.text();
        bench.session.undo(); // all of the drag
        QVERIFY(bench.node(2).at == before);
        bench.session.redo();
        QCOMPARE(bench.text(), moved);
    }
    void the_nearest_point_is_taken() {
        MendBench bench;
        for (int i = 0; i < bench.session.handles()->rowCount(); ++i) {
            const QPointF at = bench.window(i);
            QVERIFY(bench.session.grab(at.x() + 0.5, at.y(), 40.0));
            QCOMPARE(bench.session.handle(), i);
            bench.session.drop();
        }
        QVERIFY(!bench.session.canUndo()); // nothing was moved
        QVERIFY(!bench.session.grab(-500.0, -500.0, 40.0));
    }
    void a_drag_that_is_cancelled_never_was() {
        MendBench bench;
        const std::string before = bench.text();
        const QPointF at = bench.window(1);
        QVERIFY(bench.session.grab(at.x(), at.y(), 20.0));
        bench.session.dragTo(at.x() + 50, at.y());
        QVERIFY(bench.text() != before);
        QVERIFY(bench.session.cancelDrag());
        QCOMPARE(bench.text(), before);
        QVERIFY(!bench.session.canUndo());
        QVERIFY(!bench.session.canRedo());
        QVERIFY(!bench.session.cancelDrag());
    }
    void a_handle_can_be_placed_to_a_fifth_of_a_pixel() {
        MendBench bench;
        bench.session.chooseHandle(0);
        while (bench.session.viewScale() < 39.0)
            bench.session.zoomBy(2.0);
        const Vec2 wanted = bench.node(0).at + Vec2(1.3, -0.7);
        const QPointF from = bench.window(0);
        const QPointF to = bench.session.view().to_window(wanted);
        QVERIFY(bench.session.grab(from.x(), from.y(), 20.0));
        bench.session.dragTo(std::round(to.x()), std::round(to.y())); // whole pixels of the screen
        bench.session.drop();
        QVERIFY(length(bench.node(0).at - wanted) < 0.2);
    }
    void the_whole_feature_moves_by_keys_and_by_hand() {
        MendBench bench;
        bench.session.setWholeFeature(true);
        const MendContour before = *bench.session.line();
        bench.session.nudge(3, 4);
        for (std::size_t i = 0; i < before.nodes.size(); ++i)
            QVERIFY(bench.session.line()->nodes[i].at == before.nodes[i].at + Vec2(3, 4));
        const QPointF at = bench.window(0);
        QVERIFY(bench.session.grab(at.x(), at.y(), 20.0));
        bench.session.dragTo(at.x() + bench.session.viewScale() * 10, at.y());
        bench.session.drop();
        for (std::size_t i = 0; i < before.nodes.size(); ++i)
            QVERIFY(length(bench.session.line()->nodes[i].at - before.nodes[i].at - Vec2(13, 4)) < 1e-9);
    }
    void a_tap_takes_another_feature() {
        MendBench bench;
        bench.session.showAll();
        const Vec2 on_the_outline = bench.session.work().faces[0].features[outline].line->nodes[0].at;
        const QPointF at = bench.session.view().to_window(on_the_outline);
        bench.session.tap(at.x(), at.y(), 10.0);
        QCOMPARE(bench.session.feature(), outline);
        QVERIFY(bench.said().startsWith("face outline, "));
    }
    void points_are_added_deleted_and_turned() {
        MendBench bench;
        const int count = bench.session.handles()->rowCount();
        bench.session.deletePoint();
        QVERIFY(bench.said().startsWith("No point is in hand"));
        bench.session.chooseHandle(0);
        bench.session.addPoint();
        QVERIFY(bench.said().startsWith("Added. Point "));
        QCOMPARE(bench.session.handles()->rowCount(), count + 2); // the point and a control more
        bench.session.deletePoint();
        QCOMPARE(bench.session.handles()->rowCount(), count);
        bench.session.chooseHandle(0);
        QVERIFY(bench.session.handleIsCorner() && bench.session.handleTurns());
        bench.session.turnCorner();
        QCOMPARE(bench.said(), QString("Smooth now."));
        QVERIFY(!bench.session.handleIsCorner());
        const QPointF beside = bench.window(4);
        bench.session.addPointAt(beside.x(), beside.y());
        QCOMPARE(bench.session.handles()->rowCount(), count + 2);
    }
    void a_feature_is_removed_and_added_as_it_was_found() {
        MendBench bench;
        const std::string before = bench.text();
        bench.session.removeFeature();
        QVERIFY(!bench.session.featureThere());
        QVERIFY(bench.text() != before);
        QVERIFY(bench.session.unsaved());
        bench.session.addFeature();
        QVERIFY(bench.session.featureThere());
        QCOMPARE(bench.text(), before);
        QVERIFY(!bench.session.unsaved());
    }
    void a_feature_that_was_not_found_is_added_in_its_usual_shape() {
        MendBench bench;
        bench.session.chooseFeature(mouth_opening);
        QCOMPARE(bench.said(), QString("mouth opening: not there. It can be added."));
        bench.session.addFeature();
        QVERIFY(bench.session.featureThere());
        const Rect box = bounds_of(*bench.session.line());
        QVERIFY(bounds_of(*bench.session.work().faces[0].features[lips].line).contains(box.centre())); // where the mouth is
        bench.session.resetFeature();
        QVERIFY(!bench.session.featureThere());
        bench.session.chooseFeature(nose);
        bench.session.addFeature(); // one of the extras: as it was found
        QVERIFY(bench.said().contains("as the program found it"));
        QVERIFY(bench.session.featureMended());
    }
    void an_eye_that_is_missing_is_the_other_one_in_a_mirror() {
        MendBench bench;
        bench.session.removeFeature();
        MendFace face = bench.session.work().faces[0];
        const MendContour eye = template_for(face, feature::left_eye);
        const Rect box = bounds_of(eye);
        QVERIFY(std::abs(box.centre().x - 230.0) < 2.0 && std::abs(box.centre().y - 120.0) < 2.0);
        face.features[right_eye].line.reset();
        const Rect usual = bounds_of(template_for(face, feature::left_eye));
        QVERIFY(std::abs(usual.centre().x - 230.0) < 15.0 && std::abs(usual.centre().y - 120.0) < 15.0);
    }
    void one_feature_is_reset_and_the_others_stay() {
        MendBench bench;
        const MendContour found = *bench.session.line();
        bench.session.chooseHandle(0);
        bench.session.nudge(5, 5);
        bench.session.chooseFeature(right_eye);
        bench.session.chooseHandle(0);
        bench.session.nudge(-3, 0);
        const MendContour other = *bench.session.line();
        bench.session.chooseFeature(left_eye);
        bench.session.resetFeature();
        QVERIFY(*bench.session.line() == found);
        QVERIFY(*bench.session.work().faces[0].features[right_eye].line == other);
        bench.session.resetFeature();
        QCOMPARE(bench.said(), QString("The left eye is as the program found it."));
    }
    void a_face_of_usual_shape_is_added_where_none_was_found() {
        MendBench bench(0);
        QVERIFY(bench.session.features().isEmpty());
        QVERIFY(!bench.session.stepHandle(1));
        bench.session.addFace();
        QCOMPARE(bench.session.features().size(), 5);
        QVERIFY(bench.session.featureThere());
        QVERIFY(bench.session.save());
        const Extraction found = drawn_extraction(0);
        const Extraction again = with_corrections(found, bench.folder.filePath("drawn.png").toStdString());
        QCOMPARE(again.faces.size(), 1u);
        QCOMPARE(again.faces[0].contours.size(), 5u);
        bench.session.undo();
        QVERIFY(bench.session.features().isEmpty());
    }

    void every_step_is_undone_to_the_last_byte_and_done_again() {
        MendBench bench;
        MendSession& session = bench.session;
        const std::vector<std::function<void()>> steps{
            [&] { session.chooseHandle(0), session.nudge(1, 0), session.nudge(0.2, 7); },
            [&] { session.chooseHandle(3), session.nudge(-2.5, 0.1); },
            [&] { session.addPoint(); },
            [&] { session.addPointAt(300, 200); },
            [&] { session.chooseHandle(2), session.deletePoint(); },
            [&] { session.chooseHandle(0), session.turnCorner(); },
            [&] { session.setWholeFeature(true), session.nudge(4, 4), session.setWholeFeature(false); },
            [&] {
                const QPointF at = bench.window(1);
                session.grab(at.x(), at.y(), 10), session.dragTo(at.x() + 9, at.y() + 1), session.drop();
            },
            [&] { session.chooseFeature(mouth_opening), session.addFeature(); },
            [&] { session.chooseFeature(nose), session.addFeature(); },
            [&] { session.chooseFeature(right_eye), session.removeFeature(); },
            [&] { session.chooseFeature(left_eye), session.resetFeature(); },
            [&] { session.addFace(); },
            [&] { session.discard(); },
        };
        std::vector<std::string> texts{bench.text()};
        for (const auto& step : steps) {
            step();
            QVERIFY2(bench.text() != texts.back(), qPrintable(bench.said()));
            texts.push_back(bench.text());
        }
        QVERIFY(session.canUndo() && !session.canRedo());
        for (std::size_t i = texts.size() - 1; i > 0; --i) {
            QCOMPARE(bench.text(), texts[i]);
            session.undo();
            QVERIFY(bench.said().startsWith("Undone: "));
        }
        QCOMPARE(bench.text(), texts[0]);
        QVERIFY(!session.canUndo());
        session.undo();
        QCOMPARE(bench.said(), QString("There is nothing to undo."));
        for (std::size_t i = 1; i < texts.size(); ++i) {
            session.redo();
            QVERIFY(bench.said().startsWith("Done again: "));
            QCOMPARE(bench.text(), texts[i]);
        }
        session.redo();
        QCOMPARE(bench.said(), QString("There is nothing to do again."));
    }

    void what_is_saved_is_what_is_read_again() {
        MendBench bench(2);
        MendSession& session = bench.session;
        session.chooseHandle(0), session.nudge(2.25, -1);
        session.chooseFeature(right_eye), session.removeFeature();
        session.chooseFeature(6 + mouth_opening), session.addFeature();
        const std::string text = bench.text();
        QSignalSpy saved(&session, &MendSession::saved);
        QVERIFY(session.save());
        QCOMPARE(saved.size(), 1);
        QCOMPARE(bench.bytes(), text);
        QVERIFY(!session.unsaved());
        const MendPhoto again = drawn_mend_photo(bench.folder.path(), 2);
        QCOMPARE(sheet_to_svg(sheet_of(again.work)), text);
        QVERIFY(!again.work.faces[0].features[right_eye].line);
        QVERIFY(*again.work.faces[0].features[left_eye].line == *session.work().faces[0].features[left_eye].line);
        QVERIFY(again.work.faces[1].features[mouth_opening].line);
    }
    void only_what_was_mended_is_saved() {
        MendBench bench;
        bench.session.chooseHandle(0);
        bench.session.nudge(1, 1);
        QVERIFY(bench.session.save());
        const auto sheet = read_sheet(bench.file(), ContourSheet::Unit::pixel);
        QVERIFY(sheet);
        QCOMPARE(sheet->contours.size(), 1u);
        QCOMPARE(sheet->contours[0].name, std::string("left_eye"));
    }
    void without_a_mended_contour_there_is_no_file() {
        MendBench bench;
        QVERIFY(bench.session.save());
        QVERIFY(!std::filesystem::exists(bench.file()));
        bench.session.chooseHandle(0);
        bench.session.nudge(1, 1);
        QVERIFY(bench.session.save());
        QVERIFY(std::filesystem::exists(bench.file()));
        bench.session.undo();
        QVERIFY(bench.session.unsaved());
        QVERIFY(bench.session.save());
        QVERIFY(!std::filesystem::exists(bench.file()));
    }
    void discarded_changes_leave_the_very_bytes_of_another_program() {
        QTemporaryDir folder;
        const std::string foreign = "<svg xmlns='http://www.w3.org/2000/svg' width='400px' height='300px' viewBox='0 0 400 300'>"
                                    "<text>of Anna</text><path id='left_eye' d='M 210 120 L 250 120 L 230 130 Z'/></svg>\n";
        const auto file = correction_file(folder.filePath("drawn.png").toStdString());
        QVERIFY(replace_file(file, foreign).empty());
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        MendSession session(narrator);
        session.show(drawn_mend_photo(folder.path()));
        QVERIFY(session.featureMended());
        session.chooseHandle(0), session.nudge(3, 0);
        QVERIFY(session.save());
        QVERIFY(*read_whole(file, 1 << 20) != foreign);
        session.discard();
        QVERIFY(session.save());
        QCOMPARE(*read_whole(file, 1 << 20), foreign);
    }
    void leaving_saves() {
        MendBench bench;
        bench.session.chooseHandle(0), bench.session.nudge(1, 0);
        bench.session.leave();
        QCOMPARE(bench.bytes(), bench.text());
        QCOMPARE(bench.said(), QString("The contours are saved."));
    }
    void so_does_the_end_of_the_program() {
        QTemporaryDir folder;
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        {
            MendSession session(narrator);
            session.show(drawn_mend_photo(folder.path()));
            session.chooseHandle(0), session.nudge(1, 0);
        }
        QVERIFY(std::filesystem::exists(correction_file(folder.filePath("drawn.png").toStdString())));
    }
    void a_refused_write_says_so_and_keeps_everything() {
        MendBench bench;
        bench.session.chooseHandle(0), bench.session.nudge(1, 0);
        const std::string text = bench.text();
        std::filesystem::create_directories(bench.file() / "in the way");
        QVERIFY(!bench.session.save());
        QVERIFY(bench.said().endsWith("Your work is kept here; nothing is lost."));
        bench.session.leave();
        QVERIFY(bench.session.unsaved());
        bench.session.open_file("/nowhere/other.jpg"); // would lose it
        QCOMPARE(bench.session.state(), MendSession::State::Ready);
        QCOMPARE(bench.text(), text);
        QVERIFY(bench.session.canUndo());
        std::filesystem::remove_all(bench.file());
        QVERIFY(bench.session.save());
        QCOMPARE(bench.bytes(), text);
    }
    void a_folder_that_may_not_be_written_to() {
        MendBench bench;
        if (nothing_is_forbidden(bench.folder.path()))
            QSKIP("Nothing is forbidden to this user.");
        bench.session.chooseHandle(0), bench.session.nudge(1, 0);
        QFile::setPermissions(bench.folder.path(), QFile::ReadOwner | QFile::ExeOwner);
        QVERIFY(!bench.session.save());
        QFile::setPermissions(bench.folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        QVERIFY(bench.session.save());
    }
    void what_another_program_wrote_meanwhile_is_kept_beside_it() {
        MendBench bench;
        bench.session.chooseHandle(0), bench.session.nudge(1, 0);
        QVERIFY(bench.session.save());
        QVERIFY(replace_file(bench.file(), "<svg>of another</svg>").empty());
        bench.session.nudge(1, 0);
        QVERIFY(bench.session.save());
        QCOMPARE(bench.bytes(), bench.text());
        QVERIFY(bench.said().contains("drawn.png.contours-1.svg"));
        QCOMPARE(*read_whole(bench.folder.filePath("drawn.png.contours-1.svg").toStdString(), 1 << 20),
                 std::string("<svg>of another</svg>"));
    }

    void how_much_is_felt_is_told() {
        MendBench bench;
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.change(), QString("It feels as the program found it."), 60000);
        QVERIFY(!bench.session.felt().field.isNull());
        bench.session.setWholeFeature(true);
        bench.session.nudge(0, -8);
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.change().startsWith("A finger notices the difference"), 60000);
        QVERIFY(bench.session.felt().difference->max_n > 0.1);
        // The field lies where the photograph is: the surface round the face.
        QVERIFY(bench.session.felt().place.contains(QPointF(200, 150)));
        bench.session.undo();
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.change(), QString("It feels as the program found it."), 60000);
    }
    void the_newest_contours_are_felt() {
        MendBench bench;
        bench.session.chooseHandle(0);
        for (int i = 0; i < 50; ++i)
            bench.session.nudge(0.5, 0);
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.felt_is_current(), 60000);
        const FeltChange now = felt_change(found_faces(bench.session.work()), faces_of(bench.session.work()));
        QCOMPARE(bench.session.felt().difference->mean_n, now.difference->mean_n);
        QCOMPARE(bench.session.felt().field, now.field);
    }

    void a_portrait_is_read_and_mended() {
        QTemporaryDir folder;
        const QString file = folder.filePath("anna.jpg");
        QVERIFY(QFile::copy(tp::test::in_source("resources/samples/anna_smiling.jpg"), file));
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        MendSession session(narrator);
        session.open_file(file);
        QCOMPARE(session.state(), MendSession::State::Looking);
        QTRY_COMPARE_WITH_TIMEOUT(session.state(), MendSession::State::Ready, 60000);
        QCOMPARE(session.photo().size(), QSize(900, 1100));
        QVERIFY(session.featureThere());
        session.setWholeFeature(true);
        session.nudge(0, 4);
        QVERIFY(session.save());
        session.open_file(file);
        QTRY_VERIFY_WITH_TIMEOUT(session.state() == MendSession::State::Ready && session.featureMended(), 60000);
    }
    void a_photograph_that_is_none_is_said() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        MendSession session(narrator);
        session.open(QUrl("https://example.org/a.jpg"));
        QVERIFY(voice.said().back().startsWith("Only a photograph that is a file"));
        session.open_file("/nowhere/at all.jpg");
        QTRY_COMPARE_WITH_TIMEOUT(session.state(), MendSession::State::Problem, 60000);
        QVERIFY(voice.said().back().contains("at all.jpg"));
        session.addFace();
        session.nudge(1, 1);
        QVERIFY(session.save());
    }
    void mended_contours_that_cannot_be_read_are_not_written_over() {
        QTemporaryDir folder;
        const QString file = folder.filePath("anna.jpg");
        QVERIFY(QFile::copy(tp::test::in_source("resources/samples/anna_smiling.jpg"), file));
        const auto contours = correction_file(file.toStdString());
        QVERIFY(replace_file(contours, "not a drawing").empty());
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        MendSession session(narrator);
        session.open_file(file);
        QTRY_COMPARE_WITH_TIMEOUT(session.state(), MendSession::State::Problem, 60000);
        session.leave();
        QCOMPARE(*read_whole(contours, 1 << 20), std::string("not a drawing"));
    }
};

QTEST_MAIN(MendSessionTest)
#include "mend_session_test.moc"
