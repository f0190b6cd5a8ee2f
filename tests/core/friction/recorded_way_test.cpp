// SPDX-License-Identifier: Apache-2.0
// A finger's way of a million steps over a face: its ticks are the crossings that brute force finds.
#include "brute_crossings.hpp"
#include "core/friction/friction_finger.hpp"
#include "core/guidance/exact_law.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace recorded_way_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// Where a finger is each millisecond, on the lattice of a sensor with `per_mm` steps a millimetre: it goes about the face,
/// rests, and trembles by one step. The same by each compiler.
class RecordedFinger {
public:
    explicit RecordedFinger(double per_mm) : per_mm_(per_mm) {}
    Vec2 next() {
        std::normal_distribution<double> gust(0.0, 4.0);
        std::uniform_int_distribution<int> shake(-1, 1);
        if (++sample_ % 400 == 0)
            rests_ = !rests_;
        if (!rests_) {
            const double up = gust(random_), right = gust(random_);
            velocity_ = 0.98 * velocity_ + Vec2(right, up) - 0.0008 * place_;
            place_ += 0.003 * velocity_;
        }
        const int up = shake(random_), right = shake(random_);
        const Vec2 tremble(right, up);
        return (glm::round(per_mm_ * place_) + tremble) / per_mm_;
    }

private:
    double per_mm_;
    std::mt19937 random_{7};
    int sample_ = 0;
    bool rests_ = false;
    Vec2 place_{30, 30};
    Vec2 velocity_{0.0};
};

} // namespace

class RecordedWayTest : public QObject {
    Q_OBJECT
private slots:
    void ticks_are_the_crossings_of_brute_force_data() {
        QTest::addColumn<double>("per_mm");
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("steps");
        QTest::newRow("steps of a quarter of a millimetre") << 4.0 << 24 << 1'000'000;
        QTest::newRow("steps of a sixteenth, a finer face") << 16.0 << 60 << 200'000;
    }

    void ticks_are_the_crossings_of_brute_force() {
        QFETCH(double, per_mm);
        QFETCH(int, points);
        QFETCH(int, steps);
        const FlatScene face = on_lattice(face_scene(points), per_mm);
        const ExactLaw exact(face, {});
        const FrictionLaw law(face, {});
        FrictionFinger finger(law);
        const BruteCrossings brute(face, per_mm, static_cast<int>(400 * per_mm));
        RecordedFinger recorded(per_mm);
        Vec2 before = recorded.next();
        finger.step(before, {0, 0}, exact.at(before));
        std::size_t all = 0, exactly_on_a_line = 0;
        for (int i = 0; i < steps; ++i) {
            const Vec2 place = recorded.next();
            const Guidance guidance = exact.at(place);
            exactly_on_a_line += guidance.distance == 0.0 ? 1 : 0;
            const Friction friction = finger.step(place, 1000.0 * (place - before), guidance);
            std::vector<Crossed> ticks;
            for (const LineEvent& event : friction.events)
                if (event.kind == LineEventKind::crossed)
                    ticks.emplace_back(event.contour, event.segment, event.to_left);
            std::vector<Crossed> right = brute.cross(before, place);
            std::sort(ticks.begin(), ticks.end());
            std::sort(right.begin(), right.end());
            QVERIFY2(ticks == right, qPrintable(QStringLiteral("step %1").arg(i)));
            all += right.size();
            before = place;
        }
        qInfo("%zu crossings; %zu places exactly on a line", all, exactly_on_a_line);
        QVERIFY(all > std::size_t(steps) / 500 && exactly_on_a_line > std::size_t(steps) / 1250);
    }
};

} // namespace recorded_way_test

TP_TEST(recorded_way_test, RecordedWayTest, nothing)
#include "recorded_way_test.moc"
