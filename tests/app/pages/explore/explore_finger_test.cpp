// SPDX-License-Identifier: Apache-2.0
// What a finger does and hears, without waiting: the time is a variable, and each touch is answered in the call.
#include "app/parts/controls/recording_announcer.hpp"
#include "explore_bench.hpp"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <QVariant>
#include <QVariantMap>

#include <algorithm>
#include <cmath>

using namespace tp;

namespace {

constexpr int left_eye = 0;
constexpr int outline = 3;

struct Bench {
    double time = 100.0;
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session;

    explicit Bench(int faces = 1, std::vector<QString> names = {})
        : session(narrator, sounds.earcons, sounds.guide, sounds.preferences, settings_at(time)) {
        session.show(drawn_photo(faces, std::move(names)));
        voice.clear();
    }
    /// A place so many millimetres right of and above a feature's first point (sheet frame).
    QPointF by(int feature, double right = 0.0, double up = 0.0) const {
        return session.frame().from_surface(session.felt().lines.at(static_cast<std::size_t>(feature)).points[0] +
                                            Vec2(right, up));
    }
    /// A place left of the outline's left side.
    QPointF left_of_outline(double away) const {
        const auto& points = session.felt().lines.at(outline).points;
        return session.frame().from_surface(0.5 * (points[0] + points[1]) - Vec2(away, 0.0));
    }
    void down(QPointF place, int id = 0) { session.fingerDown(id, place.x(), place.y()); }
    void move(QPointF place, double later = 0.016) {
        time += later;
        session.fingerMoved(0, place.x(), place.y());
    }
    void stay(QPointF place, double seconds) {
        for (double end = time + seconds; time < end;)
            move(place, 0.01);
    }
    void tap(int fingers, QPointF place, double held = 0.1) {
        time += 0.2;
        for (int i = 0; i < fingers; ++i)
            down(place + QPointF(20.0 * i, 0.0), i);
        time += held;
        for (int i = 0; i < fingers; ++i)
            session.fingerUp(i);
    }
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
};

/// Hertz of the first beep's two halves, from rising zero crossings.
std::pair<double, double> halves_of_first_beep(const std::vector<float>& heard) {
    const auto begin = std::ranges::find_if(heard, [](float x) { return std::abs(x) > 1e-5F; });
    const auto hertz = [&](int from_ms, int to_ms) {
        int periods = -1;
        std::ptrdiff_t first = 0;
        std::ptrdiff_t last = 0;
        for (auto i = begin + from_ms * 48 + 1; i < begin + to_ms * 48; ++i)
            if (*(i - 1) < 0.0F && *i >= 0.0F) {
                last = i - begin;
                first = periods++ < 0 ? last : first;
            }
        return periods > 0 ? 48000.0 * periods / static_cast<double>(last - first) : 0.0;
    };
    return {hertz(0, 22), hertz(28, 50)};
}

} // namespace

class ExploreFingerTest : public QObject {
    Q_OBJECT
private slots:
    void a_feature_is_told_with_its_person_once_the_finger_stays() {
        Bench bench(1, {"Anna"});
        bench.down(bench.by(left_eye));
        bench.move(bench.by(left_eye), 0.140);
        QCOMPARE(bench.voice.said(), QStringList());
        bench.move(bench.by(left_eye), 0.011);
        QCOMPARE(bench.voice.said(), QStringList("left eye of Anna"));
        bench.stay(bench.by(left_eye), 2.0);
        QCOMPARE(bench.voice.said(), QStringList("left eye of Anna"));
        bench.session.fingerUp(0);
        bench.down(bench.by(left_eye)); // set down anew, it is told anew
        bench.stay(bench.by(left_eye), 0.2);
        QCOMPARE(bench.voice.said().size(), 2);
    }

    void a_finger_that_passes_over_features_hears_no_names() {
        Bench bench(1, {"Anna"});
        bench.sounds.preferences.change([](Choices& choices) { choices.guide = Choices::Guide::sonar; });
        bench.down(bench.left_of_outline(30.0));
        for (double away = 30.0; away > -30.0; away -= 3.0)
            bench.move(bench.left_of_outline(away));
        QCOMPARE(bench.voice.said(), QStringList());
    }

    void the_fingertip_counts_on_a_touchscreen_and_not_the_drawn_finger() {
        Bench bench;
        const QPointF beside = bench.left_of_outline(6.0); // the force would draw the finger nearer
        bench.down(beside);
        bench.session.whereAmI();
        QCOMPARE(bench.said(), QString("Beside the face. Face outline at 3 o'clock, 6 millimetre(s)."));
    }

    void the_sonar_begins_with_the_touch_and_ends_with_it() {
        Bench bench;
        QVERIFY(!bench.sounds.guide.sounds());
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.sounds.guide.sounds()); // in the same call: no poll was waited for
        QVERIFY(bench.sounds.guide_peak() > 0.03);
        bench.session.fingerUp(0);
        QVERIFY(!bench.sounds.guide.sounds());
        bench.sounds.guide_peak(0.02);
        QCOMPARE(bench.sounds.guide_peak(1.0), 0.0);
    }

    void the_nearer_the_faster_and_on_the_line_one_tone() {
        const auto beeps_in_two_seconds = [](double away) {
            Bench bench;
            bench.down(bench.left_of_outline(away));
            bench.sounds.guide_output.play(2.0);
            int beeps = 0;
            int quiet = 1000;
            for (const float sample : bench.sounds.guide_output.heard) {
                beeps += std::abs(sample) > 1e-5F && quiet > 200 ? 1 : 0;
                quiet = std::abs(sample) > 1e-5F ? 0 : quiet + 1;
            }
            return beeps;
        };
        const int far = beeps_in_two_seconds(20.0);
        const int near = beeps_in_two_seconds(5.0);
        QVERIFY2(far >= 4 && near > 2 * far, qPrintable(QString("%1, %2").arg(far).arg(near)));
        QCOMPARE(beeps_in_two_seconds(0.5), 1);
    }

    void a_line_above_rises_and_one_below_falls() {
        for (const double up : {-12.0, 12.0}) {
            Bench bench;
            const auto& points = bench.session.felt().lines[outline].points; // its second piece is level
            const QPointF place = bench.session.frame().from_surface(0.5 * (points[1] + points[2]) + Vec2(0.0, up));
            bench.down(place);
            bench.sounds.guide_output.play(0.2);
            const auto [first, second] = halves_of_first_beep(bench.sounds.guide_output.heard);
            QVERIFY2(up < 0.0 ? second > 1.15 * first : second < first / 1.15,
                     qPrintable(QString("%1 Hz, %2 Hz").arg(first).arg(second)));
        }
    }

    void the_guide_is_what_the_person_has_chosen() {
        Bench bench;
        const auto choose = [&](Choices::Guide guide) {
            bench.sounds.preferences.change([&](Choices& choices) { choices.guide = guide; });
        };
        choose(Choices::Guide::none);
        bench.down(bench.left_of_outline(12.0));
        bench.stay(bench.left_of_outline(12.0), 3.0);
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.voice.said(), QStringList());
        choose(Choices::Guide::clock_voice);
        bench.stay(bench.left_of_outline(12.0), 3.0);
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.voice.said(), QStringList("3 o'clock, 12 millimetre(s)"));
        choose(Choices::Guide::both);
        bench.move(bench.left_of_outline(12.0));
        QVERIFY(bench.sounds.guide.sounds());
        choose(Choices::Guide::none); // at once, though the finger does not move
        QVERIFY(!bench.sounds.guide.sounds());
    }

    void the_clock_voice_speaks_when_the_finger_rests_and_never_over_itself() {
        Bench bench;
        bench.down(bench.left_of_outline(30.0));
        double last = 0.0;
        double shortest = 1e9;
        qsizetype count = 0;
        for (int i = 0; i < 2000; ++i) { // 20 s of drifting to and fro
            bench.move(bench.left_of_outline(25.0 + 15.0 * std::sin(0.002 * i * i / 40.0)), 0.01);
            if (bench.voice.said().size() == count)
                continue;
            if (count > 0)
                shortest = std::min(shortest, bench.time - last);
            count = bench.voice.said().size();
            last = bench.time;
        }
        QVERIFY(count >= 3);
        QVERIFY2(shortest >= speech_seconds("3 o'clock, 12 millimetres"), qPrintable(QString::number(shortest)));
        QCOMPARE(bench.voice.last_priority(), Priority::touch);
    }

    void escape_silences_the_guide_until_the_next_touch() {
        Bench bench;
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.session.stop());
        QVERIFY(!bench.sounds.guide.sounds());
        bench.move(bench.left_of_outline(11.0));
        QVERIFY(!bench.sounds.guide.sounds());
        QVERIFY(!bench.session.stop()); // nothing more to stop: the shell may go home
        bench.session.fingerUp(0);
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.sounds.guide.sounds());
    }

    void out_of_sight_nothing_sounds_and_nothing_is_said() {
        Bench bench(1, {"Anna"});
        bench.down(bench.by(left_eye));
        bench.session.leave();
        QVERIFY(!bench.sounds.guide.sounds());
        QVERIFY(!bench.session.engaged());
        bench.stay(bench.by(left_eye), 1.0);
        bench.session.show(drawn_photo(1, {"Tom"}));
        bench.session.whereAmI();
        QCOMPARE(bench.voice.said(), QStringList());
        QVERIFY(!bench.sounds.guide.sounds());
        QVERIFY(!bench.session.engaged());
        bench.session.enter();
        QVERIFY(bench.said().startsWith("Explore. Tom. One face. "));
        QVERIFY(bench.session.engaged());
    }

    void a_photograph_without_a_face_is_told_on_each_entering_and_asked_for() {
        Bench bench;
        auto nothing = std::make_shared<LoadedPhoto>(*drawn_photo());
        nothing->extraction.faces.clear();
        bench.session.show(nothing);
        for (int i = 0; i < 2; ++i) {
            bench.session.leave();
            bench.session.enter();
            QCOMPARE(bench.said(), QString("Explore. No face was found in this picture."));
        }
        bench.session.whereAmI();
        QCOMPARE(bench.said(), QString("No face was found in this picture."));
        QVERIFY(!bench.session.stop());
    }

    void in_another_language_everything_has_another_name() {
        class Brackets final : public QTranslator {
            QString translate(const char*, const char* source, const char*, int) const override {
                return "[" + QString::fromUtf8(source) + "]";
            }
            bool isEmpty() const override { return false; }
        };
        Bench bench(1, {"Anna"});
        Brackets brackets;
        QSignalSpy changes(&bench.session, &ExploreSession::sceneChanged);
        QCoreApplication::installTranslator(&brackets);
        QVERIFY(changes.count() > 0);
        const QVariantMap face = bench.session.faces().front().toMap();
        QCOMPARE(face["name"].toString(), QString("Anna"));
        QCOMPARE(face["features"].toList().front().toMap()["name"].toString(), QString("[[left eye] of Anna]"));
        QCOMPARE(bench.session.guideNames().front(), QString("[None]"));
        QCoreApplication::removeTranslator(&brackets);
        QCOMPARE(bench.session.guideNames().front(), QString("None"));
    }

    void a_person_who_switched_the_force_off_finds_it_off_again() {
        Bench bench;
        bench.session.stop();
        bench.session.leave();
        bench.session.enter();
        QVERIFY(!bench.session.engaged());
    }

    void entering_a_face_leaving_it_and_crossing_a_line_are_heard() {
        Bench bench;
        bench.sounds.hears(Earcon::ready);
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(!bench.sounds.hears(Earcon::face_entered));
        bench.move(bench.left_of_outline(-10.0), 1.0);
        QVERIFY(bench.sounds.hears(Earcon::face_entered));
        bench.move(bench.left_of_outline(10.0), 1.0);
        QVERIFY(bench.sounds.hears(Earcon::face_left));
        const auto pulses = bench.sounds.vibration.pulses.size();
        bench.down(bench.by(left_eye, 5.0, 3.0));
        bench.session.fingerUp(0);
        bench.time += 1.0;
        bench.down(bench.by(left_eye, 5.0, 3.0));
        bench.sounds.hears(Earcon::face_entered);
        bench.move(bench.by(left_eye, 5.0, -3.0), 1.0);
        QVERIFY(bench.sounds.hears(Earcon::contour_crossed));
        QVERIFY(bench.sounds.vibration.pulses.size() > pulses);
    }

    void a_mouse_that_leaves_the_surface_is_silent_until_it_comes_back() {
        Bench bench;
        bench.sounds.hears(Earcon::ready);
        const QPointF eye = bench.by(left_eye, 5.0, 3.0);
        bench.session.touchDown(eye.x(), eye.y());
        bench.time += 1.0;
        const auto enters = [&] { return bench.sounds.hears(Earcon::face_entered); };
        QVERIFY(QTest::qWaitFor(enters));
        bench.session.handGone();
        bench.voice.clear();
        for (int i = 0; i < 5; ++i) {
            bench.time += 1.0;
            QTest::qWait(50); // some polls
            QVERIFY(!enters());
        }
        QCOMPARE(bench.voice.said(), QStringList());
        bench.session.moveTo(eye.x(), eye.y() - 0.5);
        bench.time += 1.0;
        QVERIFY(QTest::qWaitFor(enters));
    }

    void where_am_i_is_answered_everywhere() {
        Bench bench(1, {"Anna"});
        bench.down(bench.by(left_eye, 0.0, 6.0));
        bench.session.whereAmI();
        QCOMPARE(bench.said(), QString("Anna. Left eye at 6 o'clock, 6 millimetre(s)."));
        bench.session.fingerUp(0);
        bench.down(bench.left_of_outline(12.0));
        bench.session.whereAmI();
        QCOMPARE(bench.said(), QString("Beside Anna. Face outline at 3 o'clock, 12 millimetre(s)."));

        ExploreSounds sounds;
        ExploreSession empty(bench.narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings());
        empty.whereAmI();
        QCOMPARE(bench.said(), QString("There is no photograph yet. Press O, or the button Open photograph, to choose one."));
        empty.fingerDown(0, 50.0, 50.0);
        empty.fingerMoved(0, 60.0, 50.0);
        empty.fingerUp(0);
        QVERIFY(!sounds.guide.sounds());
    }

    void taps() {
        Bench bench;
        const QPointF place = bench.left_of_outline(20.0);
        bench.tap(3, place);
        QVERIFY(bench.said().startsWith("Beside the face. "));
        bench.voice.clear();
        bench.time += 2.0;
        bench.tap(1, place);
        bench.tap(1, place);
        QVERIFY2(bench.said().startsWith("Beside the face. "), qPrintable(bench.said()));
        bench.time += 2.0;
        bench.tap(2, place);
        QVERIFY(!bench.session.engaged());
        QVERIFY(bench.said().startsWith("Stopped."));
        bench.time += 2.0;
        bench.tap(2, place);
        QVERIFY(bench.session.engaged());
        QVERIFY(!bench.sounds.guide.sounds());
    }

    void two_taps_with_two_fingers_start_a_tour_and_end_one() {
        for (const bool engaged_before : {true, false}) {
            Bench bench;
            if (!engaged_before)
                bench.session.stop();
            bench.tap(2, bench.by(left_eye));
            bench.tap(2, bench.by(left_eye));
            QVERIFY(bench.session.touring());
            bench.time += 2.0;
            bench.tap(2, bench.by(left_eye));
            bench.tap(2, bench.by(left_eye));
            QVERIFY(!bench.session.touring());
        }
    }

    void a_second_finger_ends_exploring_until_all_are_lifted() {
        Bench bench;
        bench.down(bench.left_of_outline(10.0), 0);
        bench.down(bench.left_of_outline(40.0), 1);
        QVERIFY(!bench.sounds.guide.sounds());
        bench.move(bench.left_of_outline(5.0));
        QVERIFY(!bench.sounds.guide.sounds());
        bench.session.fingersCancelled();
        QVERIFY(bench.session.engaged()); // nothing was meant
        bench.down(bench.left_of_outline(10.0), 0);
        QVERIFY(bench.sounds.guide.sounds());
    }

    void double_tap_and_hold_zooms_to_what_is_there_and_out_where_nothing_is() {
        Bench bench(1, {"Anna"});
        bench.tap(1, bench.by(2)); // the lips
        bench.tap(1, bench.by(2), 0.8);
        QCOMPARE(bench.said(), QString("Zoomed to the mouth of Anna."));
        QCOMPARE(bench.session.featureCount(), 1);
        bench.time += 2.0;
        const QPointF corner(1.0, 1.0);
        bench.tap(1, corner);
        bench.tap(1, corner, 0.8);
        QVERIFY(bench.said().startsWith("There is nothing nearer") || bench.said().startsWith("Zoomed out"));
        bench.session.zoomOut();
        bench.time += 2.0;
        bench.tap(1, bench.left_of_outline(40.0));
        bench.tap(1, bench.left_of_outline(40.0), 0.8);
        QCOMPARE(bench.said(), QString("This is the whole picture."));
        bench.time += 2.0;
        bench.tap(1, bench.by(left_eye));
        bench.tap(1, bench.by(left_eye), 0.8);
        QCOMPARE(bench.said(), QString("Zoomed to the eyes of Anna."));
        QCOMPARE(bench.session.featureCount(), 2);
        bench.time += 2.0;
        bench.tap(1, bench.by(left_eye));
        bench.tap(1, bench.by(left_eye), 0.8);
        QCOMPARE(bench.said(), QString("Zoomed to the left eye of Anna."));
        QCOMPARE(bench.session.featureCount(), 1);
    }

    void zoom_in_and_out_by_steps() {
        Bench bench(2, {"Anna", "Tom"});
        bench.session.goToFeature(4); // Tom's
        QCOMPARE(bench.said(), QString("left eye of Tom"));
        QTRY_COMPARE(bench.session.feature(), 4);
        QVERIFY(!bench.session.zoomed());
        const QStringList wanted{"Zoomed to Tom.", "Zoomed to the eyes of Tom.", "Zoomed to the mouth of Tom.",
                                 "Zoomed out to all 2 face(s). Left eye of Tom."};
        for (const QString& sentence : wanted) {
            bench.session.zoomIn();
            QCOMPARE(bench.said(), sentence);
            QVERIFY(bench.session.engaged());
        }
        bench.session.chooseFace(0);
        QCOMPARE(bench.said(), QString("Zoomed to Anna."));
        bench.session.zoomIn();
        bench.session.zoomOut();
        QCOMPARE(bench.said(), QString("Zoomed to Anna."));
        bench.session.zoomOut();
        QCOMPARE(bench.said(), QString("Zoomed out to all 2 face(s). Left eye of Tom."));
        bench.sounds.hears(Earcon::ready);
        bench.session.zoomOut();
        QCOMPARE(bench.said(), QString("This is the whole picture."));
        QVERIFY(bench.sounds.hears(Earcon::list_end));
    }

    void what_the_hand_is_drawn_to_after_a_zoom_is_told_when_the_zoom_was() {
        QPointF beside_the_eye;
        {
            Bench before;
            before.session.zoomIn();
            beside_the_eye = before.by(left_eye, -1.5 * FeatureTracker::enter_mm);
        }
        Bench bench;
        bench.session.moveTo(beside_the_eye.x(), beside_the_eye.y());
        bench.time += 2.0;
        QTest::qWait(100); // the servo comes to rest where nothing pulls
        bench.session.zoomIn();
        QCOMPARE(bench.said(), QString("Zoomed to the eyes."));
        QTRY_COMPARE(bench.session.feature(), left_eye);
        bench.time += 0.5;
        QTest::qWait(100); // it is looked at many times meanwhile
        QCOMPARE(bench.said(), QString("Zoomed to the eyes."));
        bench.time += 10.0;
        QTRY_VERIFY((bench.time += 0.1, bench.said() == "left eye"));
    }

    void a_part_fills_the_surface_and_the_photograph_lies_under_it() {
        Bench bench;
        const double before = bench.session.photoRect().width();
        bench.session.zoomIn();
        QCOMPARE(bench.said(), QString("Zoomed to the eyes."));
        QVERIFY(bench.session.photoRect().width() > before);
        for (const Polyline& line : bench.session.felt().lines)
            for (const Vec2 point : line.points)
                QVERIFY(std::abs(point.x) <= 92.001 && std::abs(point.y) <= 67.001);
        for (const QVariant& face : bench.session.faces()) { // what a screen reader finds stays on the surface
            const QRectF rect = face.toMap()["rect"].toRectF();
            QVERIFY(QRectF(0.0, 0.0, 200.0, 150.0).contains(rect));
        }
    }

    void the_force_limit_is_the_persons_and_is_kept() {
        Bench bench;
        QCOMPARE(bench.session.maxForce(), 1.0);
        bench.session.setMaxForce(0.4);
        QCOMPARE(bench.sounds.preferences.choices().max_force_n, 0.4);
        bench.sounds.preferences.change([](Choices& choices) { choices.max_force_n = 0.2; });
        QCOMPARE(bench.session.maxForce(), 0.2);
        const auto& points = bench.session.felt().lines[outline].points;
        const QPointF beside = bench.session.frame().from_surface(0.5 * (points[0] + points[1]) + Vec2(5.0, 0.0));
        bench.session.touchDown(beside.x(), beside.y());
        QTRY_VERIFY(bench.session.newtons() > 0.1);
        QVERIFY(bench.session.newtons() <= 0.2 + 1e-9);
    }

    void the_guide_can_be_changed_by_one_key() {
        Bench bench;
        QCOMPARE(bench.session.guide(), static_cast<int>(Choices::Guide::both));
        bench.session.nextGuide();
        QCOMPARE(bench.said(), QString("Guide: None."));
        bench.session.nextGuide();
        QCOMPARE(bench.said(), QString("Guide: Sonar."));
        QCOMPARE(bench.sounds.preferences.choices().guide, Choices::Guide::sonar);
    }

    void a_tour_is_heard_where_it_is_not_felt() {
        Bench bench;
        bench.session.goToFeature(left_eye);
        bench.session.toggleTour();
        QTRY_VERIFY(bench.sounds.guide.sounds());
        QVERIFY(bench.sounds.guide_peak() > 0.02);
        bench.session.toggleTour();
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.said(), QString("Tour ended."));
    }

    void a_tour_of_the_face_names_each_feature_before_it_goes_there() {
        Bench bench;
        auto photo = std::make_shared<LoadedPhoto>(*drawn_photo());
        auto& contours = photo->extraction.faces[0].contours;
        std::erase_if(contours, [](const Contour& contour) { return contour.name == feature::outline; });
        std::erase_if(contours, [](const Contour& contour) { return contour.name == feature::right_eye; });
        bench.session.show(photo);
        bench.voice.clear();
        bench.session.toggleFaceTour();
        QVERIFY(bench.session.touring());
        QCOMPARE(bench.voice.said(), QStringList("Tour of the face: 2 feature(s). Left eye."));
        QTest::qWait(60);
        QCOMPARE(bench.session.tourProgress(), 0.0); // the name has not been spoken yet
        bench.time += 10.0;
        QTRY_VERIFY(bench.session.tourProgress() > 0.0);
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(), QString("Lips."), 60000);
        QVERIFY(bench.session.touring());
        bench.time += 10.0;
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(), QString("Tour finished."), 60000);
        QVERIFY(!bench.session.touring());
        QCOMPARE(bench.voice.said().size(), 3);
    }

    void a_tour_of_the_face_can_be_stopped_while_a_name_is_spoken() {
        Bench bench;
        bench.session.toggleFaceTour();
        QVERIFY(bench.session.stop());
        QVERIFY(!bench.session.touring());
        bench.session.engage();
        bench.session.toggleFaceTour();
        bench.session.toggleFaceTour();
        QCOMPARE(bench.said(), QString("Tour ended."));
        bench.session.toggleFaceTour();
        bench.session.goToFeature(left_eye);
        QVERIFY(!bench.session.touring());
        bench.session.stop();
        bench.session.toggleFaceTour();
        QVERIFY(bench.said().startsWith("The force is off."));
    }
};

QTEST_GUILESS_MAIN(ExploreFingerTest)
#include "explore_finger_test.moc"
