// SPDX-License-Identifier: Apache-2.0
// What concerns several parts of the page at once. Each part has a test of its own.
#include "app/parts/controls/recording_announcer.hpp"
#include "explore_bench.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <QVariantMap>

namespace explore_session_test {

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
    }
    /// A place so many millimetres right of and above a feature's first point (sheet frame).
    QPointF by(int feature, double right = 0.0, double up = 0.0) const {
        return session.view()->frame().from_surface(
            session.view()->felt().lines.at(static_cast<std::size_t>(feature)).points[0] + Vec2(right, up));
    }
    /// A place left of the outline's left side.
    QPointF left_of_outline(double away) const {
        const auto& points = session.view()->felt().lines.at(outline).points;
        return session.view()->frame().from_surface(0.5 * (points[0] + points[1]) - Vec2(away, 0.0));
    }
    void down(QPointF place, int id = 0) { session.hand()->fingerDown(id, place.x(), place.y()); }
    void move(QPointF place, double later = 0.016) {
        time += later;
        session.hand()->fingerMoved(0, place.x(), place.y());
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
            session.hand()->fingerUp(i);
    }
    bool comes_to_rest() {
        QTest::qWait(40); // it is quiet
        time += RestWatch::after_s + 0.5;
        return QTest::qWaitFor([this] { return session.watch().state() == ExploreWatch::State::resting; },
                               20'000);
    }
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
};

} // namespace

class ExploreSessionTest : public QObject {
    Q_OBJECT
private slots:
    void what_was_found_is_told_and_the_force_is_on() {
        Bench bench;
        QCOMPARE(bench.session.view()->state(), ExploreView::State::Ready);
        QCOMPARE(bench.voice.said(), QStringList("One face. Eyes, mouth and outline can be felt."));
        QCOMPARE(bench.session.words()->sentence(), bench.voice.said().back());
        QVERIFY(bench.session.device()->engaged());
        QCOMPARE(bench.session.view()->featureCount(), 4);
    }

    void a_search_can_be_stopped() {
        Bench bench;
        const QString name = bench.session.view()->photoName();
        bench.session.open_file(tp::test::in_source("resources/samples/anna_smiling.jpg"));
        QCOMPARE(bench.session.view()->state(), ExploreView::State::Looking);
        bench.session.stopOrStart();
        QCOMPARE(bench.session.view()->state(), ExploreView::State::Ready); // what was open before
        QCOMPARE(bench.session.view()->photoName(), name);
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.session.words()->sentence().startsWith("Search stopped. " + name + " is open again."));
        bench.session.stopOrStart();
        QVERIFY(bench.session.device()->engaged());

        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        ExploreSounds sounds;
        ExploreSession first(narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings());
        first.open_file(tp::test::in_source("resources/samples/anna_smiling.jpg"));
        first.stopOrStart();
        PhotoLoader later; // has the same to do and began after it
        bool answered = false;
        connect(&later, &PhotoLoader::loaded, this, [&] { answered = true; });
        later.load(tp::test::in_source("resources/samples/anna_smiling.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(answered, 60000);
        QCOMPARE(first.view()->state(), ExploreView::State::Empty);
        QCOMPARE(first.words()->sentence(), QString("Search stopped. Press O to open a photograph."));
    }

    void escape_takes_the_force_away_and_gives_it_back() {
        Bench bench;
        const QPointF corner =
            bench.session.view()->frame().from_surface(bench.session.view()->felt().lines[3].points[1]);
        bench.session.hand()->touchDown(corner.x() - 5.0, corner.y() - 30.0);
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
        bench.session.stopOrStart();
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.voice.stops() > 0);
        QVERIFY(bench.voice.said().back().contains("The force is off"));
        QTRY_COMPARE(bench.session.finger()->newtons(), 0.0);
        QTest::qWait(100);
        QCOMPARE(bench.session.finger()->newtons(), 0.0);
        bench.session.stopOrStart();
        QCOMPARE(bench.voice.said().back(), QString("The force is on."));
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
    }

    void a_bad_file_is_told_and_a_good_one_opens_after_it() {
        Bench bench;
        bench.session.open_file("/nowhere/at all.jpg");
        QCOMPARE(bench.session.view()->state(), ExploreView::State::Looking);
        QCOMPARE(bench.voice.said().back(), QString("Looking for faces…"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.view()->state(), ExploreView::State::Problem, 30000);
        QVERIFY(bench.voice.said().back().contains("at all.jpg"));
        QCOMPARE(bench.session.words()->sentence(), bench.voice.said().back());
        QCOMPARE(bench.session.finger()->newtons(), 0.0);
        bench.session.open(QUrl::fromLocalFile(tp::test::in_source("resources/samples/anna_smiling.jpg")));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.view()->state(), ExploreView::State::Ready, 60000);
        QVERIFY(bench.voice.said().back().startsWith("One face."));
    }

    void only_files_are_opened() {
        Bench bench;
        bench.session.open(QUrl("https://example.org/face.jpg"));
        QVERIFY(bench.voice.said().back().contains("file on this computer"));
        QCOMPARE(bench.session.view()->state(), ExploreView::State::Ready);
    }

    void before_any_photograph_nothing_goes_wrong() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        ExploreSounds sounds;
        ExploreSession session(narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings());
        session.hand()->moveTo(10.0, 10.0);
        session.hand()->touchDown(10.0, 10.0);
        session.hand()->nudge(1.0, 1.0);
        session.hand()->goToFeature(0);
        session.zoom()->nextFace();
        session.device()->engage();
        session.stopOrStart();
        QVERIFY(!session.hand()->stepFeature(1));
        session.tour()->toggle();
        QVERIFY(voice.said().back().contains("no photograph yet"));
    }

    void a_stalled_servo_is_a_fault_that_is_spoken_and_enter_brings_the_force_back() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        ExploreSettings settings = patient_settings();
        settings.servo.limits.stall = 1e-9; // every tick is too late
        Narrator narrator(voice, announcer);
        ExploreSounds sounds;
        ExploreSession session(narrator, sounds.earcons, sounds.guide, sounds.preferences, settings);
        session.show(drawn_photo());
        QTRY_VERIFY(session.device()->faultSentence().contains("switched off"));
        QVERIFY(!session.device()->engaged());
        QCOMPARE(voice.last_priority(), Priority::fault);
        session.device()->engage();
        QVERIFY(session.device()->engaged());
        QTRY_VERIFY(!session.device()->engaged()); // still too late, so off again
    }

    void escape_silences_the_guide_until_the_next_touch() {
        Bench bench;
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.session.stop());
        QVERIFY(!bench.sounds.guide.sounds());
        bench.move(bench.left_of_outline(11.0));
        QVERIFY(!bench.sounds.guide.sounds());
        QVERIFY(!bench.session.stop()); // nothing more to stop: the shell may go home
        bench.session.hand()->fingerUp(0);
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.sounds.guide.sounds());
    }

    void out_of_sight_nothing_sounds_and_nothing_is_said() {
        Bench bench(1, {"Anna"});
        bench.voice.clear();
        bench.down(bench.by(left_eye));
        bench.session.leave();
        QVERIFY(!bench.sounds.guide.sounds());
        QVERIFY(!bench.session.device()->engaged());
        bench.stay(bench.by(left_eye), 1.0);
        bench.session.show(drawn_photo(1, {"Tom"}));
        bench.session.finger()->whereAmI();
        QCOMPARE(bench.voice.said(), QStringList());
        QVERIFY(!bench.sounds.guide.sounds());
        QVERIFY(!bench.session.device()->engaged());
        bench.session.enter();
        QVERIFY(bench.said().startsWith("Explore. Tom. One face. "));
        QVERIFY(bench.session.device()->engaged());
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
        bench.session.finger()->whereAmI();
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
        QSignalSpy changes(bench.session.view(), &ExploreView::sceneChanged);
        QCoreApplication::installTranslator(&brackets);
        QVERIFY(changes.count() > 0);
        const QVariantMap face = bench.session.view()->faces().front().toMap();
        QCOMPARE(face["name"].toString(), QString("Anna"));
        QCOMPARE(face["features"].toList().front().toMap()["name"].toString(),
                 QString("[[left eye] of Anna]"));
        QCOMPARE(bench.session.choices()->guideNames().front(), QString("[None]"));
        QCoreApplication::removeTranslator(&brackets);
        QCOMPARE(bench.session.choices()->guideNames().front(), QString("None"));
    }

    void a_person_who_switched_the_force_off_finds_it_off_again() {
        Bench bench;
        bench.session.stop();
        bench.session.leave();
        bench.session.enter();
        QVERIFY(!bench.session.device()->engaged());
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
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.said().startsWith("Stopped."));
        bench.time += 2.0;
        bench.tap(2, place);
        QVERIFY(bench.session.device()->engaged());
        QVERIFY(!bench.sounds.guide.sounds());
    }

    void escape_and_enter_act_at_rest_as_they_do_awake() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        QVERIFY(bench.session.stop());
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.comes_to_rest());
        bench.session.stopOrStart();
        QVERIFY(bench.session.device()->engaged());
        bench.down(bench.left_of_outline(2.0));
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
    }

    void a_page_that_is_left_at_rest_is_felt_when_one_comes_back() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.session.leave();
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.session.watch().state() == ExploreWatch::State::away);
        bench.session.enter();
        QVERIFY(bench.session.device()->engaged());
        QVERIFY(bench.session.watch().state() == ExploreWatch::State::watching);
        bench.down(bench.left_of_outline(2.0));
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
    }

    void a_tour_of_the_face_can_be_stopped_while_a_name_is_spoken() {
        Bench bench;
        bench.session.tour()->toggleFace();
        QVERIFY(bench.session.stop());
        QVERIFY(!bench.session.tour()->touring());
        bench.session.device()->engage();
        bench.session.tour()->toggleFace();
        bench.session.tour()->toggleFace();
        QCOMPARE(bench.said(), QString("Tour ended."));
        bench.session.tour()->toggleFace();
        bench.session.hand()->goToFeature(left_eye);
        QVERIFY(!bench.session.tour()->touring());
        bench.session.stop();
        bench.session.tour()->toggleFace();
        QVERIFY(bench.said().startsWith("The force is off."));
    }
};

} // namespace explore_session_test

TP_TEST(explore_session_test, ExploreSessionTest, event_loop)
#include "explore_session_test.moc"
