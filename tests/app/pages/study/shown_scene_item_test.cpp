// SPDX-License-Identifier: Apache-2.0
// What a researcher sees who tries an experiment out; and that a participant sees nothing.
#include "app/pages/study/shown_scene_item.hpp"
#include "drawn_item.hpp"
#include "study_parts.hpp"
#include "test_program.hpp"

#include <QTest>

namespace shown_scene_item_test {

using namespace tp;
using namespace tp::testing;

namespace {

const QColor line(240, 240, 255), fingertip(255, 150, 0);
constexpr double scale = 3.0; ///< px/mm

struct Bench : StudyParts {
    DrawnItem<ShownSceneItem> drawn{{600, 480}};

    explicit Bench(bool tries_out) {
        drawn.set("pixelsPerMm", scale);
        drawn.set("lineColor", line);
        drawn.set("fingerColor", fingertip);
        drawn.item.setRun(sitting.get());
        StudyPlan plan = this->plan(shapes);
        plan.show_scene = tries_out;
        run().begin(plan);
        run().agree();
        opened();
    }
    ~Bench() override { drawn.item.setRun(nullptr); }
    /// Surface → item.
    static QPoint pixel(Vec2 place) {
        return {static_cast<int>(300.0 + scale * place.x), static_cast<int>(240.0 - scale * place.y)};
    }
};

} // namespace

class ShownSceneItemTest : public QObject {
    Q_OBJECT
private slots:
    void lines_and_finger_are_where_they_are() {
        Bench bench(true);
        QImage seen = bench.drawn.picture();
        for (const Polyline& felt : bench.run().shown()->lines)
            for (std::size_t i = 0; i < felt.segment_count(); ++i) {
                const QPoint place = Bench::pixel(0.5 * (felt.points[i] + felt.segment_end(i)));
                if ((place - Bench::pixel(bench.run().shown_finger())).manhattanLength() > 20)
                    QVERIFY(is_near(seen.pixelColor(place), line));
            }
        const auto finger_at = [&](Vec2 place) {
            const QRect there = extent_of(bench.drawn.picture(), fingertip);
            return (there.center() - Bench::pixel(place)).manhattanLength() < 4 &&
                   std::abs(there.width() - 18) < 3;
        };
        QVERIFY(finger_at(bench.run().shown_finger()));
        bench.run().goOn();
        seen = bench.drawn.picture();
        bench.run().move_by({20.0, 12.0});
        bench.pass(1.0); // it is drawn anew as it goes
        QVERIFY(finger_at(bench.finger.place()) && bench.drawn.picture() != seen);
        bench.run().goOn();
        QCOMPARE(bench.run().state(), StudyRun::State::Answering);
        QVERIFY(extent_of(bench.drawn.picture(), line).isEmpty()); // there is nothing to feel now
        bench.drawn.item.setRun(nullptr);
        QVERIFY(extent_of(bench.drawn.picture(), fingertip).isEmpty());
    }

    void another_size_is_drawn_anew() {
        Bench bench(true);
        const int before = extent_of(bench.drawn.picture(), line).width();
        bench.drawn.set("pixelsPerMm", 0.5 * scale);
        QVERIFY(std::abs(extent_of(bench.drawn.picture(), line).width() - before / 2) < 6);
    }

    void a_participant_sees_nothing() {
        Bench bench(false);
        bench.run().goOn();
        bench.pass(0.1);
        const QImage seen = bench.drawn.picture();
        QVERIFY(extent_of(seen, line).isEmpty() && extent_of(seen, fingertip).isEmpty());
    }
};

} // namespace shown_scene_item_test

TP_TEST(shown_scene_item_test, ShownSceneItemTest, window)
#include "shown_scene_item_test.moc"
