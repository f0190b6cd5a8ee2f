// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/detect/yunet_detector.hpp"
#include "faces/models/model_catalog.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QSize>
#include <QTest>

#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect/face.hpp>

#include <cmath>
#include <string>

namespace yunet_detector_test {

using namespace tp;

class YunetDetectorTest : public QObject {
    Q_OBJECT

    YunetDetector detector_{embedded_net(EmbeddedModel::yunet)};

private slots:
    void initTestCase() { quiet_opencv(); }

    void its_faces_are_those_of_opencv_data() {
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize(320, 320), QSize(301, 240), QSize(97, 120), QSize(96, 64)})
            QTest::addRow("%d x %d", size.width(), size.height()) << size;
    }
    void its_faces_are_those_of_opencv() {
        QFETCH(QSize, size);
        const auto opencv = cv::FaceDetectorYN::create(tp::test::in_source("resources/models/yunet.onnx"), "",
                                                       {size.width(), size.height()}, 0.6F, 0.3F, 5000);
        std::size_t faces = 0;
        for (const char* name : {"anna_smiling", "ben_angry", "clara_sad"}) {
            const std::string photo = tp::test::in_source("resources/samples/") + std::string(name) + ".jpg";
            cv::Mat picture, expected;
            cv::resize(*read_picture(photo), picture, {size.width(), size.height()}, 0, 0, cv::INTER_AREA);
            opencv->detect(picture, expected);
            const auto found = detector_.detect(picture, Effort::usual);
            QCOMPARE(static_cast<int>(found.size()), expected.rows);
            faces += found.size();
            for (int i = 0; i < expected.rows; ++i) {
                const float* row = expected.ptr<float>(i);
                const Detection& face = found[static_cast<std::size_t>(i)];
                const auto near = [&](Vec2 p, int at) {
                    return length(p - Vec2(row[at], row[at + 1])) < 0.01;
                };
                QVERIFY(near(face.box.min, 0) && near(face.box.max - face.box.min, 2));
                QVERIFY(near(face.right_eye, 4) && near(face.left_eye, 6));
                QVERIFY(std::abs(face.score - row[14]) < 1e-5);
            }
        }
        QVERIFY(faces > 0 || size.height() < 240);
    }
    /// Its answer has to be as large as the anchors in a picture of any size.
    void any_size_is_searched() {
        for (int width = 64; width < 84; ++width)
            QVERIFY(detector_.detect(cv::Mat(150 - width, width, CV_8UC3, cv::Scalar::all(90)), Effort::usual)
                        .empty());
    }
};

} // namespace yunet_detector_test

TP_TEST(yunet_detector_test, YunetDetectorTest, nothing)
#include "yunet_detector_test.moc"
