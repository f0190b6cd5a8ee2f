// SPDX-License-Identifier: Apache-2.0
#include "settings_bench.hpp"
#include "test_program.hpp"

#include <QTest>

namespace settings_session_test {

using namespace tp;

class SettingsSessionTest : public QObject {
    Q_OBJECT
private slots:
    void who_enters_is_told_and_who_leaves_chooses_no_folder_any_more() {
        SettingsBench bench;
        bench.session.enter();
        QVERIFY(bench.said("Settings. Go through them with Tab"));
        bench.session.storage()->addFolder();
        bench.session.leave();
        QVERIFY(!bench.session.storage()->choosing());
    }
    void steps_of_all_parts_are_taken_back_the_newest_first() {
        SettingsBench bench;
        bench.session.looks()->chooseTheme(1);
        bench.session.speech()->chooseRate(4);
        bench.session.feeling()->setNose(true);
        QCOMPARE(bench.session.steps()->undoable(), QString("the nose"));
        for (int i = 0; i < 3; ++i)
            bench.session.steps()->undo();
        QCOMPARE(bench.now(), Choices{});
    }
    void back_ends_choosing_a_folder_and_then_leads_away() {
        SettingsBench bench;
        bench.session.storage()->addFolder();
        QVERIFY(bench.session.back());
        QVERIFY(!bench.session.back());
        QCOMPARE(bench.voice.said().back(), QString("No folder was chosen."));
    }
};

} // namespace settings_session_test

TP_TEST(settings_session_test, SettingsSessionTest, event_loop)
#include "settings_session_test.moc"
