// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_folders.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QFileInfo>
#include <QSignalSpy>

namespace care_folders_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench : CareGround {
    CareTeller teller{narrator, earcons};
    ImportCare importing{*album, preferences, teller};
    CareFolders folders{*album, importing, narrator, teller};
    using CareGround::CareGround;

    QUrl card() {
        return QUrl::fromLocalFile(
            QString::fromStdString(a_photo(folder, "card/new.jpg", 7).parent_path().string()));
    }
    void choose(const fs::path& one) {
        folders.chooser()->begin_in(QString::fromStdString(one.string()));
        folders.chooser()->choose();
    }
    bool imported() {
        return QTest::qWaitFor([this] { return importing.report() == "1 photograph(s) imported."; }, 60'000);
    }
};

} // namespace

class CareFoldersTest : public QObject {
    Q_OBJECT
private slots:
    void the_photographs_of_a_chosen_folder_are_imported() {
        Bench bench;
        const fs::path card = bench.card().toLocalFile().toStdString();
        QSignalSpy choosing(&bench.folders, &CareFolders::choosingChanged);
        bench.folders.importFolder();
        QVERIFY(bench.folders.choosing());
        QVERIFY(!bench.folders.chooser()->folder().isEmpty());
        bench.choose(card);
        QVERIFY(!bench.folders.choosing());
        QCOMPARE(choosing.size(), 2);
        QVERIFY(bench.imported());
        QVERIFY(fs::exists(bench.photo("new.jpg")));
        QCOMPARE(bench.preferences.choices().folders.size(), 1); // it is not the album's
    }
    void an_import_without_a_folder_asks_for_the_albums_and_follows() {
        Bench bench({}, false);
        QSignalSpy changed(&bench.folders, &CareFolders::foldersChanged);
        QVERIFY(!bench.folders.hasFolders());
        bench.importing.import({bench.card()});
        QVERIFY(bench.folders.choosing());
        bench.choose(bench.folder / "album");
        QVERIFY(!bench.folders.choosing());
        QVERIFY(bench.folders.hasFolders() && !changed.isEmpty());
        QVERIFY(bench.imported());
        QVERIFY(fs::exists(bench.folder / "album/new.jpg"));
    }
    void a_folder_to_import_from_is_chosen_before_the_albums() {
        Bench bench({}, false);
        const fs::path card = bench.card().toLocalFile().toStdString();
        bench.folders.importFolder();
        bench.choose(card);
        QVERIFY(bench.folders.choosing()); // again, for the album now
        bench.choose(bench.folder / "album");
        QVERIFY(bench.imported());
    }
    void photographs_that_are_dropped_meanwhile_ask_for_the_albums_folder() {
        Bench bench({}, false);
        bench.folders.importFolder();
        bench.importing.import({bench.card()});
        bench.choose(bench.folder / "album");
        QVERIFY(bench.folders.hasFolders());
        QVERIFY(bench.imported());
    }
    void who_chooses_none_is_told_and_nothing_is_imported_later() {
        Bench bench({}, false);
        bench.importing.import({bench.card()});
        bench.folders.chooser()->cancel();
        QVERIFY(!bench.folders.choosing());
        QCOMPARE(bench.last_said(), QString("No folder was chosen."));
        bench.importing.chooseFolder(
            QUrl::fromLocalFile(QString::fromStdString((bench.folder / "album").string())));
        QVERIFY(!bench.importing.running());
        QVERIFY(!fs::exists(bench.folder / "album/new.jpg"));
    }
    void a_choice_that_nobody_asked_for_is_none() {
        Bench bench({}, false);
        bench.choose(bench.folder / "album");
        bench.folders.chooser()->cancel();
        QVERIFY(!bench.folders.hasFolders());
        QVERIFY(bench.last_said() != "No folder was chosen.");
    }
    void a_dialog_begins_in_a_folder_that_is_there() {
        Bench bench;
        QVERIFY(QFileInfo(bench.folders.picturesFolder().toLocalFile()).isDir());
    }
};

} // namespace care_folders_test

TP_TEST(care_folders_test, CareFoldersTest, window)
#include "care_folders_test.moc"
