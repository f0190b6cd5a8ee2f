// SPDX-License-Identifier: Apache-2.0
// What is known of a board by its name and its vendor.
#include "device/haply_2diy/found_boards.hpp"
#include "device/haply_2diy/homed_note.hpp"
#include "device/haply_2diy/plugged_boards.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <string>
#include <vector>

namespace known_boards_test {

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

    void each_is_listed_as_either_generation_and_opened_where_somebody_chose_it() {
        const std::vector<PluggedDevice> listed =
            as_either_generation({{"COM98", "7523031393535120A0D1"}, {"COM99", ""}});
        QCOMPARE(listed.size(), std::size_t(4));
        QCOMPARE(listed[0].name, std::string("2diy3:7523031393535120A0D1"));
        QCOMPARE(listed[1].name, std::string("2diy1:7523031393535120A0D1"));
        QCOMPARE(listed[2].name, std::string("2diy3:COM99"));
        QVERIFY(listed[0].about.find("third generation?") != std::string::npos);
        QVERIFY(listed[1].about.find("first generation?") != std::string::npos);
        for (const PluggedDevice& device : listed) {
            QVERIFY(device.only_when_chosen);
            QCOMPARE(device.interface(), std::string("serial"));
            const auto made = device.make();
            QVERIFY(made != nullptr);
            const auto opened = made->open();
            QVERIFY2(!opened.ok() && opened.error().find("Haply 2diy was unplugged") != std::string::npos,
                     opened.error().c_str());
        }
    }

    void vendors_are_known_in_capitals_or_not() {
        for (const char* vendor : {"2341", "2A03", "2a03"})
            QVERIFY2(is_arduino(vendor), vendor);
        for (const char* vendor : {"", "234", "23411", "2342", "2z03", "2B03", "1a03"})
            QVERIFY2(!is_arduino(vendor), vendor);
    }
};

} // namespace known_boards_test

TP_TEST(known_boards_test, KnownBoardsTest, nothing)
#include "known_boards_test.moc"
