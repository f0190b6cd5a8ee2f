// SPDX-License-Identifier: Apache-2.0
// How a person wants photographs to be taken: kept, told, and not told where nothing was changed.
#include "capture_ground.hpp"
#include "test_program.hpp"

#include <QLocale>
#include <QSignalSpy>

#include <map>
#include <utility>

namespace capture_choices_test {

using namespace tp;
using Guide = Choices::Guide;

class CaptureChoicesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void the_aim_is_chosen_by_its_number_and_told() {
        CaptureParts bench;
        QVERIFY(bench.choices.aim() == Aim::middle);
        for (int aim = 0; aim < bench.choices.aims().size(); ++aim) {
            bench.choices.chooseAim(aim);
            QCOMPARE(bench.choices.aim_index(), aim);
            QCOMPARE(bench.last_said(), bench.choices.aims()[aim] + '.');
        }
        bench.voice.clear();
        bench.choices.chooseAim(-1);
        bench.choices.chooseAim(static_cast<int>(bench.choices.aims().size()));
        QVERIFY(bench.voice.said().isEmpty());
        QVERIFY(bench.choices.aim() == Aim::everybody);
    }

    void whether_the_shutter_acts_by_itself_is_kept_and_told_once() {
        CaptureParts bench;
        const QSignalSpy changed(&bench.choices, &CaptureChoices::changed);
        QVERIFY(bench.choices.by_itself());
        bench.choices.setByItself(true);
        QVERIFY(bench.voice.said().isEmpty());
        bench.choices.setByItself(false);
        QVERIFY(!bench.choices.by_itself() && !bench.preferences.choices().shutter_by_itself);
        QCOMPARE(bench.last_said(),
                 QString("The photograph is taken when you press Space or touch the screen."));
        bench.choices.setByItself(true);
        QCOMPARE(bench.last_said(), QString("The photograph is taken automatically when all is well."));
        QCOMPARE(changed.size(), 2);
    }

    void whether_the_moment_is_kept_is_told_with_the_microphone() {
        CaptureParts bench;
        bench.choices.setMoment(false);
        QVERIFY(bench.voice.said().isEmpty());
        bench.choices.setMoment(true);
        QVERIFY(bench.choices.moment() && bench.preferences.choices().keep_moment);
        QVERIFY2(bench.last_said().startsWith("The microphone is on."), qPrintable(bench.last_said()));
        bench.choices.setMoment(false);
        QVERIFY2(bench.last_said().startsWith("The microphone is off."), qPrintable(bench.last_said()));
    }

    void tone_and_ticks_are_those_of_the_guide_that_was_chosen() {
        CaptureParts bench;
        const std::map<Guide, std::pair<bool, bool>> tone_and_ticks{
            {Guide::none, {false, false}},        {Guide::sonar, {true, false}},
            {Guide::clock_voice, {false, false}}, {Guide::both, {true, false}},
            {Guide::ticks, {false, true}},        {Guide::ticks_and_sonar, {true, true}}};
        for (const auto& [guide, expected] : tone_and_ticks) {
            bench.preferences.change([guide = guide](Choices& choices) { choices.guide = guide; });
            QCOMPARE(bench.choices.tone(), expected.first);
            QCOMPARE(bench.choices.ticks(), expected.second);
        }
    }
};

} // namespace capture_choices_test

TP_TEST(capture_choices_test, CaptureChoicesTest, event_loop)
#include "capture_choices_test.moc"
