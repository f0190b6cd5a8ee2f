// SPDX-License-Identifier: Apache-2.0
// The page of the camera as a screen reader and a keyboard meet it.
#include "app/pages/capture/capture_module.hpp"
#include "capture_bench.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QSize>
#include <QWindow>

namespace capture_page_test {

using namespace tp;

class CapturePageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_capture(); }

    void everything_has_a_name_a_size_and_its_turn_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("wide") << QSize(1280, 800);
        QTest::newRow("small") << QSize(1024, 520);
        QTest::newRow("tall") << QSize(600, 1000);
        QTest::newRow("tight") << QSize(480, 520);
    }
    void everything_has_a_name_a_size_and_its_turn() {
        QFETCH(QSize, size);
        CaptureBench bench;
        bench.camera->both = bench.camera->torch = true;
        bench.enter();
        bench.see_for(0.3, {{0.5, 0.45}});
        PageWindow window("Capture/CapturePage.qml", bench.session.get(), size);
        QVERIFY(window.exposed());
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QCOMPARE(PageWindow::clipped_texts(window).join("; "), QString());
        const QStringList tabbed = PageWindow::tab_order(window);
        QVERIFY2(tabbed.contains("Camera view") && tabbed.contains("Aim: Head and shoulders") &&
                     tabbed.contains("Front camera") && tabbed.contains("Light"),
                 qPrintable(tabbed.join("; ")));
    }

    void keys_choose_and_ask() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.3, {{0.5, 0.45}});
        PageWindow window("Capture/CapturePage.qml", bench.session.get());
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_3);
        QCOMPARE(bench.session->choices()->aim(), Aim::head_and_shoulders);
        QTest::keyClick(&window, Qt::Key_S);
        QVERIFY(!bench.session->choices()->by_itself());
        bench.voice.clear();
        QTest::keyClick(&window, Qt::Key_W);
        QVERIFY(bench.last_said().startsWith("1 face"));
        QVERIFY(window.press("Aim: One face by thirds"));
        QCOMPARE(bench.session->choices()->aim(), Aim::thirds);
    }

    void arrow_keys_are_the_hand_where_the_camera_is_simulated() {
        CaptureBench bench;
        bench.enter();
        PageWindow real("Capture/CapturePage.qml", bench.session.get());
        QVERIFY(real.exposed());
        QTest::keyClick(&real, Qt::Key_Left);
        QCOMPARE(bench.camera->moved.pan_deg, 0.0);
        CaptureBench desk;
        desk.camera->movable = true;
        desk.enter();
        PageWindow window("Capture/CapturePage.qml", desk.session.get());
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_Left);
        QTest::keyClick(&window, Qt::Key_Up);
        QTest::keyClick(&window, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&window, Qt::Key_PageUp);
        QVERIFY(desk.camera->moved.pan_deg < 0.0 && desk.camera->moved.tilt_deg > 0.0);
        QVERIFY(desk.camera->moved.roll_deg > 0.0 && desk.camera->moved.forward_m > 0.0);
    }

    void a_minimised_window_switches_the_camera_off() {
        CaptureBench bench;
        bench.enter();
        PageWindow window("Capture/CapturePage.qml", bench.session.get());
        QVERIFY(window.exposed());
        QVERIFY(bench.camera->on);
        window.setVisibility(QWindow::Minimized);
        QTRY_VERIFY(!bench.camera->on);
        window.setVisibility(QWindow::Windowed);
        QTRY_VERIFY(bench.camera->on);
        window.hide();
        QTRY_VERIFY(!bench.camera->on);
    }

    void without_a_camera_a_button_leads_to_import() {
        CaptureBench bench;
        bench.camera->why_not = "No camera was found on this computer.";
        bench.session->enter();
        PageWindow window("Capture/CapturePage.qml", bench.session.get());
        QVERIFY(window.exposed());
        QTRY_VERIFY(window.named("No camera was found on this computer.") != nullptr);
        const QSignalSpy asked(bench.session.get(), &CaptureSession::importAsked);
        QVERIFY(window.press("Import photographs"));
        QCOMPARE(asked.size(), 1);
    }
};

} // namespace capture_page_test

TP_TEST(capture_page_test, CapturePageTest, window)
#include "capture_page_test.moc"
