// SPDX-License-Identifier: Apache-2.0
// What every law must keep, whatever the scene.
#include "core/guidance/corner_cue.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace laws_test {

using namespace tp;
using namespace tp::testing;

namespace {

Scene scene_of(const FlatScene& flat) {
    Scene scene{200.0, 200.0, {}};
    for (std::size_t i = 0; i < flat.lines.size(); ++i)
        scene.contours.push_back(contour_through(flat.names[i], flat.lines[i].points, flat.lines[i].closed));
    return scene;
}

} // namespace

class LawsTest : public QObject {
    Q_OBJECT
private slots:
    void force_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("blend_mm");
        QTest::addColumn<bool>("corner_cue");
        QTest::newRow("exact") << int(LawKind::exact) << 0.0 << false;
        QTest::newRow("blended") << int(LawKind::exact) << 0.5 << false;
        QTest::newRow("with corner cue") << int(LawKind::exact) << 0.0 << true;
        QTest::newRow("blended with corner cue") << int(LawKind::exact) << 0.5 << true;
        QTest::newRow("published") << int(LawKind::published) << 0.0 << false;
    }

    void force() {
        QFETCH(int, kind);
        QFETCH(double, blend_mm);
        QFETCH(bool, corner_cue);
        const Continuity continuity{0.0, blend_mm, corner_cue};
        const double most = 1.0 + (corner_cue ? CornerCueLaw::share_of_peak : 0.0);
        std::mt19937 random(8);
        const TentProfile tent;
        const double hostile[] = {
            0.0, 1e-300, 1e9, 1e308, -1e308, std::nan(""), std::numeric_limits<double>::infinity()};
        for (int round = 0; round < 100; ++round) {
            const auto made =
                make_haptic_scene(scene_of(random_scene(random)), tent, LawKind(kind), continuity);
            QVERIFY(made.ok());
            const GuidanceLaw& law = *(*made)->law;
            for (int k = 0; k < 100; ++k) {
                const Vec2 place = random_point(random);
                const Guidance at = law.at(place);
                QVERIFY(is_finite(at.force));
                QVERIFY(law.force_at(place) == at.force);
                QVERIFY(length(at.force) <= most * tent.peak() * (1.0 + 1e-12));
                QVERIFY(at.distance < tent.band() + blend_mm || at.force == Vec2(0.0));
            }
            for (const double x : hostile)
                for (const double y : hostile) {
                    QVERIFY(is_finite(law.at({x, y}).force));
                    QVERIFY(law.force_at({x, y}) == law.at({x, y}).force);
                }
        }
    }

    void each_choice_is_the_law_it_names() {
        const Scene face = scene_of(face_scene(60));
        const auto made = [&](LawKind kind, const Continuity& continuity) {
            return std::move(make_haptic_scene(face, {}, kind, continuity)).value();
        };
        const Vec2 place(-32.0, 33.0); // in an eye, where the laws differ
        const auto exact = made(LawKind::exact, {});
        const auto published = made(LawKind::published, {});
        const auto blended = made(LawKind::exact, {0.0, 0.5, false});
        const auto held = made(LawKind::exact, {0.5, 0.0, false});
        QVERIFY(std::isfinite(exact->law->at(place).energy) && std::isnan(published->law->at(place).energy));
        QVERIFY(blended->law->at({-32, 30}).force != exact->law->at({-32, 30}).force);
        QVERIFY(exact->hold_mm == 0.0 && blended->hold_mm == 0.0 && held->hold_mm == 0.5);
        QVERIFY(held->law->at(place).force == exact->law->at(place).force);
        QVERIFY(exact->flat.names == face_scene(60).names && exact->flat.lines.size() == 5);
        QVERIFY(!exact->tour);
        const auto cued = made(LawKind::exact, {0.0, 0.0, true});
        const auto* cue = dynamic_cast<const CornerCueLaw*>(cued->law.get());
        QVERIFY(cue != nullptr && cue->corner_count() >= 4);
        const TentProfile firm{0.4, 2.0};
        const auto other = std::move(make_haptic_scene(face, firm)).value();
        QVERIFY(other->profile.stiffness == 0.4 && other->profile.range == 2.0);
        QVERIFY(std::abs(length(other->law->at(Vec2(-32.0, 33.5)).force) -
                         firm.force(other->law->at(Vec2(-32.0, 33.5)).distance)) < 1e-12);
    }

    void a_scene_of_which_one_line_can_be_felt_is_felt() {
        Scene scene{200.0, 100.0, {Contour{"nothing", {}, false}}};
        QVERIFY(make_haptic_scene(scene).error().ends_with('.'));
        scene.contours.push_back(contour_through("line", {{-10, 0}, {10, 0}}, false));
        const auto made = make_haptic_scene(scene);
        QVERIFY(made.ok());
        QCOMPARE((*made)->law->at({0, 1}).contour, 1);
        QVERIFY(scene.surface().min == Vec2(-100, -50) && scene.surface().max == Vec2(100, 50));
        QVERIFY(Scene{}.surface().min == Vec2(0.0) && Scene{}.surface().max == Vec2(0.0));
    }

    void an_answer_of_nothing_pulls_nowhere() {
        const Guidance nothing;
        QVERIFY(nothing.force == Vec2(0.0) && nothing.nearest == Vec2(0.0) && nothing.contour == -1);
        QVERIFY(std::isinf(nothing.distance) && std::isnan(nothing.energy) && nothing.segment == 0);
    }

    void bad_parameters_and_empty_scenes_are_refused_in_a_sentence() {
        const Scene face = scene_of(face_scene(20));
        QVERIFY(!make_haptic_scene(face, {-1.0, 4.0}).error().empty());
        QVERIFY(!make_haptic_scene(face, {0.2, std::nan("")}).error().empty());
        QVERIFY(!make_haptic_scene(Scene{}).error().empty());
        for (const Continuity& bad : {Continuity{-1.0, 0.0, false}, Continuity{0.0, 6.0, false},
                                      Continuity{std::nan(""), 0.0, false}, Continuity{0.3, 0.3, false}})
            QVERIFY(make_haptic_scene(face, {}, LawKind::exact, bad).error().ends_with('.'));
        for (const Continuity& widest : {Continuity{5.0, 0.0, false}, Continuity{0.0, 5.0, false}})
            QVERIFY(make_haptic_scene(face, {}, LawKind::exact, widest).ok());
        for (const Continuity& other :
             {Continuity{0.3, 0.0, false}, Continuity{0.0, 0.3, false}, Continuity{0.0, 0.0, true}}) {
            QVERIFY(make_haptic_scene(face, {}, LawKind::exact, other).ok());
            QVERIFY(make_haptic_scene(face, {}, LawKind::published, other).error().ends_with('.'));
        }
        QVERIFY(law_named("exact") == LawKind::exact);
        QVERIFY(law_named("published") == LawKind::published);
        QVERIFY(!law_named("magnetic"));
    }
};

} // namespace laws_test

TP_TEST(laws_test, LawsTest, nothing)
#include "laws_test.moc"
