// SPDX-License-Identifier: Apache-2.0
#include "app/settings/settings_module.hpp"
#include "page_window.hpp"
#include "settings_bench.hpp"

#include <QSize>

using namespace tp;

class SettingsPageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QAccessible::setActive(true);
        register_settings();
    }
    void cleanup() { QCOMPARE(Warnings::all(), QStringList()); }

    void everything_has_a_name_and_size_and_tab_goes_round_in_reading_order_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("wide") << QSize(1280, 800);
        QTest::newRow("tall") << QSize(600, 1000);
        QTest::newRow("smallest") << QSize(480, 560);
    }
    void everything_has_a_name_and_size_and_tab_goes_round_in_reading_order() {
        QFETCH(QSize, size);
        const Warnings warnings;
        SettingsBench bench;
        bench.preferences.change([](Choices& choices) { choices.folders = {"/home/x/Pictures/Familie"}; });
        bench.session.setTextScale(1.0);
        bench.session.chooseTheme(1);
        PageWindow window(page, &bench.session, size);
        QVERIFY(window.exposed());
        QCOMPARE(window.faulty_targets().join("; "), QString());
        const QStringList tabbed = PageWindow::tab_order(window);
        QCOMPARE(tabbed, PageWindow::reading_order(window));
        QVERIFY(tabbed.size() > 25);
    }

    void a_screen_reader_changes_speech_colours_and_size() {
        const Warnings warnings;
        SettingsBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QVERIFY(window.press("Speed of speech: Fast"));
        QCOMPARE(bench.now().rate, Choices::Rate::fast);
        QVERIFY(window.named("Speed of speech: Fast")->state().checked);
        QVERIFY(window.press("Colours: Yellow on black"));
        QCOMPARE(bench.now().theme, Choices::Theme::yellow_on_black);
        QAccessibleInterface* size = window.named("Size of text");
        QVERIFY(size != nullptr);
        size->valueInterface()->setCurrentValue(1.5);
        QCOMPARE(bench.now().text_scale, 1.5);
        QVERIFY(window.press("Take back: the size of text"));
        QCOMPARE(bench.now().text_scale, 1.0);
        QCOMPARE(size->valueInterface()->currentValue().toDouble(), 1.0);
    }

    void keys_alone_change_and_take_back() {
        const Warnings warnings;
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
        const Warnings warnings;
        SettingsBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QVERIFY(window.press("Add a folder"));
        bench.session.chooser()->begin_in("/usr");
        QTRY_VERIFY(window.named("Take this folder") != nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QVERIFY(window.press("To the folder above"));
        QCOMPARE(bench.session.chooser()->folder(), QString("/"));
        QVERIFY(window.press("Take this folder"));
        QCOMPARE(bench.now().folders, QStringList("/"));
        QVERIFY(window.named("Add a folder") != nullptr);
        QVERIFY(window.press("Add a folder"));
        QTRY_VERIFY(window.named("Take this folder") != nullptr);
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!bench.session.choosing());
    }

private:
    const QString page = "Settings/SettingsPage.qml";
};

QTEST_MAIN(SettingsPageTest)
#include "settings_page_test.moc"
