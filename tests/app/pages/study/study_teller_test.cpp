// SPDX-License-Identifier: Apache-2.0
// How the study page speaks: what breaks into what, what is shown, and that out of sight it is silent.
#include "app/pages/study/study_teller.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/sound/earcons.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QStringList>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace study_teller_test {

using namespace tp;

namespace {

struct Bench {
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    testing::FakeLoudspeaker speaker;
    EarconPlayer earcons{speaker};
    StudyTeller teller{narrator, earcons};
    QSignalSpy told{&teller, &StudyTeller::told};

    explicit Bench(bool here = true) { teller.set_here(here); }
    /// Whether it is the one sound since the last call.
    bool sounded(Earcon earcon) {
        speaker.play(1.0);
        std::vector<float> heard = std::exchange(speaker.heard, {});
        const auto sound = samples_of(earcon);
        const bool longer = heard.size() > sound.size();
        return longer && std::equal(sound.begin(), sound.end(), heard.begin(),
                                    [](float a, float b) { return std::abs(a - b) < 1e-4F; });
    }
    bool silent() {
        speaker.play(1.0);
        const std::vector<float> heard = std::exchange(speaker.heard, {});
        return std::ranges::all_of(heard, [](float sample) { return sample == 0.0F; });
    }
};

} // namespace

class StudyTellerTest : public QObject {
    Q_OBJECT
private slots:
    void what_the_person_waits_for_breaks_into_what_is_said_and_an_addition_does_not() {
        Bench bench;
        bench.teller.tell("Trial 1 of 4.");
        QCOMPARE(bench.voice.last_priority(), Priority::touch);
        bench.teller.add("The faces are ready.");
        QCOMPARE(bench.voice.last_priority(), Priority::message);
        QCOMPARE(bench.voice.said(), QStringList({"Trial 1 of 4.", "The faces are ready."}));
        QVERIFY(bench.silent());
    }

    void what_was_told_last_is_shown() {
        Bench bench;
        QCOMPARE(bench.teller.sentence(), QString());
        QStringList shown;
        QObject::connect(&bench.teller, &StudyTeller::told, [&] { shown << bench.teller.sentence(); });
        bench.teller.tell("Trial 1 of 4.");
        bench.teller.add("The faces are ready.");
        bench.teller.problem("Connect the device.");
        QCOMPARE(shown, QStringList({"Trial 1 of 4.", "The faces are ready.", "Connect the device."}));
        bench.teller.sound(Earcon::ready); // a sound is not shown
        QCOMPARE(bench.told.size(), 3);
    }

    void what_was_done_and_what_was_not_have_sounds_of_their_own() {
        Bench bench;
        bench.teller.did(Earcon::list_end, "That was the last trial.");
        QVERIFY(bench.sounded(Earcon::list_end));
        bench.teller.problem("Connect the device.");
        QVERIFY(bench.sounded(Earcon::error));
        bench.teller.sound(Earcon::fault);
        QVERIFY(bench.sounded(Earcon::fault));
        QCOMPARE(bench.voice.said(), QStringList({"That was the last trial.", "Connect the device."}));
        QCOMPARE(bench.voice.last_priority(), Priority::touch);
    }

    void out_of_sight_it_is_silent_and_shows_all_the_same() {
        Bench bench(false);
        bench.teller.tell("Trial 1 of 4.");
        bench.teller.problem("The trial could not be kept.");
        bench.teller.sound(Earcon::fault);
        QVERIFY2(bench.voice.said().isEmpty(), qPrintable(bench.voice.said().join('|')));
        QVERIFY(bench.silent());
        QCOMPARE(bench.teller.sentence(), QString("The trial could not be kept."));
        QCOMPARE(bench.told.size(), 2);
        bench.teller.set_here(true);
        QVERIFY(bench.voice.said().isEmpty()); // what is old is not said late
        bench.teller.tell("Paused.");
        QCOMPARE(bench.voice.said(), QStringList("Paused."));
        bench.teller.set_here(false);
        bench.teller.tell("Trial 2 of 4.");
        QCOMPARE(bench.voice.said(), QStringList("Paused."));
    }

    void it_is_hushed_when_a_trial_begins() {
        Bench bench;
        bench.teller.tell("Trial 1 of 4.");
        const int before = bench.voice.stops();
        bench.teller.hush();
        QCOMPARE(bench.voice.stops(), before + 1);
    }
};

} // namespace study_teller_test

TP_TEST(study_teller_test, StudyTellerTest, event_loop)
#include "study_teller_test.moc"
