// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_saving.hpp"
#include "core/files/durable_file.hpp"
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTest>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace mend_saving_test {

using namespace tp;

namespace {

/// Whether this run is root's, whom no permission stops.
bool nothing_is_forbidden(const QString& folder) {
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::ExeOwner);
    QFile probe(folder + "/probe");
    const bool writes = probe.open(QIODevice::WriteOnly);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    probe.remove();
    return writes;
}

struct SavingBench : MendParts {
    std::optional<MendSaving> saving{std::in_place, photo, selection, history, narrator};

    explicit SavingBench(int faces = 1) { show(faces); }
};

} // namespace

class MendSavingTest : public QObject {
    Q_OBJECT
private slots:
    /// Whoever put it there: neither the link nor what it leads to is written.
    void a_link_in_the_place_of_the_drawing_is_left_alone() {
        SavingBench bench;
        const std::filesystem::path secret = bench.folder.filePath("secret").toStdString();
        QCOMPARE(replace_file(secret, "secret"), std::string());
        bench.move(2.25);
        std::filesystem::create_symlink(secret, bench.file());
        QVERIFY(!bench.saving->save());
        QVERIFY2(bench.said().contains("is a link; it is left alone."), qPrintable(bench.said()));
        QVERIFY(std::filesystem::is_symlink(bench.file()));
        const auto bytes = read_whole(secret, 100);
        QCOMPARE(bytes ? *bytes : bytes.error(), std::string("secret"));
        QVERIFY(bench.saving->unsaved());
    }
    void what_is_saved_is_what_is_read_again() {
        SavingBench bench(2);
        QVERIFY(!bench.saving->unsaved() && !bench.saving->canDiscard());
        bench.move(2.25);
        bench.history.step("one was removed, another added", [](MendWork& work) {
            MendFeature& gone = work.faces[0].features[right_eye];
            gone.line.reset();
            gone.mended = true;
            MendFeature& added = work.faces[1].features[mouth_opening];
            added.line = template_for(work.faces[1], added.name);
            added.mended = true;
        });
        QVERIFY(bench.saving->unsaved() && bench.saving->canDiscard());
        const std::string text = bench.text();
        QVERIFY(bench.saving->save());
        QCOMPARE(bench.said(), QString("The contours are saved."));
        QCOMPARE(bench.bytes(), text);
        QVERIFY(!bench.saving->unsaved());
        const MendPhoto again = drawn_mend_photo(bench.folder.path(), 2);
        QCOMPARE(sheet_to_svg(sheet_of(again.work)), text);
        QVERIFY(!again.work.faces[0].features[right_eye].line);
        QVERIFY(*again.work.faces[0].features[left_eye].line == *bench.feature(left_eye).line);
        QVERIFY(again.work.faces[1].features[mouth_opening].line);
    }
    void a_face_that_was_added_is_read_again() {
        SavingBench bench(0);
        bench.history.step("a face was added", [](MendWork& work) {
            work.faces.push_back(usual_face({200, 150}, 150));
        });
        QVERIFY(bench.saving->save());
        const Extraction again =
            with_corrections(drawn_extraction(0), bench.folder.filePath("drawn.png").toStdString());
        QCOMPARE(again.faces.size(), 1u);
        QCOMPARE(again.faces[0].contours.size(), 5u);
    }
    void only_what_was_mended_is_saved() {
        SavingBench bench;
        bench.move();
        QVERIFY(bench.saving->save());
        const auto sheet = read_sheet(bench.file(), ContourSheet::Unit::pixel);
        QVERIFY(sheet);
        QCOMPARE(sheet->contours.size(), 1u);
        QCOMPARE(sheet->contours[0].name, std::string("left_eye"));
    }
    void without_a_mended_contour_there_is_no_file() {
        SavingBench bench;
        QVERIFY(bench.saving->save());
        QVERIFY(!std::filesystem::exists(bench.file()));
        bench.move();
        QVERIFY(bench.saving->save());
        QVERIFY(std::filesystem::exists(bench.file()));
        bench.history.undo();
        QVERIFY(bench.saving->unsaved());
        QVERIFY(bench.saving->save());
        QVERIFY(!std::filesystem::exists(bench.file()));
    }
    void changes_are_discarded_and_come_back() {
        SavingBench bench;
        bench.saving->discard();
        QCOMPARE(bench.said(), QString("Nothing was changed."));
        const std::string opened = bench.text();
        bench.move();
        const std::string moved = bench.text();
        bench.selection.chooseHandle(1);
        bench.saving->discard();
        QCOMPARE(bench.text(), opened);
        QCOMPARE(bench.selection.handle(), -1);
        QVERIFY(!bench.saving->canDiscard() && !bench.saving->unsaved());
        bench.history.undo();
        QCOMPARE(bench.text(), moved);
    }
    void discarded_changes_leave_the_very_bytes_of_another_program() {
        const std::string foreign =
            "<svg xmlns='http://www.w3.org/2000/svg' width='400px' height='300px' viewBox='0 0 400 300'>"
            "<text>of Anna</text><path id='left_eye' d='M 210 120 L 250 120 L 230 130 Z'/></svg>\n";
        SavingBench bench;
        QVERIFY(replace_file(bench.file(), foreign).empty());
        bench.show();
        QVERIFY(bench.selection.featureMended());
        bench.move(3.0);
        QVERIFY(bench.saving->save());
        QVERIFY(bench.bytes() != foreign);
        bench.saving->discard();
        QVERIFY(bench.saving->save());
        QCOMPARE(bench.bytes(), foreign);
    }
    void the_end_of_the_program_saves() {
        SavingBench bench;
        bench.move();
        bench.saving.reset();
        QCOMPARE(bench.bytes(), bench.text());
    }
    void a_refused_write_says_so_and_keeps_everything() {
        SavingBench bench;
        bench.move();
        const std::string text = bench.text();
        std::filesystem::create_directories(bench.file() / "in the way");
        QVERIFY(!bench.saving->save());
        QVERIFY(bench.said().endsWith("Your work is kept here; nothing is lost."));
        QVERIFY(bench.saving->unsaved() && bench.history.canUndo());
        QCOMPARE(bench.text(), text);
        std::filesystem::remove_all(bench.file());
        QVERIFY(bench.saving->save());
        QCOMPARE(bench.bytes(), text);
    }
    void a_folder_that_may_not_be_written_to() {
        SavingBench bench;
        if (nothing_is_forbidden(bench.folder.path()))
            QSKIP("Nothing is forbidden to this user.");
        bench.move();
        QFile::setPermissions(bench.folder.path(), QFile::ReadOwner | QFile::ExeOwner);
        QVERIFY(!bench.saving->save());
        QFile::setPermissions(bench.folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        QVERIFY(bench.saving->save());
    }
    void what_another_program_wrote_meanwhile_is_kept_beside_it() {
        SavingBench bench;
        bench.move();
        QVERIFY(bench.saving->save());
        QVERIFY(replace_file(bench.file(), "<svg>of another</svg>").empty());
        bench.move();
        QVERIFY(bench.saving->save());
        QCOMPARE(bench.bytes(), bench.text());
        QVERIFY(bench.said().contains("drawn.png.contours-1.svg"));
        QCOMPARE(*read_whole(bench.folder.filePath("drawn.png.contours-1.svg").toStdString(), 1 << 20),
                 std::string("<svg>of another</svg>"));
    }
};

} // namespace mend_saving_test

TP_TEST(mend_saving_test, MendSavingTest, window)
#include "mend_saving_test.moc"
