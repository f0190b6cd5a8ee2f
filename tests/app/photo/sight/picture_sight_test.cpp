// SPDX-License-Identifier: Apache-2.0
#include "app/photo/sight/picture_sight.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"
#include "places.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <array>

using namespace tp;

namespace {

cv::Mat sample() { return read_picture(tp::test::in_source("resources/samples/anna_smiling.jpg")).value(); }

Extraction nobody(const cv::Mat& picture) {
    Extraction found;
    found.width = picture.cols;
    found.height = picture.rows;
    return found;
}

/// A face in the middle.
Extraction somebody(const cv::Mat& picture) {
    Extraction found = nobody(picture);
    Face face;
    face.box = {Vec2(0.4 * picture.cols, 0.3 * picture.rows), Vec2(0.6 * picture.cols, 0.5 * picture.rows)};
    found.faces = {face};
    return found;
}

/// `around`, with a head and a body of that grey level where somebody() has them.
cv::Mat person_before(const cv::Scalar& around, int grey) {
    cv::Mat picture(600, 800, CV_8UC3, around);
    cv::circle(picture, {400, 240}, 90, cv::Scalar::all(grey), cv::FILLED);
    cv::rectangle(picture, {280, 330, 240, 270}, cv::Scalar::all(grey), cv::FILLED);
    return picture;
}

Light light_on(const cv::Mat& picture, const Extraction& found) {
    return light_of(measures_of(picture, found));
}
Colours colours_on(const cv::Mat& picture, const Extraction& found) {
    return colours_of(measures_of(picture, found));
}

} // namespace

class PictureSightTest : public QObject {
    Q_OBJECT
private slots:
    void light_is_that_around_people() {
        const auto light = [](int around) {
            const cv::Mat picture = person_before(cv::Scalar::all(around), 120);
            return light_on(picture, somebody(picture));
        };
        QCOMPARE(light(250), Light::bright_background);
        QCOMPARE(light(120), Light::usual);
        QCOMPARE(light(10), Light::dark_background);
    }

    /// Whatever somebody's skin and clothes are like, the same is said of a picture.
    void light_says_nothing_about_skin() {
        for (const int around : {250, 120, 10})
            for (const int skin : {45, 90, 150, 230}) {
                const cv::Mat picture = person_before(cv::Scalar::all(around), skin);
                const cv::Mat other = person_before(cv::Scalar::all(around), 120);
                QCOMPARE(light_on(picture, somebody(picture)), light_on(other, somebody(other)));
            }
    }

    void a_picture_is_dark_where_nothing_in_it_is_light() {
        cv::Mat picture = person_before(cv::Scalar::all(60), 120);
        QCOMPARE(light_on(picture, somebody(picture)), Light::dark_background); // who is in it may be lit
        picture(cv::Rect(0, 0, 800, 100)) = cv::Scalar::all(200);
        QCOMPARE(light_on(picture, somebody(picture)), Light::usual);
        QCOMPARE(light_on(sample() * 0.35, nobody(sample())), Light::dark);
        QVERIFY(light_on(sample(), nobody(sample())) != Light::dark);
    }

    void black_and_white_is_one_tone_also_a_yellowed_one() {
        const cv::Mat picture = sample();
        QVERIFY(colours_on(picture, nobody(picture)) != Colours::black_and_white);
        cv::Mat grey, toned;
        cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
        cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
        QCOMPARE(colours_on(grey, nobody(picture)), Colours::black_and_white);
        cv::Mat lab;
        cv::cvtColor(grey, lab, cv::COLOR_BGR2Lab);
        lab += cv::Scalar(0, 1, 5);
        cv::cvtColor(lab, toned, cv::COLOR_Lab2BGR);
        QCOMPARE(colours_on(toned, nobody(picture)), Colours::black_and_white);
    }

    void the_colour_is_that_around_people() {
        const struct {
            cv::Scalar bgr;
            Colours colour;
        } grounds[] = {{{40, 160, 40}, Colours::green},   {{200, 90, 30}, Colours::blue},
                       {{30, 30, 190}, Colours::red},     {{40, 220, 230}, Colours::yellow},
                       {{190, 60, 160}, Colours::violet}, {{60, 120, 200}, Colours::many}}; // skin and wood
        for (const auto& [bgr, colour] : grounds) {
            const cv::Mat picture = person_before(bgr, 120);
            cv::circle(picture, {420, 240}, 20, {40, 160, 40}, cv::FILLED);
            QCOMPARE(static_cast<int>(colours_on(picture, somebody(picture))), static_cast<int>(colour));
        }
    }

    void blur_is_told_and_a_soft_background_is_none() {
        const cv::Mat picture = sample();
        QVERIFY(!is_blurred(measures_of(picture, nobody(picture))));
        cv::Mat soft;
        cv::GaussianBlur(picture, soft, {}, 0.02 * picture.cols);
        QVERIFY(is_blurred(measures_of(soft, nobody(picture))));
        picture(cv::Rect(picture.cols / 3, picture.rows / 3, picture.cols / 3, picture.rows / 3))
            .copyTo(soft(cv::Rect(picture.cols / 3, picture.rows / 3, picture.cols / 3, picture.rows / 3)));
        QVERIFY(!is_blurred(measures_of(soft, nobody(picture))));
    }

    void where_little_is_seen_around_people_nothing_is_said_of_it() {
        const cv::Mat picture(300, 300, CV_8UC3, cv::Scalar(40, 160, 40));
        Extraction found = nobody(picture);
        Face face;
        face.box = {Vec2(30.0, 30.0), Vec2(270.0, 270.0)};
        found.faces = {face};
        const PictureMeasures measures = measures_of(picture, found);
        QVERIFY(!measures.around);
        QCOMPARE(measures.most, Colours::many);
    }

    void pictures_that_hardly_are_any() {
        for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 3000), cv::Size(3000, 1), cv::Size(7, 5)}) {
            const cv::Mat picture(size, CV_8UC3, cv::Scalar(90, 120, 140));
            const PictureMeasures measures = measures_of(picture, nobody(picture));
            QVERIFY(std::isfinite(measures.blur) && std::isfinite(measures.off_tone));
            QVERIFY(!is_blurred(measures));
        }
        measures_of(cv::Mat(), Extraction());
        Extraction beside = nobody(sample());
        Face face;
        face.box = {Vec2(-9e9, -9e9), Vec2(-8e9, 9e12)};
        beside.faces = {face};
        QVERIFY(measures_of(sample(), beside).around);
    }
};

QTEST_APPLESS_MAIN(PictureSightTest)
#include "picture_sight_test.moc"
