// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/touch_access.hpp"
#include "app/parts/devices/touch_drive.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <vector>

namespace touch_access_test {

using namespace tp;

class TouchAccessTest : public QObject {
    Q_OBJECT
private slots:
    void the_chosen_output_serves_and_else_what_is_under_the_finger() {
        const std::vector<ListedTouchOutput> there{
            {"motor:A", "game pad", "A", TouchMeans::rumble, false},
            {"pad:/dev/hidraw3", "touchpad", "", TouchMeans::ticks, true},
            {"drawn", "drawn finger", "", TouchMeans::friction, false}};
        QCOMPARE(touch_for(there, {}), &there[1]);
        QCOMPARE(touch_for(there, "broken long ago"), &there[1]);
        for (const ListedTouchOutput& one : there)
            QCOMPARE(touch_for(there, key_of(one)), &one);
        QCOMPARE(touch_for({there[0]}, {}), nullptr); // nobody may hold it
        QCOMPARE(touch_for({}, "A"), nullptr);
    }

    void the_drawn_one_is_always_there_and_comes_last() {
        const TouchAccess access = TouchAccess::of_this_computer(200.0, 150.0, nullptr);
        const std::vector<ListedTouchOutput> there = access.list();
        QVERIFY(!there.empty());
        QCOMPARE(there.back().name, std::string(drawn_touch_name));
        const auto made = access.make(drawn_touch_name);
        QVERIFY(made && (*made)->open());
        QVERIFY(!access.make("no such output"));
    }

    void a_motor_that_is_a_file_comes_first_while_the_file_is_there() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("motor");
        const TouchAccess access =
            TouchAccess::of_this_computer(200.0, 150.0, nullptr).with_motor_file(file.toStdString());
        const std::size_t others = access.list().size();
        QCOMPARE(access.list().back().name, std::string(drawn_touch_name));
        QVERIFY(QFile(file).open(QIODevice::WriteOnly));
        const std::vector<ListedTouchOutput> there = access.list();
        QCOMPARE(there.size(), others + 1);
        QCOMPARE(touch_for(there, {}), &there[0]);
        QVERIFY(touch_for(there, drawn_touch_name) == &there.back()); // chosen by the person
        const auto made = access.make(there[0].name);
        QVERIFY(made && (*made)->open());
        QVERIFY(access.make(drawn_touch_name));
    }

    void an_output_of_a_command_line_is_named_with_its_file() {
        QCOMPARE(motor_file_named("simulated:/tmp/a motor"), std::filesystem::path("/tmp/a motor"));
        for (const char* const wrong : {"", "simulated", "simulated:", "/tmp/motor", "drawn"})
            QVERIFY2(!motor_file_named(wrong), wrong);
    }

    void a_pad_lies_on_the_surface_true_in_shape_and_as_large_as_it_goes() {
        const Affine map = pad_on_surface({{-20.0, -10.0}, {20.0, 30.0}}, {200.0, 150.0});
        QVERIFY(length(map({-20.0, -10.0}) - Vec2(-75.0, -75.0)) < 1e-9);
        QVERIFY(length(map({20.0, 30.0}) - Vec2(75.0, 75.0)) < 1e-9);
        const Affine wide = pad_on_surface({{0.0, 0.0}, {100.0, 10.0}}, {200.0, 150.0});
        QVERIFY(length(wide({100.0, 10.0}) - Vec2(100.0, 10.0)) < 1e-9);
    }
};

} // namespace touch_access_test

TP_TEST(touch_access_test, TouchAccessTest, event_loop)
#include "touch_access_test.moc"
