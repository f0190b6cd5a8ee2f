// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QRectF>
#include <QStringList>
#include <QTest>
#include <QVariantMap>

#include <cmath>
#include <memory>

namespace explore_view_test {

using namespace tp;

class ExploreViewTest : public QObject {
    Q_OBJECT
private slots:
    void extra_features_are_felt_by_those_who_asked_for_them() {
        ExploreParts bench(0);
        bench.sounds.preferences.change([](Choices& choices) { choices.nose = true; });
        auto photo = std::make_shared<LoadedPhoto>(*drawn_photo());
        photo->extraction.faces[0].extras = {
            contour_through(feature::nose, {{95, 80}, {100, 84}, {105, 80}}, false),
            contour_through(feature::left_brow, {{110, 50}, {120, 50}, {120, 48}}, true)};
        bench.view.show(photo);
        QCOMPARE(bench.voice.said(), QStringList("One face. Eyes, mouth, outline and nose can be felt."));
        QCOMPARE(bench.view.featureCount(), 5);
        QCOMPARE(QString::fromStdString(bench.view.felt().names.back()), QString("nose"));
        bench.sounds.preferences.change([](Choices& choices) { choices.brows = true; }); // while it is felt
        QCOMPARE(bench.view.featureCount(), 6);
        bench.sounds.preferences.change([](Choices& choices) { choices.brows = choices.nose = false; });
        QCOMPARE(bench.view.featureCount(), 4);
    }

    void the_photograph_lies_under_its_lines() {
        ExploreParts bench;
        // The left eye's centre, 15 px right of and 15 px above the middle of 200 × 150 px, centres of
        // pixels.
        const QRectF photo = bench.view.photoRect();
        const QVariantMap face = bench.view.faces().front().toMap();
        const QRectF eye = face["features"].toList().front().toMap()["rect"].toRectF();
        const QPointF share((eye.center().x() - photo.x()) / photo.width(),
                            (eye.center().y() - photo.y()) / photo.height());
        QVERIFY(std::abs(share.x() - 115.5 / 200.0) < 1e-9);
        QVERIFY(std::abs(share.y() - 60.5 / 150.0) < 1e-9);
    }

    void from_nothing_to_looking_and_back_by_giving_up() {
        using State = ExploreView::State;
        const QString file = tp::test::in_source("resources/samples/anna_smiling.jpg");
        ExploreParts bench(0);
        QCOMPARE(bench.view.state(), State::Empty);
        bench.view.load(file);
        QCOMPARE(bench.view.state(), State::Looking);
        QCOMPARE(bench.said(), QString("Looking for faces…"));
        QCOMPARE(bench.view.give_up(), QString("Search stopped. Press O to open a photograph."));
        QCOMPARE(bench.view.state(), State::Empty);
        bench.view.show(drawn_photo());
        bench.view.load(file);
        QCOMPARE(bench.view.featureCount(), 0);
        QVERIFY(
            bench.view.give_up().startsWith("Search stopped. drawn.png is open again. The force is off."));
        QCOMPARE(bench.view.state(), State::Ready);
        auto nothing = std::make_shared<LoadedPhoto>(*drawn_photo());
        nothing->extraction.faces.clear();
        nothing->extraction.problem = "No face was found in this picture.";
        bench.view.show(nothing);
        QCOMPARE(bench.view.state(), State::Problem);
        QCOMPARE(bench.view.where_one_is(), QString("No face was found in this picture."));
        bench.view.load(file);
        QCOMPARE(bench.view.give_up(), QString("Search stopped. drawn.png is open again."));
        QCOMPARE(bench.view.state(), State::Problem);
    }

    void who_counts_features_hears_of_another_scene_before_it_is_shown() {
        ExploreParts bench;
        QStringList heard;
        connect(&bench.view, &ExploreView::replacing, this, [&] { heard << "replacing"; });
        connect(&bench.view, &ExploreView::replaced, this, [&] { heard << "replaced"; });
        connect(&bench.view, &ExploreView::sceneChanged, this, [&] { heard << "shown"; });
        connect(&bench.view, &ExploreView::fresh, this, [&] { heard << "fresh"; });
        bench.view.show(drawn_photo(2));
        QCOMPARE(heard, QStringList({"replacing", "replaced", "shown", "fresh"}));
        heard.clear();
        QVERIFY(bench.view.fit({1, FacePart::eyes}));
        QCOMPARE(heard, QStringList({"replacing", "replaced", "shown"}));
        heard.clear();
        QVERIFY(!bench.view.fit({7, FacePart::eyes})); // there is none
        QCOMPARE(heard, QStringList());
        QVERIFY(bench.view.subject() == Subject({1, FacePart::eyes}));
    }

    void people_are_named_and_features_with_them() {
        ExploreParts bench(2, {"Anna", ""});
        QCOMPARE(bench.view.title(), QString("Anna"));
        QCOMPARE(bench.view.name_of_face(0), QString("Anna"));
        QCOMPARE(bench.view.name_of_face(1), QString("face 2"));
        QCOMPARE(bench.view.label_of(0), QString("left eye of Anna"));
        QCOMPARE(bench.view.label_of(4), QString("left eye of face 2"));
        QCOMPARE(bench.view.label_of(-1), QString());
        QCOMPARE(bench.view.label_of(99), QString());
        bench.view.show(drawn_photo());
        QCOMPARE(bench.view.title(), QString("drawn.png"));
        QCOMPARE(bench.view.name_of_face(0), QString("the face"));
        QCOMPARE(bench.view.faces().front().toMap()["name"].toString(), QString("face"));
    }

    void it_lies_where_a_device_reaches() {
        ExploreParts bench;
        const QRectF before = bench.view.photoRect();
        bench.view.reach({{-60.0, -30.0}, {60.0, -30.0}, {60.0, 30.0}, {-60.0, 30.0}});
        QVERIFY(bench.view.photoRect().height() < 0.5 * before.height());
        bench.view.reach({});
        QCOMPARE(bench.view.photoRect(), before);
    }
};

} // namespace explore_view_test

TP_TEST(explore_view_test, ExploreViewTest, event_loop)
#include "explore_view_test.moc"
