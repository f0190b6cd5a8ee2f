// SPDX-License-Identifier: Apache-2.0
#include "byte_mutants.hpp"
#include "device/hid_pid/joystick_scale_file.hpp"
#include "joystick_scale_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace joystick_scale_file_test {

using namespace tp;

namespace {
const std::string two_joysticks =
    "touchphoto sticks 1\n8.5 -1 1 FS 0001\n60 1 -1 SideWinder Force Feedback 2\n";
}

class JoystickScaleFileTest : public QObject {
    Q_OBJECT
private slots:
    void each_joystick_has_its_own() {
        const std::optional<JoystickScale> one = joystick_scale_in(two_joysticks, "FS 0001");
        QVERIFY(one.has_value());
        QCOMPARE(one->newtons_at_full, 8.5);
        QVERIFY(one->sign == Vec2(-1.0, 1.0));
        QVERIFY(one->measured);
        QCOMPARE(joystick_scale_in(two_joysticks, "SideWinder Force Feedback 2")->newtons_at_full, 60.0);
        QVERIFY(!joystick_scale_in(two_joysticks, "FS 0002"));
        QVERIFY(!joystick_scale_in(two_joysticks, "FS"));
    }
    void the_last_line_of_a_joystick_counts() {
        QCOMPARE(joystick_scale_in(two_joysticks + "9 1 1 FS 0001\n", "FS 0001")->newtons_at_full, 9.0);
        QCOMPARE(joystick_scale_in(two_joysticks + "9 1 1 FS 0001", "FS 0001")->newtons_at_full,
                 9.0); // cut off after it
    }
    void what_makes_no_sense_counts_as_none_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("another_version") << QByteArray("touchphoto sticks 2\n8 1 1 A\n");
        QTest::newRow("no_force") << QByteArray("touchphoto sticks 1\n0 1 1 A\n");
        QTest::newRow("negative_force") << QByteArray("touchphoto sticks 1\n-8 1 1 A\n");
        QTest::newRow("force_of_a_lorry") << QByteArray("touchphoto sticks 1\n1e9 1 1 A\n");
        QTest::newRow("not_a_number") << QByteArray("touchphoto sticks 1\nnan 1 1 A\n");
        QTest::newRow("sign_of_2") << QByteArray("touchphoto sticks 1\n8 2 1 A\n");
        QTest::newRow("no_sign") << QByteArray("touchphoto sticks 1\n8 1 A\n");
        QTest::newRow("comma") << QByteArray("touchphoto sticks 1\n8,5 1 1 A\n");
    }
    void what_makes_no_sense_counts_as_none() {
        QFETCH(QByteArray, text);
        QVERIFY(!joystick_scale_in(text.toStdString(), "A"));
    }
    void any_bytes_give_a_sane_scale_or_none() {
        tp::test::ByteMutator mutator(7);
        const std::vector<tp::test::Seed> seeds{{"two", two_joysticks}};
        for (int i = 0; i < 3000; ++i)
            if (const std::optional<JoystickScale> scale =
                    joystick_scale_in(mutator.mutant(seeds), "FS 0001")) {
                QVERIFY(scale->newtons_at_full >= 0.5 && scale->newtons_at_full <= 200.0);
                QVERIFY(std::abs(scale->sign.x) == 1.0 && std::abs(scale->sign.y) == 1.0);
            }
    }
    void a_file_that_is_not_there_measures_nothing() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("sticks.txt").toStdString();
        QVERIFY(!kept_joystick_scale(file, "FS 0001").measured);
        QFile kept(folder.filePath("sticks.txt"));
        QVERIFY(kept.open(QIODevice::WriteOnly));
        kept.write(two_joysticks.c_str());
        kept.close();
        QVERIFY(kept_joystick_scale(file, "FS 0001").measured);
        QVERIFY(!kept_joystick_scale(file, "").measured);
        QVERIFY(!kept_joystick_scale({}, "FS 0001").measured);
    }
    void what_is_measured_takes_the_place_of_what_was_and_leaves_the_rest() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("new/sticks.txt").toStdString();
        QCOMPARE(keep_joystick_scale(file, "FS 0001", {8.5, {-1.0, 1.0}, true}), std::string());
        QCOMPARE(keep_joystick_scale(file, "Side Winder", {21.123456789, {1.0, 1.0}, true}), std::string());
        QFile text(QString::fromStdString(file.string()));
        QVERIFY(text.open(QIODevice::Append));
        text.write("a line of a later version\n7 1 1 FS 0001");
        text.close();
        QCOMPARE(keep_joystick_scale(file, "FS 0001", {9.0, {1.0, -1.0}, true}), std::string());
        QCOMPARE(kept_joystick_scale(file, "FS 0001").newtons_at_full, 9.0);
        QVERIFY(kept_joystick_scale(file, "FS 0001").sign == Vec2(1.0, -1.0));
        QVERIFY(std::abs(kept_joystick_scale(file, "Side Winder").newtons_at_full - 21.1235) < 1e-4);
        QVERIFY(text.open(QIODevice::ReadOnly));
        const QByteArray all = text.readAll();
        QCOMPARE(all.count("FS 0001"), 1);
        QVERIFY(all.contains("a line of a later version\n"));
    }
    void what_cannot_be_kept_is_said_and_nothing_lost() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("sticks.txt").toStdString();
        for (const char* const key : {"", " x", "a\nb"})
            QVERIFY(keep_joystick_scale(file, key, {}).ends_with("no name to keep it by."));
        QVERIFY(!std::filesystem::exists(file));
        QVERIFY(!keep_joystick_scale({}, "A", {}).empty());
        std::filesystem::create_directory(file);
        QVERIFY(!keep_joystick_scale(file, "A", {}).empty());
        QVERIFY(std::filesystem::is_directory(file));
    }
    void it_lies_with_the_persons_settings() {
        qputenv("XDG_CONFIG_HOME", "/somewhere");
        QCOMPARE(joystick_scale_file().generic_string(), std::string("/somewhere/touchphoto/sticks.txt"));
        qunsetenv("XDG_CONFIG_HOME");
        qputenv("HOME", "/home/one");
        QCOMPARE(joystick_scale_file().generic_string(),
                 std::string("/home/one/.config/touchphoto/sticks.txt"));
    }

    void hostile_scales() {
        const auto files = tp::test::corpus(tp::test::in_source("tests/device/hid_pid/scale_corpus"));
        QVERIFY(files.size() >= 4);
        for (const auto& file : files)
            QCOMPARE(tp::test::complaint_about_joystick_scales(file.text), std::string());
    }
};

} // namespace joystick_scale_file_test

TP_TEST(joystick_scale_file_test, JoystickScaleFileTest, nothing)
#include "joystick_scale_file_test.moc"
