// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/recording_announcer.hpp"
#include "explore_bench.hpp"
#include "places.hpp"

#include <QTest>
#include <QVariantMap>

using namespace tp;

namespace {

struct Bench {
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session;

    explicit Bench(int faces = 1, std::vector<QString> names = {}, const ExploreSettings& settings = patient_settings())
        : session(narrator, sounds.earcons, sounds.guide, sounds.preferences, settings) {
        session.show(drawn_photo(faces, std::move(names)));
    }
};

constexpr int left_eye = 0;

} // namespace

class ExploreSessionTest : public QObject {
    Q_OBJECT
private slots:
    void what_was_found_is_told_and_the_force_is_on() {
        Bench bench;
        QCOMPARE(bench.session.state(), ExploreSession::State::Ready);
        QCOMPARE(bench.voice.said(), QStringList("One face. Eyes, mouth and outline can be felt."));
        QCOMPARE(bench.session.sentence(), bench.voice.said().back());
        QVERIFY(bench.session.engaged());
        QCOMPARE(bench.session.featureCount(), 4);
    }

    void extra_features_are_felt_by_those_who_asked_for_them() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        ExploreSounds sounds;
        sounds.preferences.change([](Choices& choices) { choices.nose = true; });
        ExploreSession session(narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings());
        auto photo = std::make_shared<LoadedPhoto>(*drawn_photo());
        photo->extraction.faces[0].extras = {
            contour_through(feature::nose, {{95, 80}, {100, 84}, {105, 80}}, false),
            contour_through(feature::left_brow, {{110, 50}, {120, 50}, {120, 48}}, true)};
        session.show(photo);
        QCOMPARE(voice.said(), QStringList("One face. Eyes, mouth, outline and nose can be felt."));
        QCOMPARE(session.featureCount(), 5);
        QCOMPARE(QString::fromStdString(session.felt().names.back()), QString("nose"));
        sounds.preferences.change([](Choices& choices) { choices.brows = true; }); // while it is felt
        QCOMPARE(session.featureCount(), 6);
        sounds.preferences.change([](Choices& choices) { choices.brows = choices.nose = false; });
        QCOMPARE(session.featureCount(), 4);
    }

    void a_search_can_be_stopped() {
        Bench bench;
        const QString name = bench.session.photoName();
        bench.session.open_file(tp::test::in_source("resources/samples/anna_smiling.jpg"));
        QCOMPARE(bench.session.state(), ExploreSession::State::Looking);
        bench.session.stopOrStart();
        QCOMPARE(bench.session.state(), ExploreSession::State::Ready); // what was open before
        QCOMPARE(bench.session.photoName(), name);
        QVERIFY(!bench.session.engaged());
        QVERIFY(bench.session.sentence().startsWith("Stopped looking. " + name + " is open again."));
        bench.session.stopOrStart();
        QVERIFY(bench.session.engaged());

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
        QCOMPARE(first.state(), ExploreSession::State::Empty);
        QCOMPARE(first.sentence(), QString("Stopped looking. Press O to open a photograph."));
    }

    void the_photograph_lies_under_its_lines() {
        Bench bench;
        // The left eye's centre, 15 px right of and 15 px above the middle of 200 × 150 px, centres of
        // pixels.
        const QRectF photo = bench.session.photoRect();
        const QVariantMap face = bench.session.faces().front().toMap();
        const QRectF eye = face["features"].toList().front().toMap()["rect"].toRectF();
        const QPointF share((eye.center().x() - photo.x()) / photo.width(),
                            (eye.center().y() - photo.y()) / photo.height());
        QVERIFY(std::abs(share.x() - 115.5 / 200.0) < 1e-9);
        QVERIFY(std::abs(share.y() - 60.5 / 150.0) < 1e-9);
    }

    void the_finger_is_drawn_into_the_line() {
        Bench bench;
        const QPointF corner = bench.session.frame().from_surface(bench.session.felt().lines[3].points[1]);
        const QPointF beside = corner + QPointF(-5.0, -30.0);
        bench.session.touchDown(beside.x(), beside.y());
        QTRY_VERIFY(bench.session.newtons() > 0.2);
        QTRY_VERIFY(distance_to_feature(bench.session, 3, bench.session.finger()) < 3.0);
        QCOMPARE(bench.session.pointer(), beside);
    }

    void a_feature_is_spoken_when_it_is_entered_and_not_again_while_staying() {
        Bench bench;
        bench.voice.clear();
        QVERIFY(bench.session.felt().names[left_eye] == "left_eye");
        const QPointF on = bench.session.frame().from_surface(bench.session.felt().lines[left_eye].points[0]);
        bench.session.touchDown(on.x(), on.y());
        QTRY_COMPARE(bench.voice.said(), QStringList("left eye"));
        QCOMPARE(bench.session.featureName(), QString("left eye"));
        QCOMPARE(bench.voice.last_priority(), Priority::touch);
        bench.session.moveTo(on.x() + 1.0, on.y());
        QTest::qWait(200);
        QCOMPARE(bench.voice.said(), QStringList("left eye"));
    }

    void tab_order_goes_through_the_features_and_out() {
        Bench bench;
        bench.voice.clear();
        for (int i = 0; i < 4; ++i)
            QVERIFY(bench.session.stepFeature(1));
        QVERIFY(!bench.session.stepFeature(1));
        QCOMPARE(bench.voice.said(), QStringList({"left eye", "right eye", "lips", "face outline"}));
        QVERIFY(bench.session.stepFeature(-1)); // back in from the other side
        QCOMPARE(bench.voice.said().back(), QString("face outline"));
    }

    void escape_takes_the_force_away_and_gives_it_back() {
        Bench bench;
        const QPointF corner = bench.session.frame().from_surface(bench.session.felt().lines[3].points[1]);
        bench.session.touchDown(corner.x() - 5.0, corner.y() - 30.0);
        QTRY_VERIFY(bench.session.newtons() > 0.1);
        bench.session.stopOrStart();
        QVERIFY(!bench.session.engaged());
        QVERIFY(bench.voice.stops() > 0);
        QVERIFY(bench.voice.said().back().contains("The force is off"));
        QTRY_COMPARE(bench.session.newtons(), 0.0);
        QTest::qWait(100);
        QCOMPARE(bench.session.newtons(), 0.0);
        bench.session.stopOrStart();
        QCOMPARE(bench.voice.said().back(), QString("The force is on."));
        QTRY_VERIFY(bench.session.newtons() > 0.1);
    }

    void a_tour_goes_round_the_feature_and_lets_go() {
        Bench bench;
        bench.session.goToFeature(left_eye);
        bench.session.toggleTour();
        QVERIFY(bench.session.touring());
        QCOMPARE(bench.voice.said().back(), QString("Tour round the left eye."));
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.tourProgress() > 0.5, 30000);
        QVERIFY(distance_to_feature(bench.session, left_eye, bench.session.finger()) < 3.0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.session.touring(), 60000);
        QCOMPARE(bench.voice.said().back(), QString("Tour finished."));
        QVERIFY(distance_to_feature(bench.session, left_eye, bench.session.pointer()) < 4.0); // no jump back
        QTRY_COMPARE(bench.session.featureName(), QString("left eye"));
    }

    void a_hand_that_moves_ends_the_tour_and_one_that_trembles_does_not() {
        Bench bench;
        bench.session.goToFeature(left_eye);
        bench.session.moveTo(20.0, 20.0);
        bench.session.toggleTour();
        bench.session.moveTo(22.0, 22.0);
        QVERIFY(bench.session.touring());
        bench.session.moveTo(25.0, 22.0);
        QVERIFY(!bench.session.touring());
        QCOMPARE(bench.voice.said().back(), QString("Tour ended."));
    }

    void there_is_no_tour_without_force() {
        Bench bench;
        bench.session.stopOrStart();
        bench.session.toggleTour();
        QVERIFY(!bench.session.touring());
        QVERIFY(bench.voice.said().back().contains("The force is off"));
    }

    void where_am_i_is_answered() {
        Bench bench;
        bench.session.goToFeature(left_eye);
        bench.session.whereAmI();
        QVERIFY2(bench.voice.said().back().startsWith("The face. On the left eye, at its "),
                 qPrintable(bench.voice.said().back()));
        QVERIFY(bench.voice.said().back().endsWith(" from its middle."));
    }

    void several_faces_are_felt_together_or_one_by_one() {
        Bench bench(2);
        QCOMPARE(bench.voice.said().back(),
                 QString("Two faces. Eyes, mouth and outline of each can be felt."));
        QCOMPARE(bench.session.featureCount(), 8);
        bench.session.goToFeature(5);
        QCOMPARE(bench.voice.said().back(), QString("right eye of face 2"));
        bench.session.nextFace();
        QCOMPARE(bench.voice.said().back(), QString("Zoomed to face 1."));
        QCOMPARE(bench.session.featureCount(), 4);
        QCOMPARE(bench.session.faces().size(), 2); // the other one can still be chosen
        bench.session.nextFace();
        bench.session.goToFeature(0);
        QCOMPARE(bench.voice.said().back(), QString("left eye"));
        bench.session.nextFace();
        QCOMPARE(bench.session.featureCount(), 8);
    }

    void a_bad_file_is_told_and_a_good_one_opens_after_it() {
        Bench bench;
        bench.session.open_file("/nowhere/at all.jpg");
        QCOMPARE(bench.session.state(), ExploreSession::State::Looking);
        QCOMPARE(bench.voice.said().back(), QString("Looking for faces…"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.state(), ExploreSession::State::Problem, 30000);
        QVERIFY(bench.voice.said().back().contains("at all.jpg"));
        QCOMPARE(bench.session.sentence(), bench.voice.said().back());
        QCOMPARE(bench.session.newtons(), 0.0);
        bench.session.open(QUrl::fromLocalFile(tp::test::in_source("resources/samples/anna_smiling.jpg")));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.state(), ExploreSession::State::Ready, 60000);
        QVERIFY(bench.voice.said().back().startsWith("One face."));
    }

    void only_files_are_opened() {
        Bench bench;
        bench.session.open(QUrl("https://example.org/face.jpg"));
        QVERIFY(bench.voice.said().back().contains("file on this computer"));
        QCOMPARE(bench.session.state(), ExploreSession::State::Ready);
    }

    void before_any_photograph_nothing_goes_wrong() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        ExploreSounds sounds;
        ExploreSession session(narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings());
        session.moveTo(10.0, 10.0);
        session.touchDown(10.0, 10.0);
        session.nudge(1.0, 1.0);
        session.goToFeature(0);
        session.nextFace();
        session.engage();
        session.stopOrStart();
        QVERIFY(!session.stepFeature(1));
        session.toggleTour();
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
        QTRY_VERIFY(session.faultSentence().contains("switched off"));
        QVERIFY(!session.engaged());
        QCOMPARE(voice.last_priority(), Priority::fault);
        session.engage();
        QVERIFY(session.engaged());
        QTRY_VERIFY(!session.engaged()); // still too late, so off again
    }
};

QTEST_GUILESS_MAIN(ExploreSessionTest)
#include "explore_session_test.moc"
