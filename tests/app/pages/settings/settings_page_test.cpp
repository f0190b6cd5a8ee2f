// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/settings_module.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "settings_bench.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QPoint>
#include <QPointF>
#include <QPointingDevice>
#include <QScreen>
#include <QSize>

#include <cmath>
#include <memory>

namespace settings_page_test {

using namespace tp;

class SettingsPageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_settings(); }

    void everything_has_a_name_and_size_and_tab_goes_round_in_reading_order_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("wide") << QSize(1280, 800);
        QTest::newRow("tall") << QSize(600, 1000);
        QTest::newRow("smallest") << QSize(480, 560);
    }
    void everything_has_a_name_and_size_and_tab_goes_round_in_reading_order() {
        QFETCH(QSize, size);
        SettingsBench bench;
        bench.preferences.change([](Choices& choices) { choices.folders = {"/home/x/Pictures/Familie"}; });
        bench.session.looks()->setTextScale(1.0);
        bench.session.looks()->chooseTheme(1);
        PageWindow window(page, &bench.session, size);
        QVERIFY(window.exposed());
        QCOMPARE(window.faulty_targets().join("; "), QString());
        const QStringList tabbed = PageWindow::tab_order(window);
        QCOMPARE(tabbed, PageWindow::reading_order(window));
        QVERIFY(tabbed.size() > 25);
    }

    void a_screen_reader_changes_speech_colours_and_size() {
        SettingsBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QVERIFY(window.press("Speed of speech: Fast"));
        QCOMPARE(bench.now().rate, Choices::Rate::fast);
        QVERIFY(window.named("Speed of speech: Fast")->state().checked);
        QVERIFY(window.press("Colours: Yellow on black"));
        QCOMPARE(bench.now().theme, Choices::Theme::yellow_on_black);
        QAccessibleInterface* size = window.named("Text size");
        QVERIFY(size != nullptr);
        size->valueInterface()->setCurrentValue(1.5);
        QCOMPARE(bench.now().text_scale, 1.5);
        QVERIFY(window.press("Undo: the text size"));
        QCOMPARE(bench.now().text_scale, 1.0);
        QCOMPARE(size->valueInterface()->currentValue().toDouble(), 1.0);
    }

    void keys_alone_change_and_take_back() {
        SettingsBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_Tab); // from "TouchPhoto speaks" to "My screen reader speaks"
        QTest::keyClick(&window, Qt::Key_Return);
        QCOMPARE(bench.now().voice, Choices::Voice::screen_reader);
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bench.now().voice, Choices::Voice::program);
    }

    void a_folder_is_chosen_by_actions_alone() {
        SettingsBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QVERIFY(window.press("Add a folder"));
        bench.session.storage()->chooser()->begin_in("/usr");
        QTRY_VERIFY(window.named("Choose this folder") != nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QVERIFY(window.press("Up one folder"));
        QCOMPARE(bench.session.storage()->chooser()->folder(), QString("/"));
        QVERIFY(window.press("Choose this folder"));
        QCOMPARE(bench.now().folders, QStringList("/"));
        QVERIFY(window.named("Add a folder") != nullptr);
        QVERIFY(window.press("Add a folder"));
        QTRY_VERIFY(window.named("Choose this folder") != nullptr);
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!bench.session.storage()->choosing());
    }

    void a_joystick_is_measured_by_a_screen_reader_and_keys_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("wide") << QSize(1280, 800);
        QTest::newRow("smallest") << QSize(480, 560);
    }
    void a_joystick_is_measured_by_a_screen_reader_and_keys() {
        QFETCH(QSize, size);
        SettingsBench bench;
        bench.socket.hold_at({0.0, 100.0});
        bench.socket.be_a_joystick(8.0, {-1.0, 1.0});
        bench.socket.plug_in();
        bench.session.enter();
        PageWindow window(page, &bench.session, size);
        QVERIFY(window.exposed());
        DeviceSettings& devices = *bench.session.devices();
        QTRY_VERIFY(window.named("Measure the stick") != nullptr);
        QVERIFY(window.press("Measure the stick"));
        QTRY_VERIFY(window.named("Cancel the measurement") != nullptr);
        QVERIFY(window.named("Speed of speech: Fast") == nullptr);
        QVERIFY(window.named("Use this weight") == nullptr); // nothing to be weighed yet
        bench.wait_in_time([&] { return devices.weighing(); });
        QTRY_VERIFY(window.named("Use this weight") != nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QCOMPARE(PageWindow::tab_order(window), PageWindow::reading_order(window));
        bench.socket.hold();
        const auto grams = [&bench] {
            return 1e3 * bench.socket.force().y / JoystickTrial::standard_gravity;
        };
        bench.wait_in_time([&] { return grams() > 100.0; }, 20.0);
        QAccessibleInterface* slider = window.named("Grams, in steps of five");
        QVERIFY(slider != nullptr);
        for (int i = 0; i < 8 && devices.weighing(); ++i) {
            slider->valueInterface()->setCurrentValue(5.0 * std::round(grams() / 5.0) + (i == 0 ? 5.0 : 0.0));
            QVERIFY(window.press("Use this weight"));
            bench.wait_in_time([] { return false; }, 1.0);
        }
        QVERIFY(!devices.measuring());
        QVERIFY(bench.said("The stick is measured:"));
        QTRY_VERIFY(window.named("Speed of speech: Fast") != nullptr);
        QTRY_VERIFY(window.named("Measure the stick") != nullptr); // again, where the person wants to
        QVERIFY(window.press("Measure the stick"));
        QTRY_VERIFY(devices.measuring());
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!devices.measuring());
        QTRY_VERIFY(!bench.socket.in_use());
    }

    void a_device_is_chosen_and_calibrated_by_a_screen_reader_keys_and_touch_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("wide") << QSize(1280, 800);
        QTest::newRow("smallest") << QSize(480, 560);
    }
    void a_device_is_chosen_and_calibrated_by_a_screen_reader_keys_and_touch() {
        QFETCH(QSize, size);
        SettingsBench bench;
        bench.socket.plug_in();
        bench.session.enter();
        PageWindow window(page, &bench.session, size);
        QVERIFY(window.exposed());
        const QString pad = "Force device: force pad TPC-0042, over USB (HID)";
        QTRY_VERIFY(window.named(pad) != nullptr);
        QVERIFY(window.named(pad)->state().checked);
        QVERIFY(window.press("Force device: None: sound, and a drawn finger"));
        QCOMPARE(bench.now().device, QString(no_device_key));
        QVERIFY(window.named("Try the strongest force") == nullptr);
        QVERIFY(window.press(pad));
        QCOMPARE(bench.now().device, QString("TPC-0042"));
        QTRY_VERIFY(window.named("Try the strongest force") != nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());

        QVERIFY(window.press("Calibrate the device on this screen"));
        QTRY_VERIFY(window.named("Cancel the calibration") != nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QVERIFY(window.named("Speed of speech: Fast") == nullptr);
        // A corner, with a finger: millimetres of the screen are the device's, wherever the window lies.
        QCoreApplication::processEvents();
        const QPoint corner(40, 40);
        const double density = window.screen()->physicalDotsPerInch() / 25.4;
        const QPointF at = QPointF(window.mapToGlobal(corner)) / density;
        bench.socket.hold_at({at.x(), 100.0 - at.y()});
        QTest::qWait(20);
        QTest::touchEvent(&window, screen.get()).press(0, corner, &window);
        for (int i = 0; i < 100 && bench.session.devices()->mark() == 0; ++i) {
            bench.time += 0.06;
            QTest::qWait(17);
        }
        QTest::touchEvent(&window, screen.get()).release(0, corner, &window);
        QCOMPARE(bench.session.devices()->mark(), 1);
        QVERIFY(window.named("Now the top right corner.") != nullptr);
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!bench.session.devices()->calibrating());
        QTRY_VERIFY(window.named("Speed of speech: Fast") != nullptr);
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier); // the page has the keys again
        QVERIFY(bench.now().device != "TPC-0042");
    }

private:
    const std::unique_ptr<QPointingDevice> screen{QTest::createTouchDevice()};
    const QString page = "Settings/SettingsPage.qml";
};

} // namespace settings_page_test

TP_TEST(settings_page_test, SettingsPageTest, window)
#include "settings_page_test.moc"
