// SPDX-License-Identifier: Apache-2.0
// Of a burst the one is kept that is sharp, with eyes open, everybody in.
#include "app/capture/frames/photo_view.hpp"
#include "app/capture/shutter/burst.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace burst_test {

using namespace tp;

namespace {

using Frames = std::vector<std::size_t>;

cv::Mat anna() { return *read_picture(test::in_source("resources/samples/anna_smiling.jpg")); }

cv::Mat view(const cv::Mat& photo, const HeldPose& pose = {}) {
    return view_of(photo, {0.6, 1.0, {0.5, 0.45}}, pose, {}, {}, {});
}

CameraFrame frame_at(double time_s, cv::Mat pixels = {}) {
    CameraFrame frame;
    frame.pixels = std::move(pixels);
    frame.time_s = time_s;
    return frame;
}

cv::Mat blurred(const cv::Mat& picture) {
    cv::Mat soft;
    cv::GaussianBlur(picture, soft, {}, 4.0);
    return soft;
}

std::vector<double> times_of(const Burst& burst) {
    std::vector<double> times;
    for (std::size_t i = 0; i < burst.size(); ++i)
        times.push_back(burst.frame(i).time_s);
    return times;
}

} // namespace

class BurstTest : public QObject {
    Q_OBJECT
private slots:
    void a_packed_one_is_what_would_be_kept() {
        for (const bool mirrored : {false, true}) {
            const Burst burst({frame_at(0.0, view(anna(), {.pan_deg = 5.0})), frame_at(0.1, view(anna()))},
                              {mirrored, mirrored}, 0.1);
            const Burst packed = burst.packed();
            QCOMPARE(times_of(packed), times_of(burst));
            QCOMPARE(packed.wished(), burst.wished());
            for (std::size_t i = 0; i < burst.size(); ++i) {
                QVERIFY(packed.frame(i).pixels.empty());
                QVERIFY(!burst.frame(i).pixels.empty());
                QVERIFY(packed.coded(i)->jpeg == burst.coded(i)->jpeg);
                const cv::Mat before = burst.picture(i), after = packed.picture(i);
                QCOMPARE(after.size(), before.size());
                QVERIFY(cv::norm(after, before, cv::NORM_L1) / static_cast<double>(before.total() * 3) < 2.0);
                QVERIFY(10 * packed.coded(i)->jpeg.size() < before.total() * before.elemSize());
            }
            QVERIFY(packed.packed().coded(1)->jpeg == packed.coded(1)->jpeg);
        }
    }

    void what_cannot_be_packed_stays_as_it_is() {
        const Burst burst({frame_at(0.0, view(anna())), frame_at(0.1)}, {}, 0.0);
        const Burst packed = burst.packed();
        QVERIFY(!packed.picture(0).empty() && packed.picture(1).empty());
        QCOMPARE(packed.frame(0).pixels.data, burst.frame(0).pixels.data);
    }

    void one_frame_is_kept_and_none_is_none() {
        QVERIFY(order_of({}, 0).frames.empty());
        const BurstOrder one = order_of({{1, 1, {}}}, 0);
        QCOMPARE(one.frames, Frames{0});
        QVERIFY(one.why == BurstReason::only);
    }

    void what_matters_most_decides_data() {
        QTest::addColumn<std::vector<BurstLook>>("looks");
        QTest::addColumn<Frames>("order");
        QTest::addColumn<int>("why");
        const auto row = [](const char* name, const std::vector<BurstLook>& looks, const Frames& order,
                            BurstReason why) {
            QTest::newRow(name) << looks << order << static_cast<int>(why);
        };
        row("a smeared one is last, whatever else it shows", {{2, 0, 0.01}, {1, 1, 0.04}}, {1, 0},
            BurstReason::not_blurred);
        row("everybody before eyes", {{1, 0, 0.04}, {2, 1, 0.03}}, {1, 0}, BurstReason::everybody);
        row("eyes before the last bit of sharpness", {{1, 1, 0.04}, {1, 0, 0.03}}, {1, 0},
            BurstReason::eyes_open);
        row("then the sharper one", {{1, 0, 0.030}, {1, 0, 0.04}, {1, 0, 0.02}}, {1, 0, 2},
            BurstReason::sharper);
        row("alike: the shutter's, and then the nearest",
            {{1, 0, 0.04}, {1, 0, 0.0401}, {1, 0, 0.0399}, {1, 0, 0.04}}, {1, 0, 2, 3}, BurstReason::alike);
        row("nothing to see", {{}, {}}, {1, 0}, BurstReason::alike);
        row("plain ones after what can be seen", {{0, 0, {}}, {0, 0, 0.02}}, {1, 0},
            BurstReason::not_blurred);
    }
    void what_matters_most_decides() {
        QFETCH(const std::vector<BurstLook>, looks);
        QFETCH(const Frames, order);
        QFETCH(const int, why);
        const BurstOrder chosen = order_of(looks, 1);
        QCOMPARE(chosen.frames, order);
        QCOMPARE(static_cast<int>(chosen.why), why);
    }

    void the_best_is_the_best_in_whatever_order_they_come() {
        const std::vector<BurstLook> looks{{2, 0, 0.04}, {2, 1, 0.04}, {1, 0, 0.04}, {2, 0, 0.03},
                                           {2, 0, 0.01}, {0, 0, {}},   {1, 1, 0.02}, {2, 2, 0.035}};
        Frames places{0, 1, 2, 3, 4, 5, 6, 7};
        std::mt19937 random(5);
        for (int i = 0; i < 50; ++i) {
            std::shuffle(places.begin(), places.end(), random);
            std::vector<BurstLook> mixed;
            for (const std::size_t place : places)
                mixed.push_back(looks[place]);
            const BurstOrder order = order_of(mixed, 3);
            QCOMPARE(places[order.frames.front()], std::size_t{0});
            Frames sorted = order.frames;
            std::sort(sorted.begin(), sorted.end());
            QCOMPARE(sorted, (Frames{0, 1, 2, 3, 4, 5, 6, 7}));
        }
    }

    void at_most_eight_are_held_those_round_the_shutter() {
        std::vector<CameraFrame> frames;
        for (int i = 11; i >= 0; --i)
            frames.push_back(frame_at(i));
        const Burst burst(frames, {}, 8.2);
        QCOMPARE(times_of(burst), (std::vector<double>{4, 5, 6, 7, 8, 9, 10, 11}));
        QCOMPARE(burst.wished(), std::size_t{4});
        QCOMPARE(times_of(Burst(frames, {}, -3.0)), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}));
        QCOMPARE(Burst({}, {}, 0.0).size(), std::size_t{0});
    }

    void a_mirrored_cameras_picture_is_turned_back() {
        cv::Mat pixels(2, 3, CV_8UC3, cv::Scalar(0, 0, 0));
        pixels.at<cv::Vec3b>(0, 0) = {9, 8, 7};
        QCOMPARE(Burst({frame_at(0.0, pixels)}, {true, true}, 0.0).picture(0).at<cv::Vec3b>(0, 2),
                 cv::Vec3b(9, 8, 7));
        QCOMPARE(Burst({frame_at(0.0, pixels)}, {true, false}, 0.0).picture(0).at<cv::Vec3b>(0, 0),
                 cv::Vec3b(9, 8, 7));
    }

    void a_burst_of_pictures() {
        QuickFaces faces;
        const cv::Mat sharp = view(anna());
        const Burst burst({frame_at(0.0, blurred(sharp)), frame_at(0.1, sharp),
                           frame_at(0.2, view(anna(), {.pan_deg = 29.0}))},
                          {}, 0.0);
        const BurstOrder order = burst.choose(faces);
        QCOMPARE(order.frames.front(), std::size_t{1});
        QVERIFY(order.why != BurstReason::alike && order.why != BurstReason::only);
        const BurstLook look = burst_look(sharp, faces);
        QCOMPARE(look.faces, 1);
        QCOMPARE(look.shut, 0);
        QCOMPARE(burst_look(view(anna(), {.pan_deg = 29.0}), faces).faces, 0); // the edge cuts it
        QCOMPARE(burst_look({}, faces).faces, 0);
    }

    void who_blinked_is_not_kept() {
        NEEDS_PORTRAITS();
        QuickFaces faces;
        const auto people = portraits::held_out();
        for (std::size_t i = 0; i < 3; ++i) {
            const cv::Mat open = *read_picture(people[i].photo);
            const cv::Mat shut =
                with_closed_eyes(open, people[i].truth, 1.0, static_cast<unsigned>(i)).picture;
            const Burst burst(
                {frame_at(0.0, view(shut)), frame_at(0.1, view(open)), frame_at(0.2, view(shut))}, {}, 0.0);
            const BurstOrder order = burst.choose(faces);
            QCOMPARE(order.frames, (Frames{1, 0, 2}));
            QVERIFY(order.why == BurstReason::eyes_open);
        }
    }
};

} // namespace burst_test

TP_TEST(burst_test, BurstTest, nothing)
#include "burst_test.moc"
