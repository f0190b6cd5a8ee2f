// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/identity/face_describer.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace face_describer_test {

using namespace tp;

namespace {

struct Described {
    cv::Mat picture;
    Face face;
    FaceNumbers numbers{};
};

Described described(FaceDescriber& describer, const std::string& sample) {
    Described result;
    result.picture =
        *read_picture(std::filesystem::path(tp::test::in_source("resources/samples")) / (sample + ".jpg"));
    FaceExtractor extractor = std::move(FaceExtractor::create()).value();
    result.face = extractor.extract(result.picture).faces.at(0);
    result.numbers = describer.describe(result.picture, result.face).value();
    return result;
}

} // namespace

class FaceDescriberTest : public QObject {
    Q_OBJECT

    FaceDescriber describer_;

private slots:
    void drawn_people_have_the_numbers_that_they_had() {
        const FaceNumbers numbers = described(describer_, "anna_smiling").numbers;
        constexpr std::array<float, 8> first{-0.05263F, 0.08324F,  0.13242F,  -0.07523F,
                                             -0.08189F, -0.03604F, -0.06280F, -0.12434F};
        for (std::size_t i = 0; i < first.size(); ++i)
            QVERIFY(std::abs(numbers[i] - first[i]) <
                    5e-3F); // contours differ by rounding from processor to processor
    }
    void an_expression_changes_less_than_a_person() {
        const FaceNumbers smiling = described(describer_, "anna_smiling").numbers,
                          sad = described(describer_, "anna_sad").numbers,
                          ben = described(describer_, "ben_smiling").numbers;
        QVERIFY(distance(smiling, sad) < distance(smiling, ben));
    }
    void the_same_pixels_have_the_same_numbers() {
        const Described anna = described(describer_, "anna_sad");
        FaceDescriber other;
        QVERIFY(other.describe(anna.picture, anna.face) == anna.numbers);
        QVERIFY(describer_.describe(anna.picture, anna.face) == anna.numbers);
    }
    void a_face_in_a_larger_or_turned_picture_has_nearly_the_same() {
        const Described anna = described(describer_, "anna_sad");
        cv::Mat turned;
        cv::rotate(anna.picture, turned, cv::ROTATE_90_CLOCKWISE);
        Face face = anna.face;
        for (Contour& contour : face.contours)
            contour = mapped(contour, [&](Vec2 p) { return Vec2(anna.picture.rows - p.y, p.x); });
        QVERIFY(distance(*describer_.describe(turned, face), anna.numbers) < 0.02);
    }
    void what_is_no_face_has_no_numbers() {
        Described anna = described(describer_, "anna_sad");
        cv::Mat grey(anna.picture.size(), CV_8U, cv::Scalar(1));
        QVERIFY(!describer_.describe(grey, anna.face));
        QVERIFY(!describer_.describe(cv::Mat(), anna.face));
        QVERIFY(!describer_.describe_square(anna.picture));
        std::erase_if(anna.face.contours,
                      [](const Contour& contour) { return contour.name == feature::outer_lip; });
        QVERIFY(!describer_.describe(anna.picture, anna.face));
    }
};

} // namespace face_describer_test

TP_TEST(face_describer_test, FaceDescriberTest, event_loop)
#include "face_describer_test.moc"
