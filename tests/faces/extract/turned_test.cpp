// SPDX-License-Identifier: Apache-2.0
// Photographs on their side or head whose file does not say so.
#include "faces/decode/picture.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/extract/face_extractor.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

namespace turned_test {

using namespace tp;

namespace {

cv::Mat portrait(const char* name) {
    return read_picture(std::string(tp::test::in_source("resources/samples/")) + name).value();
}

} // namespace

class TurnedTest : public QObject {
    Q_OBJECT
private slots:
    void faces_are_found_on_their_side_and_head_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("degrees");
        for (const QString name : {"anna_smiling.jpg", "ben_angry.jpg", "clara_sad.jpg"})
            for (const int degrees : {90, 180, 270})
                QTest::addRow("%s by %d", qPrintable(name), degrees) << name << degrees;
    }
    void faces_are_found_on_their_side_and_head() {
        QFETCH(QString, name);
        QFETCH(int, degrees);
        FaceExtractor faces = FaceExtractor::create().value();
        const cv::Mat upright = portrait(name.toUtf8().constData());
        const Extraction wanted = faces.extract(upright);
        QCOMPARE(wanted.turned_degrees, 0);
        const Extraction found = faces.extract(turned(upright, degrees));
        QCOMPARE(found.faces.size(), wanted.faces.size());
        QCOMPARE(found.turned_degrees, 360 - degrees);
        QCOMPARE(found.width, upright.cols);
        QCOMPARE(found.height, upright.rows);
        for (const Contour& contour : wanted.faces[0].contours) {
            const auto error =
                contour_error_percent(wanted.faces[0].contours, found.faces[0].contours, contour.name);
            QVERIFY2(error && *error < 0.3, contour.name.c_str());
        }
    }

    void turning_four_times_is_the_same_picture() {
        const cv::Mat upright = portrait("anna_sad.jpg");
        cv::Mat round = upright;
        for (int i = 0; i < 4; ++i)
            round = turned(round, 90);
        const auto same = [](const cv::Mat& a, const cv::Mat& b) {
            return a.size() == b.size() &&
                   std::equal(a.begin<cv::Vec3b>(), a.end<cv::Vec3b>(), b.begin<cv::Vec3b>());
        };
        QVERIFY(same(round, upright));
        QVERIFY(same(turned(turned(upright, 90), 270), upright));
        QVERIFY(!same(turned(upright, 180), upright));
        QCOMPARE(turned(upright, 180).size(), upright.size());
        QCOMPARE(turned(upright, 90).cols, upright.rows);
    }

    void a_picture_without_a_face_is_left_as_it_is() {
        FaceExtractor faces = FaceExtractor::create().value();
        const Extraction found = faces.extract(cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(90)));
        QCOMPARE(found.turned_degrees, 0);
        QCOMPARE(found.width, 400);
        QCOMPARE(found.height, 300);
    }
};

} // namespace turned_test

TP_TEST(turned_test, TurnedTest, nothing)
#include "turned_test.moc"
