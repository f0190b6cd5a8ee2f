// SPDX-License-Identifier: Apache-2.0
// What is seen of the lines that are felt: where they lie, with an edge, and the one under the finger brighter and wider.
#include "app/pages/explore/contours_item.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "drawn_item.hpp"
#include "explore_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstddef>

namespace contours_item_test {

using namespace tp;
using namespace tp::testing;

namespace {

const QColor line(240, 240, 255), edge(0, 0, 0), highlight(255, 220, 0);
constexpr double scale = 4.0; ///< px/mm
constexpr int lips = 2;

struct Bench {
    double time = 100.0;
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session{narrator, sounds.earcons, sounds.guide, sounds.preferences, settings_at(time)};
    DrawnItem<ContoursItem> drawn{{static_cast<int>(scale * session.view()->surfaceWidth()),
                                   static_cast<int>(scale* session.view()->surfaceHeight())}};

    Bench() {
        drawn.set("pixelsPerMm", scale);
        drawn.set("lineColor", line);
        drawn.set("edgeColor", edge);
        drawn.set("highlightColor", highlight);
        drawn.item.setSession(&session);
    }
    ~Bench() { drawn.item.setSession(nullptr); }
    /// The middle of a feature's first piece, which is level.
    QPoint on(int feature) {
        const auto& points = session.view()->felt().lines.at(static_cast<std::size_t>(feature)).points;
        return (scale * session.view()->frame().from_surface(0.5 * (points[0] + points[1]))).toPoint();
    }
    /// Rows of a colour across the line there.
    int width_at(QPoint place, const QColor& colour) {
        return rows_of(drawn.picture(), place.x(), colour, place.y() - 12, place.y() + 12);
    }
};

} // namespace

class ContoursItemTest : public QObject {
    Q_OBJECT
private slots:
    void lines_lie_where_they_are_felt_and_stand_out_on_any_photograph() {
        Bench bench;
        QVERIFY(extent_of(bench.drawn.picture(), line).isEmpty()); // there is no photograph
        bench.session.show(drawn_photo());
        const QImage seen = bench.drawn.picture();
        for (const int feature : {0, 1, lips}) {
            const QPoint place = bench.on(feature);
            QVERIFY(bench.width_at(place, line) >= 1);
            const auto darkest = [&](int from, int to) {
                int least = 255;
                for (int y = from; y <= to; ++y)
                    least = std::min(least, seen.pixelColor(place + QPoint(0, y)).green());
                return least;
            };
            QVERIFY(darkest(-4, -1) < 40 && darkest(1, 4) < 40); // the ground has 60
            QVERIFY(is_near(seen.pixelColor(place - QPoint(0, 8)), bench.drawn.ground));
        }
        QVERIFY(extent_of(seen, highlight).isEmpty());
    }

    void a_closed_line_is_closed() {
        Bench bench;
        bench.session.show(drawn_photo());
        const auto& lip = bench.session.view()->felt().lines.at(lips);
        QVERIFY(lip.closed);
        const Vec2 last =
            0.5 * (lip.points.back() + lip.points.front()); // of its last piece, which is upright
        const QPoint place = (scale * bench.session.view()->frame().from_surface(last)).toPoint();
        const QImage seen = bench.drawn.picture();
        QVERIFY(is_near(seen.pixelColor(place), line) ||
                is_near(seen.pixelColor(place - QPoint(1, 0)), line));
    }

    void the_one_under_the_finger_is_brighter_and_wider_until_it_goes_on() {
        Bench bench;
        bench.session.show(drawn_photo());
        QVERIFY(bench.width_at(bench.on(lips), line) <= 2);
        bench.session.hand()->goToFeature(lips);
        QCOMPARE(bench.session.finger()->feature(), lips);
        QCOMPARE(bench.width_at(bench.on(lips), line), 0);
        QVERIFY(bench.width_at(bench.on(lips), highlight) >= 3);
        QVERIFY(bench.width_at(bench.on(0), line) >= 1);
        bench.session.hand()->goToFeature(0);
        QCOMPARE(bench.width_at(bench.on(lips), highlight), 0);
        QVERIFY(bench.width_at(bench.on(0), highlight) >= 3);
    }

    void another_size_of_the_surface_is_drawn_anew() {
        Bench bench;
        bench.session.show(drawn_photo());
        const QRect before = extent_of(bench.drawn.picture(), line);
        bench.drawn.set("pixelsPerMm", 0.5 * scale);
        const QRect after = extent_of(bench.drawn.picture(), line);
        QVERIFY(std::abs(after.width() - 0.5 * before.width()) < 4 && after.left() < before.left());
        bench.drawn.item.setSession(nullptr);
        QVERIFY(extent_of(bench.drawn.picture(), line).isEmpty());
    }
};

} // namespace contours_item_test

TP_TEST(contours_item_test, ContoursItemTest, window)
#include "contours_item_test.moc"
