// SPDX-License-Identifier: Apache-2.0
// What is known of a board by its name and its vendor.
#include "device/haply_2diy/found_boards.hpp"
#include "device/haply_2diy/homed_note.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace tp;

class KnownBoardsTest : public QObject {
    Q_OBJECT
private slots:
    void a_note_is_kept_for_each_board_of_a_name() {
        const QTemporaryDir folder;
        const QByteArray before = qgetenv("XDG_RUNTIME_DIR");
        qputenv("XDG_RUNTIME_DIR", folder.path().toUtf8());
        const HomedNote note = HomedNote::of_board("A/1", HaplyGeneration::third);
        QVERIFY(!note.holds());
        note.put();
        QVERIFY(note.holds());
        QVERIFY(std::filesystem::exists(folder.filePath("touchphoto-2diy-A_1").toStdString()));
        QVERIFY(!HomedNote::of_board("A/2", HaplyGeneration::third).holds());
        QVERIFY(!HomedNote::of_board("A/1", HaplyGeneration::first).holds());
        const HomedNote nameless = HomedNote::of_board("", HaplyGeneration::third);
        nameless.put();
        QVERIFY(!nameless.holds());
        note.forget();
        QVERIFY(!note.holds());
        qunsetenv("XDG_RUNTIME_DIR");
        QVERIFY(!HomedNote::of_board("A/1", HaplyGeneration::third).holds());
        if (!before.isNull())
            qputenv("XDG_RUNTIME_DIR", before);
    }

    void vendors_are_known_in_capitals_or_not() {
        for (const char* vendor : {"2341", "2A03", "2a03"})
            QVERIFY2(is_arduino(vendor), vendor);
        for (const char* vendor : {"", "234", "23411", "2342", "2z03", "2B03", "1a03"})
            QVERIFY2(!is_arduino(vendor), vendor);
    }
};

QTEST_APPLESS_MAIN(KnownBoardsTest)
#include "known_boards_test.moc"
