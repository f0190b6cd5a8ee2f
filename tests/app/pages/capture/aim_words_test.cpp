// SPDX-License-Identifier: Apache-2.0
// What is said while one aims, and how the tone sounds.
#include "app/pages/capture/aim_cue.hpp"
#include "app/pages/capture/aim_words.hpp"
#include "test_program.hpp"

#include <QLocale>
#include <QSet>
#include <QTest>

namespace aim_words_test {

using namespace tp;

namespace {

AimInstruction what(Advice advice, AimStep step = AimStep::some) {
    AimInstruction instruction;
    instruction.advice = advice;
    instruction.step = step;
    return instruction;
}

AimTone beats(double per_s, double side, double octaves) {
    AimTone tone;
    tone.sounds = true;
    tone.beats_per_s = per_s;
    tone.side = side;
    tone.pitch_octaves = octaves;
    return tone;
}

} // namespace

class AimWordsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void every_instruction_has_words_of_its_own() {
        QSet<QString> all;
        int count = 0;
        for (int advice = 0; advice <= static_cast<int>(Advice::ready); ++advice)
            for (const AimStep step : {AimStep::little, AimStep::some, AimStep::much}) {
                const auto one = static_cast<Advice>(advice);
                if (!AimWords::is_way(one) && step != AimStep::some)
                    continue;
                ++count;
                const QString said = AimWords::instruction(what(one, step), false);
                QVERIFY2(said.endsWith('.') && said[0].isUpper(), qPrintable(said));
                all << said;
            }
        QCOMPARE(all.size(), count);
    }

    void a_hand_hears_few_words() {
        QCOMPARE(AimWords::instruction(what(Advice::move_left, AimStep::little), false),
                 QString("A little left."));
        QCOMPARE(AimWords::instruction(what(Advice::move_left, AimStep::little), true),
                 QString("Move the tablet: a little left."));
        QCOMPARE(AimWords::instruction(what(Advice::ready), true), QString("Good. Hold still."));
    }

    void who_is_seen() {
        AimInstruction instruction;
        QCOMPARE(AimWords::people(instruction), QString());
        instruction.faces = 1;
        QVERIFY(AimWords::people(instruction).startsWith("1 face"));
        instruction.names = {"Anna"};
        QCOMPARE(AimWords::people(instruction), QString("Anna."));
        instruction.faces = 3;
        QVERIFY2(AimWords::people(instruction).startsWith("Anna and 2 more face"),
                 qPrintable(AimWords::people(instruction)));
        instruction.names.clear();
        QVERIFY(AimWords::people(instruction).startsWith("3 face"));
    }

    void two_are_named_and_of_many_no_more_than_three() {
        AimInstruction instruction;
        instruction.faces = 2;
        instruction.names = {"Anna", "Ben"};
        QCOMPARE(AimWords::people(instruction), QString("Anna and Ben."));
        instruction.faces = 6;
        instruction.names = {"Anna", "Ben", "Clara", "David", "Emma"};
        const QString many = AimWords::people(instruction);
        QVERIFY2(many.startsWith("Anna, Ben, Clara") && many.contains("3 more face") &&
                     !many.contains("David"),
                 qPrintable(many));
    }

    void the_tone_is_the_sonars() {
        const SonarCue up_right = aim_cue(beats(5.0, 1.0, highest_octaves), 0.0);
        QCOMPARE(up_right.interval_s, 0.2);
        QVERIFY(up_right.to_hz > up_right.from_hz && up_right.from_hz > level_hz);
        QCOMPARE(up_right.side, 1.0);
        QCOMPARE(up_right.reed, 0.0);
        const SonarCue down_left = aim_cue(beats(2.0, -1.0, -highest_octaves), 0.0);
        QVERIFY(down_left.to_hz < down_left.from_hz && down_left.from_hz < level_hz);
        QCOMPARE(down_left.reed, most_reed);
    }

    void it_rises_while_one_waits_for_the_picture() {
        AimTone well;
        well.sounds = well.rising = true;
        const SonarCue begins = aim_cue(well, 0.0), ends = aim_cue(well, 1.0);
        QVERIFY(begins.steady() && ends.steady());
        QVERIFY(ends.from_hz > 1.3 * begins.from_hz);
        QCOMPARE(aim_cue(well, 7.0), ends);
    }

    void under_words_it_is_softer() {
        AimTone tone = beats(5.0, 0.0, 0.0);
        const double loud = aim_cue(tone, 0.0).gain;
        tone.gain = gain_under_words;
        QVERIFY(aim_cue(tone, 0.0).gain < 0.5 * loud);
    }
};

} // namespace aim_words_test

TP_TEST(aim_words_test, AimWordsTest, event_loop)
#include "aim_words_test.moc"
