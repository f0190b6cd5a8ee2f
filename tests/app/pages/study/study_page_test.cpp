// SPDX-License-Identifier: Apache-2.0
// The study page as keys, a mouse, a finger and a screen reader meet it; and what is seen of it.
#include "app/pages/study/study_module.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "study_bench.hpp"
#include "test_program.hpp"

#include <QImage>
#include <QPointingDevice>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QRect>
#include <QSet>

#include <memory>

namespace study_page_test {

using namespace tp;
using State = StudyRun::State;

namespace {

const QString page = "Study/StudyPage.qml";

void enlarge_text(PageWindow& window, double scale) {
    QQmlComponent component(window.engine());
    component.setData(
        "import QtQml\nimport TouchPhoto.Controls\nQtObject { readonly property var theme: Theme }", {});
    const std::unique_ptr<QObject> holder(component.create());
    QVERIFY(holder != nullptr);
    QVERIFY(holder->property("theme").value<QObject*>()->setProperty("textScale", scale));
    QTest::qWait(50);
}

QQuickItem* surface_of(PageWindow& window) { return window.rootObject()->findChild<QQuickItem*>("surface"); }

} // namespace

class StudyPageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_study(); }

    void everything_has_a_name_a_size_and_its_turn_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("scale");
        QTest::newRow("wide") << QSize(1280, 800) << 1.0;
        QTest::newRow("small") << QSize(1024, 520) << 1.0;
        QTest::newRow("small, large text") << QSize(1024, 520) << 2.0;
        QTest::newRow("tall, large text") << QSize(600, 1000) << 2.0;
        QTest::newRow("smallest") << QSize(480, 520) << 1.0;
    }
    void everything_has_a_name_a_size_and_its_turn() {
        QFETCH(QSize, size);
        QFETCH(double, scale);
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        PageWindow window(page, bench.session.get(), size);
        QVERIFY(window.exposed());
        enlarge_text(window, scale);
        const auto all_is_well = [&] {
            QCOMPARE(window.faulty_targets().join("; "), QString());
            QCOMPARE(PageWindow::clipped_texts(window).join("; "), QString());
            QCOMPARE(PageWindow::tab_order(window).size(), PageWindow::reading_order(window).size());
        };
        all_is_well();
        QTest::keyClick(&window, Qt::Key_S);
        QCOMPARE(bench.run().state(), State::Consent);
        all_is_well();
        QTest::keyClick(&window, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        all_is_well();
        bench.run().goOn();
        bench.session->advance(0.1);
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Answering);
        all_is_well();
        QVERIFY(window.named("1: circle") != nullptr);
    }

    void keys_alone_lead_through_a_sitting() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_Plus);
        QCOMPARE(bench.session->setup()->participant(), 2);
        QTest::keyClick(&window, Qt::Key_Minus);
        QCOMPARE(bench.session->setup()->participant(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->problem(), QString(), 60000);
        QTest::keyClick(&window, Qt::Key_S);
        QTest::keyClick(&window, Qt::Key_Space);
        QCOMPARE(bench.run().state(), State::Consent);
        QTest::keyClick(&window, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QTest::keyClick(&window, Qt::Key_Space);
        QCOMPARE(bench.run().state(), State::Feeling);
        bench.session->advance(0.05);
        const Vec2 before = bench.session->finger().place();
        QTest::keyClick(&window, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&window, Qt::Key_Up);
        bench.session->advance(1.0);
        const Vec2 way = bench.session->finger().place() - before;
        QVERIFY2(way.x > 5.0 && way.y > 0.5, qPrintable(QString("%1 %2").arg(way.x).arg(way.y)));
        QTest::keyClick(&window, Qt::Key_Space);
        QCOMPARE(bench.run().state(), State::Answering);
        QTest::keyClick(&window, Qt::Key_2);
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QCOMPARE(bench.records().back().answer, std::string("square"));
        QTest::keyClick(&window, Qt::Key_P);
        QCOMPARE(bench.run().state(), State::Paused);
        QTest::keyClick(&window, Qt::Key_W);
        QVERIFY2(bench.said().contains("Participant 1 has done 1 of 4 trials. Paused."),
                 qPrintable(bench.said()));
        QTest::keyClick(&window, Qt::Key_Escape);
        QCOMPARE(bench.run().state(), State::Stopping);
        QTest::keyClick(&window, Qt::Key_Escape);
        QCOMPARE(bench.run().state(), State::SetUp);
    }

    void the_number_is_typed_and_the_keys_are_the_page_s_again() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_N);
        for (const char key : {'1', '2'}) // in the field they are no experiment
            QTest::keyClick(&window, key);
        QCOMPARE(bench.session->setup()->participant(), 1);
        QTest::keyClick(&window, Qt::Key_Return);
        QCOMPARE(bench.session->setup()->participant(), 12);
        QCOMPARE(bench.session->setup()->experiment_index(), 5);
        QCOMPARE(bench.said(), QString("Participant 12"));
        QTest::keyClick(&window, Qt::Key_N);
        for (const char key : {'A', 'n', 'n', 'a'})
            QTest::keyClick(&window, key);
        QTest::keyClick(&window, Qt::Key_Return);
        QCOMPARE(bench.said(), QString("Participants have numbers from 1 to 9999."));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->problem(), QString(), 60000);
        QTest::keyClick(&window, Qt::Key_S);
        QCOMPARE(bench.run().state(), State::Consent);
        QVERIFY(bench.said().contains("under the number 12 "));
    }

    void the_researcher_asks_by_keys_how_the_study_stands() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.start();
        bench.session->advance(0.5);
        bench.run().answer(0);
        bench.settle();
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_C); // means nothing in a sitting
        QTest::keyClick(&window, Qt::Key_R);
        QVERIFY(!bench.has_said("The study is being checked.") && !bench.has_said("report"));
        QTest::keyClick(&window, Qt::Key_Escape);
        QTest::keyClick(&window, Qt::Key_Escape);
        QTest::keyClick(&window, Qt::Key_C);
        QTRY_VERIFY_WITH_TIMEOUT(window.named("Nothing is wrong in the folder.") != nullptr, 60000);
        QTest::keyClick(&window, Qt::Key_R);
        QTRY_VERIFY_WITH_TIMEOUT(bench.has_said("The report is in "), 60000);
        QCOMPARE(PageWindow::clipped_texts(window).join("; "), QString());
        QVERIFY(window.press("How the study stands"));
        QVERIFY(window.press("Make the report"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.voice.said().filter("The report is in ").size(), 2, 60000);
        QTest::keyClick(&window, Qt::Key_S);
        QVERIFY(window.named("Nothing is wrong in the folder.") == nullptr);
    }

    void a_screen_reader_does_it_too() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QVERIFY(window.named("Participant 1 is new.") != nullptr);
        QVERIFY(window.press("Start with participant 1"));
        QVERIFY(window.press("I agree"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY(window.named("Trial 1 of 4") != nullptr);
        QVERIFY(window.press("Start the trial"));
        QCOMPARE(bench.run().state(), State::Feeling);
        bench.session->advance(0.1);
        QVERIFY(window.press("Pause"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Paused, 60000);
        QVERIFY(window.press("Go on"));
        QVERIFY(window.press("Start the trial"));
        bench.session->advance(0.1);
        QVERIFY(window.press("End the trial"));
        QVERIFY(window.press("2: square"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY(window.press("Stop"));
        QVERIFY(window.press("Stop"));
        QCOMPARE(bench.run().state(), State::SetUp);
    }

    void a_mouse_and_a_fingertip_move_the_hand_wherever_they_begin() {
        const std::unique_ptr<QPointingDevice> touch(QTest::createTouchDevice());
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Feeling);
        bench.session->advance(0.05);
        QQuickItem* surface = surface_of(window);
        QVERIFY(surface != nullptr);
        const QPoint there = surface->mapToScene({0.3 * surface->width(), 0.4 * surface->height()}).toPoint();
        const auto moved = [&, before = bench.session->finger().place()] {
            QTest::qWait(60); // touches are handed on with the next picture
            bench.session->advance(0.3);
            return bench.session->finger().place() - before;
        };
        QTest::touchEvent(&window, touch.get()).press(0, there, &window);
        QVERIFY(length(moved()) < 0.5); // a fingertip that comes is no movement
        QTest::touchEvent(&window, touch.get()).move(0, there + QPoint(60, 0), &window);
        const Vec2 once = moved();
        QVERIFY2(once.x > 5.0, qPrintable(QString::number(once.x)));
        QTest::touchEvent(&window, touch.get()).release(0, there + QPoint(60, 0), &window);
        QTest::touchEvent(&window, touch.get()).press(0, there, &window);
        QVERIFY(std::abs(moved().x - once.x) < 2.0);
        QTest::touchEvent(&window, touch.get()).release(0, there, &window);
        const Vec2 so_far = moved();
        for (int up = 0; up <= 50; up += 10)
            QTest::mouseMove(&window, there - QPoint(0, up));
        const Vec2 by_mouse = moved() - so_far;
        QVERIFY2(by_mouse.y > 4.0, qPrintable(QString("%1 %2").arg(by_mouse.x).arg(by_mouse.y)));
        QCOMPARE(bench.run().state(), State::Feeling);
    }

    void another_window_pauses() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QVERIFY(QTest::qWaitForWindowActive(&window));
        bench.run().goOn();
        bench.session->advance(0.1);
        QQuickView other;
        other.show();
        other.requestActivate();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Paused, 60000);
        QVERIFY(bench.session->finger().seen().force() == Vec2(0.0));
    }

    /// The same pixels, whatever lies under the finger.
    void nothing_of_the_scene_is_seen() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QTest::qWait(200);
        const QQuickItem* surface = surface_of(window);
        const QRect inside =
            surface->mapRectToScene(surface->boundingRect()).toRect().adjusted(16, 16, -16, -16);
        const auto colours = [&] {
            const QImage shot = window.grabWindow().copy(inside);
            QSet<QRgb> all;
            for (int y = 0; y < shot.height(); ++y)
                for (int x = 0; x < shot.width(); ++x)
                    all << shot.pixel(x, y);
            return all;
        };
        QCOMPARE(colours().size(), 1);
        bench.run().goOn();
        bench.go(bench.now().start + Vec2(30.0, 10.0));
        QCOMPARE(bench.run().state(), State::Feeling);
        QTest::qWait(100);
        QCOMPARE(colours().size(), 1);
        for (QAccessibleInterface* one : PageWindow::everything(window))
            for (const char* told : {"circle", "square"})
                QVERIFY2(!one->text(QAccessible::Name).contains(told),
                         qPrintable(one->text(QAccessible::Name)));
    }

    void who_tries_it_out_sees_the_scene() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        PageWindow window(page, bench.session.get());
        QVERIFY(window.exposed());
        QVERIFY(window.press("Show the scene, to try it out; nothing is kept"));
        QVERIFY(bench.session->setup()->show_scene());
        QTest::keyClick(&window, Qt::Key_S);
        QTest::keyClick(&window, Qt::Key_Return);
        QCOMPARE(bench.run().state(), State::Ready);
        QTest::qWait(200);
        const QQuickItem* surface = surface_of(window);
        const QRect inside =
            surface->mapRectToScene(surface->boundingRect()).toRect().adjusted(16, 16, -16, -16);
        const QImage shot = window.grabWindow().copy(inside);
        QSet<QRgb> colours;
        for (int y = 0; y < shot.height(); ++y)
            for (int x = 0; x < shot.width(); ++x)
                colours << shot.pixel(x, y);
        QVERIFY(colours.size() > 2);
        QVERIFY(window.named("This is tried out. Nothing is kept.") != nullptr);
    }
};

} // namespace study_page_test

TP_TEST(study_page_test, StudyPageTest, window)
#include "study_page_test.moc"
