// SPDX-License-Identifier: Apache-2.0
// The tone of the drawn finger as a participant hears it: how far the line is, on which side, and above or below.
#include "app/pages/study/study_ear.hpp"
#include "fake_loudspeaker.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace study_ear_test {

using namespace tp;

namespace {

const Vec2 finger(12.0, -17.0); ///< beside the middle, so that a place is not its way

struct Heard {
    int beeps = 0;
    double loudest = 0.0; ///< at the left ear
    double hertz = 0.0;   ///< of the first beep
};

struct Bench {
    testing::FakeLoudspeaker speaker;
    SonifiedGuide guide{speaker};
    StudyEar ear{guide};

    /// With the nearest line so far from the finger, mm, x right, y up.
    static ServoSnapshot line_at(Vec2 way) {
        ServoSnapshot seen;
        seen.contour = 0;
        seen.nearest_x = finger.x + way.x;
        seen.nearest_y = finger.y + way.y;
        seen.distance = length(way);
        return seen;
    }
    Heard hear(Vec2 way) {
        ear.silence();
        speaker.play(0.1);
        ear.hear(line_at(way), finger);
        speaker.heard.clear();
        speaker.play(2.0);
        Heard heard;
        int quiet = 1000, crossings = -1;
        std::size_t first = 0, last = 0;
        for (std::size_t i = 1; i < speaker.heard.size(); ++i) {
            const float before = speaker.heard[i - 1], now = speaker.heard[i];
            heard.beeps += std::abs(now) > 1e-5F && quiet > 200 ? 1 : 0;
            quiet = std::abs(now) > 1e-5F ? 0 : quiet + 1;
            heard.loudest = std::max<double>(heard.loudest, std::abs(now));
            if (heard.beeps == 1 && before < 0.0F && now >= 0.0F) {
                first = crossings++ < 0 ? i : first;
                last = i;
            }
        }
        if (crossings > 0)
            heard.hertz = 48000.0 * crossings / static_cast<double>(last - first);
        return heard;
    }
};

} // namespace

class StudyEarTest : public QObject {
    Q_OBJECT
private slots:
    void the_nearer_the_faster_and_on_the_line_one_tone() {
        Bench bench;
        const int far = bench.hear({20.0, 0.0}).beeps;
        const int near = bench.hear({5.0, 0.0}).beeps;
        QVERIFY2(far >= 4 && near > 2 * far, qPrintable(QString("%1, %2").arg(far).arg(near)));
        QCOMPARE(bench.hear({0.5, 0.0}).beeps, 1);
    }

    void it_comes_from_the_side_where_the_line_is() {
        Bench bench;
        const double left = bench.hear({-10.0, 0.0}).loudest;
        const double right = bench.hear({10.0, 0.0}).loudest;
        QVERIFY2(left > 1.5 * right, qPrintable(QString("%1, %2").arg(left).arg(right)));
    }

    void it_is_high_where_the_line_is_above() {
        Bench bench;
        const double above = bench.hear({0.0, 10.0}).hertz;
        const double below = bench.hear({0.0, -10.0}).hertz;
        QVERIFY2(below > 100.0 && above > 1.5 * below, qPrintable(QString("%1, %2").arg(above).arg(below)));
    }

    void where_there_is_no_line_it_is_silent() {
        Bench bench;
        bench.ear.hear(Bench::line_at({5.0, 0.0}), finger);
        QVERIFY(bench.guide.sounds());
        ServoSnapshot nothing = Bench::line_at({5.0, 0.0});
        nothing.contour = -1;
        bench.ear.hear(nothing, finger);
        QVERIFY(!bench.guide.sounds());
    }

    void it_ends_with_the_trial() {
        Bench bench;
        bench.ear.hear(Bench::line_at({5.0, 0.0}), finger);
        bench.ear.silence();
        QVERIFY(!bench.guide.sounds());
        bench.speaker.play(0.02);
        bench.speaker.heard.clear();
        bench.speaker.play(1.0);
        QVERIFY(std::ranges::all_of(bench.speaker.heard, [](float sample) { return sample == 0.0F; }));
    }
};

} // namespace study_ear_test

TP_TEST(study_ear_test, StudyEarTest, event_loop)
#include "study_ear_test.moc"
