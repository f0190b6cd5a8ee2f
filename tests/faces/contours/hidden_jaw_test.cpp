// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/hidden_jaw.hpp"
#include "faces/contours/mesh_model.hpp"
#include "faces/evaluation/cover_lessons.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <limits>
#include <memory>

namespace hidden_jaw_test {

using namespace tp;

namespace {

/// Photographs in the wild that no training saw, in which anybody sees what lies before the jaw.
struct Known {
    const char* file;
    JawCover cover;
};
constexpr Known known[] = {
    {"fellows_138bda47.jpg", JawCover::beard}, {"fellows_fea41ed7.jpg", JawCover::beard},
    {"fellows_40d5ef44.jpg", JawCover::hair},  {"staff_c3323623.jpg", JawCover::hair},
    {"fellows_3599c590.jpg", JawCover::none},  {"staff_b625c408.jpg", JawCover::none},
};

std::filesystem::path wild_folder() { return portraits::folder() / "photos/wild"; }

Landmarks in_mirror(const Landmarks& face, int width) {
    const auto line = [width](std::vector<Vec2> points) {
        for (Vec2& p : points)
            p.x = width - p.x;
        return points;
    };
    Landmarks there = face;
    there.right_eye = line(face.left_eye);
    there.left_eye = line(face.right_eye);
    there.outer_lip = line(face.outer_lip);
    there.inner_lip = line(face.inner_lip);
    there.outline = line(face.outline);
    return there;
}

} // namespace

class HiddenJawTest : public QObject {
    Q_OBJECT

private slots:
    void beards_and_hair_are_told_in_any_size_and_in_the_mirror() {
        if (!std::filesystem::exists(wild_folder()))
            QSKIP("needs ../shared/faces/photos/wild: photographs of people are not part of the repository");
        Eyewitness eyewitness;
        HiddenJaw jaws;
        for (const Known& one : known) {
            const cv::Mat picture = *read_picture(wild_folder() / one.file);
            const auto sight = sight_of(eyewitness, picture);
            QVERIFY2(sight, one.file);
            Landmarks face = sight->opinions.settled;
            QVERIFY2(jaws.cover(picture, face) == one.cover, one.file);
            cv::Mat mirrored, large;
            cv::flip(picture, mirrored, 1);
            QVERIFY2(jaws.cover(mirrored, in_mirror(face, picture.cols)) == one.cover, one.file);
            cv::resize(picture, large, {}, 2.0, 2.0, cv::INTER_LINEAR);
            map_points(face, {glm::dmat2(2.0), Vec2(0.0)}, 2.0);
            QVERIFY2(jaws.cover(large, face) == one.cover, one.file);
        }
        jaws.rest();
        const cv::Mat again = *read_picture(wild_folder() / known[0].file);
        QVERIFY(jaws.cover(again, sight_of(eyewitness, again)->opinions.settled) == known[0].cover);
    }
    void a_face_that_is_nowhere_has_nothing_before_its_jaw() {
        HiddenJaw jaws;
        Landmarks face;
        for (std::vector<Vec2>* line :
             {&face.right_eye, &face.left_eye, &face.outer_lip, &face.inner_lip, &face.outline})
            *line = {{30.0, 30.0}};
        const cv::Mat grey(60, 60, CV_8UC3, cv::Scalar(90, 90, 90));
        QVERIFY(jaws.cover(grey, face) == JawCover::none);
        face.left_eye = {{40.0, 30.0}};
        QVERIFY(jaws.cover({}, face) == JawCover::none);
        face.left_eye = {{std::numeric_limits<double>::quiet_NaN(), 30.0}};
        QVERIFY(jaws.cover(grey, face) == JawCover::none);
    }
};

} // namespace hidden_jaw_test

TP_TEST(hidden_jaw_test, HiddenJawTest, event_loop)
#include "hidden_jaw_test.moc"
