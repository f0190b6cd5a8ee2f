// SPDX-License-Identifier: Apache-2.0
// From frames to words, tone and the wish for the shutter, without a camera and in the frames' time.
#include "capture_ground.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace capture_aiming_test {

using namespace tp;
using Aimed = CaptureAiming::Aimed;
using Words = CaptureAiming::Words;

namespace {

const Vec2 at_the_right{0.85, 0.45};
const Vec2 at_the_left{0.15, 0.45};
const Vec2 middle{0.5, 0.45};

/// A camera has begun.
struct Bench : CaptureParts {
    int asked = 0; ///< how often the shutter was asked for

    explicit Bench(const Choices& choices = told()) : CaptureParts(choices) {
        QObject::connect(&aiming, &CaptureAiming::take_asked, [this] { ++asked; });
        aiming.begin({});
    }
    /// A word is over before the next frame comes, unless the voice speaks slowly.
    void see_for(double seconds, const std::vector<Vec2>& faces) {
        for (double end = time_s + seconds - 1e-6; time_s < end;) {
            aiming.see(frame(faces));
            QCoreApplication::processEvents();
        }
    }
    double loudest() {
        guide_speaker.heard.clear();
        guide_speaker.play(1.0);
        double most = 0.0;
        for (const float sample : guide_speaker.heard)
            most = std::max<double>(most, std::abs(sample));
        return most;
    }
};

} // namespace

class CaptureAimingTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void the_hand_is_told_where_to_go_whole_first_and_short_then() {
        Bench bench;
        bench.voice.clear();
        bench.see_for(0.5, {at_the_right});
        QVERIFY2(bench.last_said().startsWith("1 face") &&
                     bench.last_said().endsWith("Move the tablet: far right."),
                 qPrintable(bench.last_said()));
        bench.see_for(3.0, {at_the_left});
        QCOMPARE(bench.last_said(), QString("Far left."));
    }

    void one_thing_is_said_at_a_time() {
        Bench bench;
        bench.voice.clear();
        bench.speak_slowly();
        bench.see_for(0.5, {at_the_right});
        bench.see_for(3.0, {at_the_left});
        QCOMPARE(bench.voice.said().size(), 1);
        bench.voice.set_busy(false);
        bench.see_for(0.5, {at_the_left});
        QCOMPARE(bench.voice.said().size(), 2);
        QCOMPARE(bench.last_said(), QString("Far left."));
    }

    void advice_waits_for_other_words_and_comes_after_them() {
        Bench bench;
        bench.see_for(0.2, {middle});
        bench.voice.clear();
        bench.speak_slowly();
        bench.choices.setByItself(false);
        bench.see_for(4.0, {at_the_right});
        QCOMPARE(bench.voice.said().size(), 1);
        bench.voice.set_busy(false);
        bench.see_for(0.3, {at_the_right});
        QVERIFY2(bench.last_said().contains("far right"), qPrintable(bench.last_said()));
    }

    void the_aim_is_chosen_and_told() {
        Bench bench;
        bench.voice.clear();
        bench.choices.chooseAim(3);
        QCOMPARE(bench.last_said(), QString("Everybody in view."));
        bench.see_for(0.5, {{0.2, 0.45}, {0.4, 0.45}});
        QVERIFY2(bench.last_said().contains("left"), qPrintable(bench.last_said()));
        bench.choices.chooseAim(17);
        QCOMPARE(bench.choices.aim(), Aim::everybody);
    }

    void after_it_was_taken_nobody_is_told_to_hold_still() {
        Bench bench;
        bench.see_for(4.0, {middle});
        QVERIFY(!bench.voice.said().filter("Hold still").isEmpty());
        bench.aiming.taken();
        bench.voice.clear();
        bench.see_for(15.0, {middle});
        QVERIFY2(bench.voice.said().filter("Hold still").isEmpty(), qPrintable(bench.voice.said().join('|')));
        bench.see_for(1.0, {at_the_right});
        QVERIFY(!bench.voice.said().filter("right").isEmpty());
        bench.voice.clear();
        bench.see_for(3.0, {middle});
        QVERIFY(!bench.voice.said().filter("Hold still").isEmpty());
    }

    void the_shutter_is_asked_for_once_each_time_that_all_is_well() {
        Bench bench;
        bench.see_for(3.0, {at_the_right});
        QCOMPARE(bench.asked, 0);
        bench.see_for(4.0, {middle});
        QCOMPARE(bench.asked, 1);
        bench.see_for(0.5, {at_the_right});
        bench.see_for(4.0, {middle});
        QCOMPARE(bench.asked, 2);
        bench.see_for(0.5, {at_the_right});
        bench.choices.setByItself(false);
        bench.see_for(4.0, {middle});
        QCOMPARE(bench.asked, 2);
    }

    void of_what_was_taken_already_no_shutter_is_asked_for() {
        Bench bench;
        bench.see_for(0.6, {middle});
        bench.aiming.taken(); // by hand
        bench.see_for(4.0, {middle});
        QCOMPARE(bench.asked, 0);
    }

    void a_camera_that_begins_anew_tells_how_to_take_another_one_and_asks_for_none() {
        Bench bench;
        bench.see_for(2.0, {middle});
        QCOMPARE(bench.asked, 1);
        bench.aiming.taken();
        for (int once_more = 0; once_more < 2; ++once_more) { // the page was left, or its window hidden
            bench.aiming.end();
            bench.aiming.begin({});
            bench.voice.clear();
            bench.see_for(15.0, {middle});
            QCOMPARE(bench.asked, 1);
            QCOMPARE(bench.voice.said().size(), 1);
            QVERIFY2(bench.last_said().startsWith("1 face") &&
                         bench.last_said().endsWith(" All is well. Press Space to take another photograph."),
                     qPrintable(bench.last_said()));
        }
        bench.voice.clear();
        bench.see_for(1.5, {at_the_right}); // a camera that gets used to the light sees nothing good either
        QVERIFY(!bench.voice.said().filter("right").isEmpty()); // the hand is led as ever
        bench.see_for(2.0, {middle});
        QCOMPARE(bench.asked, 1);
        QVERIFY(bench.voice.said().filter("Hold still").isEmpty());
        bench.see_for(3.0, {at_the_right}); // from here on it is another view
        bench.see_for(2.0, {middle});
        QCOMPARE(bench.asked, 2);
        QVERIFY(!bench.voice.said().filter("Hold still").isEmpty());
    }

    void a_camera_of_the_other_side_sees_something_else() {
        Bench bench;
        bench.see_for(2.0, {middle});
        bench.aiming.taken();
        bench.aiming.begin({true, false});
        bench.see_for(2.0, {middle});
        QCOMPARE(bench.asked, 2);
        bench.aiming.taken();
        bench.aiming.begin({true, false});
        bench.see_for(2.0, {middle});
        QCOMPARE(bench.asked, 2);
    }

    void how_to_take_another_one_waits_for_other_words() {
        Bench bench;
        bench.see_for(2.0, {middle});
        bench.aiming.taken();
        bench.aiming.begin({});
        bench.speak_slowly();
        bench.teller.tell("Take a photograph.");
        bench.see_for(3.0, {middle});
        QCOMPARE(bench.last_said(), QString("Take a photograph."));
        bench.voice.set_busy(false);
        bench.see_for(0.5, {middle});
        QVERIFY2(bench.last_said().endsWith("Press Space to take another photograph."),
                 qPrintable(bench.last_said()));
        QCOMPARE(bench.asked, 1);
    }

    void what_the_hand_has_reached_goes_by_the_table() {
        Bench bench;
        const auto lead_to = [&](Aimed state) {
            bench.aiming.begin({});
            bench.see_for(3.0, {at_the_right});
            if (state != Aimed::Sought)
                bench.see_for(2.0, {middle});
            if (state == Aimed::Taken || state == Aimed::Again)
                bench.aiming.taken();
            if (state == Aimed::Again)
                bench.aiming.begin({});
            QVERIFY(bench.aiming.aimed() == state);
        };
        for (const Aimed from : {Aimed::Sought, Aimed::Reached, Aimed::Taken, Aimed::Again}) {
            lead_to(from);
            bench.see_for(0.3, {at_the_right});
            QVERIFY(bench.aiming.aimed() == (from == Aimed::Again ? Aimed::Again : Aimed::Sought));
            QVERIFY(!bench.aiming.good());
            bench.see_for(2.0, {at_the_right});
            QVERIFY(bench.aiming.aimed() == Aimed::Sought);
            lead_to(from);
            bench.see_for(2.0, {middle});
            QVERIFY(bench.aiming.aimed() == (from == Aimed::Sought ? Aimed::Reached : from));
            QVERIFY(bench.aiming.good());
            lead_to(from);
            bench.aiming.taken();
            QVERIFY(bench.aiming.aimed() == Aimed::Taken);
            lead_to(from);
            bench.aiming.begin({});
            const bool taken_before = from == Aimed::Taken || from == Aimed::Again;
            QVERIFY(bench.aiming.aimed() == (taken_before ? Aimed::Again : Aimed::Sought));
            QVERIFY(!bench.aiming.good());
        }
    }

    void a_hushed_one_is_silent_and_says_what_is_to_be_done_once_it_may() {
        Bench bench;
        bench.see_for(0.3, {at_the_right});
        QVERIFY(bench.guide.sounds());
        QVERIFY(bench.aiming.hush());
        QVERIFY(!bench.aiming.hush());
        QVERIFY(bench.aiming.words() == Words::Hushed);
        QVERIFY(!bench.guide.sounds());
        bench.voice.clear();
        bench.see_for(3.0, {at_the_left});
        QVERIFY(!bench.guide.sounds());
        QVERIFY2(bench.voice.said().isEmpty(), qPrintable(bench.last_said()));
        bench.aiming.listen();
        QVERIFY(bench.aiming.words() == Words::Owed);
        bench.see_for(0.3, {at_the_left});
        QVERIFY(bench.aiming.words() == Words::Open);
        QVERIFY(bench.guide.sounds());
        QVERIFY2(bench.last_said().contains("ar left"), qPrintable(bench.last_said()));
        bench.aiming.listen(); // it does already
        QVERIFY(bench.aiming.words() == Words::Open);
        bench.aiming.hush();
        bench.aiming.begin({});
        QVERIFY(bench.aiming.words() == Words::Open);
    }

    void advice_over_other_words_is_owed() {
        Bench bench;
        bench.speak_slowly();
        bench.teller.tell("Something else.");
        bench.see_for(3.0, {at_the_right});
        QVERIFY(bench.aiming.words() == Words::Owed);
        bench.aiming.hush();
        QVERIFY(bench.aiming.words() == Words::Hushed);
    }

    void the_tone_is_softer_under_words_and_ends_with_the_camera() {
        Bench bench;
        bench.see_for(1.0, {at_the_right});
        const double loud = bench.loudest();
        QVERIFY(loud > 0.0);
        bench.speak_slowly();
        bench.teller.tell("Something else.");
        bench.see_for(1.0, {at_the_right});
        const double soft = bench.loudest();
        QVERIFY2(soft > 0.0 && soft < 0.6 * loud, qPrintable(QString("%1 of %2").arg(soft).arg(loud)));
        QVERIFY(!bench.aiming.advice().isEmpty());
        bench.aiming.end();
        QVERIFY(!bench.guide.sounds());
        QCOMPARE(bench.aiming.advice(), QString());
    }

    void whose_face_it_is_is_told_as_soon_as_it_is_known() {
        Bench bench;
        bench.voice.clear();
        bench.see_for(0.5, {at_the_right});
        QVERIFY2(bench.last_said().startsWith("1 face"), qPrintable(bench.last_said()));
        bench.names = {"Anna"};
        bench.see_for(3.0, {middle});
        QVERIFY2(bench.voice.said().filter(QRegularExpression("^Anna\\. ")).size() == 1,
                 qPrintable(bench.voice.said().join('|')));
    }

    void two_are_named_as_far_as_they_are_known_and_only_when_that_is_news() {
        Bench bench;
        bench.choices.chooseAim(static_cast<int>(Aim::everybody));
        bench.voice.clear();
        const std::vector<Vec2> side_by_side{{0.1, 0.45}, {0.3, 0.45}};
        bench.see_for(0.5, side_by_side);
        QVERIFY2(bench.last_said().startsWith("2 face"), qPrintable(bench.last_said()));
        bench.names = {"Anna"};
        bench.see_for(3.0, side_by_side);
        bench.names = {"Anna", "Ben"};
        bench.see_for(8.0, side_by_side);
        const QStringList said = bench.voice.said();
        const auto count = [&](const QString& begin) {
            return said.filter(QRegularExpression('^' + begin)).size();
        };
        QVERIFY2(count("Anna and 1 more face") == 1 && count("Anna and Ben\\. ") == 1 && count("2 face") == 1,
                 qPrintable(said.join('|')));
        QVERIFY2(said.size() > 3 && !said.back().contains("Anna"), qPrintable(said.join('|')));
        bench.voice.clear();
        bench.aiming.tell_all();
        QVERIFY2(bench.last_said().startsWith("Anna and Ben. "), qPrintable(bench.last_said()));
    }

    void who_asks_hears_who_is_seen_and_what_to_do() {
        Bench bench;
        bench.see_for(0.5, {{0.98, 0.45}});
        bench.voice.clear();
        bench.aiming.tell_all();
        QVERIFY2(bench.last_said().endsWith("Cut off at the right edge. Move the tablet: far right."),
                 qPrintable(bench.last_said()));
    }

    void whoever_wants_no_beeps_hears_none() {
        Choices choices = CaptureGround::told();
        choices.guide = Choices::Guide::none;
        Bench bench(choices);
        bench.see_for(0.5, {at_the_right});
        QVERIFY(!bench.guide.sounds());
        QVERIFY(!bench.voice.said().isEmpty());
    }
};

} // namespace capture_aiming_test

TP_TEST(capture_aiming_test, CaptureAimingTest, event_loop)
#include "capture_aiming_test.moc"
