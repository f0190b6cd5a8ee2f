// SPDX-License-Identifier: Apache-2.0
// What is seen across a line, by pictures and profiles of which it can be reckoned by hand.
#include "faces/edges/edge_profile.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace tp;

namespace {

using Points = std::vector<Vec2>;
const Vec2 down(0.0, 1.0);

constexpr double step_percent = 0.2;

/// Grows by a grey level a pixel to the right and downwards; green is 10 levels above blue, red 20.
cv::Mat slope(int width, int height) {
    cv::Mat picture(height, width, CV_8UC3);
    picture.forEach<cv::Vec3b>([](cv::Vec3b& pixel, const int* place) {
        const int level = place[0] + place[1];
        pixel = {cv::saturate_cast<uchar>(level), cv::saturate_cast<uchar>(level + 10),
                 cv::saturate_cast<uchar>(level + 20)};
    });
    return picture;
}

/// Brightness and redness of that picture at a place; beyond its left and its upper border those of the border.
std::array<double, edge_channels> tone_at(Vec2 place) {
    const double blue = std::max(0.0, place.x - 0.5) + std::max(0.0, place.y - 0.5);
    const double grey = blue + 0.587 * 10.0 + 0.299 * 20.0;
    return {std::log(grey + 16.0), std::log((blue + 36.0) / (blue + 26.0))};
}

/// Three points, of which the middle one sees `tone` at so many percent outwards, in the first channel or the second.
template <typename Tone>
Evidence seen(Tone tone, std::size_t channel, const EdgeLook& look) {
    EdgeProfile profile = edge_profile(cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(100)),
                                       Points{{1, 4}, {4, 4}, {7, 4}}, down, 100.0);
    const std::size_t samples = profile.channels[channel].size() / profile.points;
    for (auto& values : profile.channels)
        std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t s = 0; s < samples; ++s) {
        const double steps = static_cast<double>(s) - 0.5 * static_cast<double>(samples - 1);
        profile.channels[channel][samples + s] = tone(steps * step_percent);
    }
    return evidence_in(profile, look);
}

} // namespace

class EdgeProfileTest : public QObject {
    Q_OBJECT
private slots:
    void a_line_has_normals_of_length_one_on_its_outer_side() {
        const Points corner{{0, 0}, {4, 0}, {4, 4}};
        const auto normals = normals_of(corner, {-1, 1});
        QVERIFY(length(normals[0] - Vec2(0, 1)) < 1e-12);
        QVERIFY(length(normals[1] - Vec2(-1, 1) / std::sqrt(2.0)) < 1e-12);
        QVERIFY(length(normals[2] - Vec2(-1, 0)) < 1e-12);
        const auto other = normals_of(corner, {1, -1});
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(other[i] == -normals[i]);
        QVERIFY(normals_of({{2, 2}, {2, 2}}, down)[1] == Vec2(0.0)); // it stands still
    }

    /// Points of the picture itself, and of what is left of it where a step is two pixels long.
    void a_picture_is_seen_at_every_fifth_of_a_percent_data() {
        QTest::addColumn<double>("unit");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("apart");
        QTest::addColumn<double>("y");
        QTest::newRow("a pixel a step") << 500.0 << 20.25 << 18.0 << 60.3;
        QTest::newRow("beyond the upper border") << 500.0 << 20.25 << 18.0 << 10.3;
        QTest::newRow("half a pixel a step") << 250.0 << 20.25 << 18.0 << 60.3;
        QTest::newRow("two pixels a step") << 1000.0 << 10.25 << 4.0 << 101.3;
    }
    void a_picture_is_seen_at_every_fifth_of_a_percent() {
        QFETCH(double, unit);
        QFETCH(double, x);
        QFETCH(double, apart);
        QFETCH(double, y);
        Points line;
        for (int i = 0; i < 5; ++i)
            line.emplace_back(x + apart * i, y);
        const EdgeProfile profile = edge_profile(slope(220, 220), line, down, unit);
        QCOMPARE(profile.points, std::size_t{5});
        const std::size_t samples = profile.channels[0].size() / 5;
        for (std::size_t i = 1; i < 4; ++i)
            for (std::size_t s = 1; s + 1 < samples;
                 ++s) { // the outermost may be at the border of what is looked at
                const double steps = static_cast<double>(s) - 0.5 * static_cast<double>(samples - 1);
                const Vec2 outwards(0.0, steps * step_percent * unit / 100.0);
                for (std::size_t c = 0; c < edge_channels; ++c) {
                    const double expected = 0.5 * tone_at(line[i] + outwards)[c] +
                                            0.25 * tone_at(line[i - 1] + outwards)[c] +
                                            0.25 * tone_at(line[i + 1] + outwards)[c];
                    const double found = profile.channels[c][i * samples + s];
                    QVERIFY2(std::abs(found - expected) < 1e-9,
                             qPrintable(QString("%1 for %2 at %3").arg(found).arg(expected).arg(steps)));
                }
            }
        for (std::size_t c = 0; c < edge_channels; ++c)
            for (std::size_t s = 0; s < samples; ++s) { // a corner has no normal
                QCOMPARE(profile.channels[c][s], 0.0);
                QCOMPARE(profile.channels[c][4 * samples + s], 0.0);
            }
    }

    /// A third of a pixel would change nothing; fifty pixels would leave nothing.
    void grain_is_taken_away_where_that_makes_sense_data() {
        QTest::addColumn<double>("grain_px");
        QTest::addColumn<bool>("taken");
        QTest::newRow("none") << 0.0 << false;
        QTest::newRow("too fine") << 0.28 << false;
        QTest::newRow("fine") << 0.32 << true;
        QTest::newRow("coarse") << 48.0 << true;
        QTest::newRow("too coarse") << 52.0 << false;
    }
    void grain_is_taken_away_where_that_makes_sense() {
        QFETCH(double, grain_px);
        QFETCH(bool, taken);
        cv::Mat picture(100, 100, CV_8UC3);
        picture.forEach<cv::Vec3b>([](cv::Vec3b& pixel, const int* place) {
            pixel = cv::Vec3b::all((place[0] + place[1]) % 2 == 0 ? 40 : 200);
        });
        const Points line{{30.5, 50.5}, {50.5, 50.5}, {70.5, 50.5}};
        const auto sharp = edge_profile(picture, line, down, 500.0);
        const auto seen = edge_profile(picture, line, down, 500.0, grain_px / 5.0);
        QCOMPARE(sharp.channels[0] != seen.channels[0], taken);
    }

    /// A slope counts by how much it rises over one deviation, a bend by its second derivative times the variance.
    void a_slope_and_a_bend_count_as_the_looks_say_data() {
        QTest::addColumn<int>("channel");
        QTest::newRow("brightness") << 0;
        QTest::newRow("redness") << 1;
    }
    void a_slope_and_a_bend_count_as_the_looks_say() {
        QFETCH(int, channel);
        const auto look = [&](const ChannelLook& here) {
            return channel == 0 ? EdgeLook{here, {}, 0.0, 0.0} : EdgeLook{{}, here, 0.0, 0.0};
        };
        const auto c = static_cast<std::size_t>(channel);
        const auto rising = [](double at) { return 3.0 * at; };
        const auto bent = [](double at) { return 3.0 * at * at; };
        const auto flat = [](double) { return 3.0; };
        const auto near = [](double found, double expected, double tolerance) {
            return std::abs(found - expected) <= tolerance * std::abs(expected) + 1e-9;
        };
        const Evidence said = seen(rising, c, look({2.0, 0.0, 0.0, 0.0}));
        QCOMPARE(said.points, std::size_t{3});
        QCOMPARE(said.offsets, std::size_t{51});
        QCOMPARE(said.offset(50), 5.0);
        QCOMPARE(said.offset(25), 0.0);
        for (std::size_t k = 0; k < said.offsets; ++k) {
            const double at = said.offset(k);
            const auto value = [&](const Evidence& evidence) { return evidence.at(1, k); };
            QVERIFY(near(value(said), 2.0 * 3.0 * 0.5, 1e-6));
            QVERIFY(near(value(seen(rising, c, look({0.0, 0.0, 2.0, 0.0}))), 2.0 * 3.0 * 1.3, 0.01));
            QVERIFY(near(value(seen(bent, c, look({0.0, 2.0, 0.0, 0.0}))), 2.0 * 6.0 * 0.25, 1e-6));
            if (at == 0.0) // further out what is left away of the wide Gaussian counts
                QVERIFY(near(value(seen(bent, c, look({0.0, 0.0, 0.0, 2.0}))), 2.0 * 6.0 * 1.69, 0.05));
            QVERIFY(near(value(seen(bent, c, look({2.0, 0.0, 0.0, 0.0}))), 2.0 * 6.0 * at * 0.5, 1e-6));
            QVERIFY(near(value(seen(flat, c, look({2.0, 2.0, 2.0, 0.0}))), 0.0, 1e-6));
            QVERIFY(near(value(seen(rising, 1 - c, look({2.0, 2.0, 2.0, 2.0}))), 0.0, 0.0));
            QCOMPARE(said.at(0, k), 0.0);
            QCOMPARE(said.at(2, k), 0.0);
        }
    }
};

QTEST_GUILESS_MAIN(EdgeProfileTest)
#include "edge_profile_test.moc"
