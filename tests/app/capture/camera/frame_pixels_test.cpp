// SPDX-License-Identifier: Apache-2.0
// Frames of Qt's cameras become upright pixels, whatever their form; which form a camera is switched on with.
#include "app/capture/camera/camera_format.hpp"
#include "app/capture/camera/frame_pixels.hpp"
#include "app/capture/camera/mapped_picture.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <cstdlib>
#include <cstring>
#include <vector>

using namespace tp;
using Form = QVideoFrameFormat;

Q_DECLARE_METATYPE(QVideoFrameFormat::PixelFormat)
Q_DECLARE_METATYPE(QVideoFrame::RotationAngle)

namespace {

constexpr int wide = 8, high = 4;

/// Fills a mapped plane row by row; `value` of row and byte.
template <typename Value>
void fill(QVideoFrame& frame, int plane, int rows, int row_bytes, Value value) {
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < row_bytes; ++x)
            frame.bits(plane)[y * frame.bytesPerLine(plane) + x] = static_cast<uchar>(value(y, x));
}

/// The upper half red, the lower half blue, as far as the form has colours.
QVideoFrame red_over_blue(Form::PixelFormat form) {
    QVideoFrame frame(Form(QSize(wide, high), form));
    if (!frame.map(QVideoFrame::WriteOnly))
        return {};
    const auto red = [](int y) { return y < high / 2; };
    // Of video: Y, U, V of red are 81, 90, 240, of blue 41, 240, 110.
    const auto luma = [&](int y) { return red(y) ? 81 : 41; };
    const auto u = [&](int y) { return red(y) ? 90 : 240; };
    const auto v = [&](int y) { return red(y) ? 240 : 110; };
    switch (form) {
    case Form::Format_BGRA8888:
    case Form::Format_BGRX8888:
        fill(frame, 0, high, 4 * wide, [&](int y, int x) { return x % 4 == (red(y) ? 2 : 0) ? 255 : 0; });
        break;
    case Form::Format_RGBA8888:
    case Form::Format_RGBX8888:
        fill(frame, 0, high, 4 * wide, [&](int y, int x) { return x % 4 == (red(y) ? 0 : 2) ? 255 : 0; });
        break;
    case Form::Format_YUYV:
        fill(frame, 0, high, 2 * wide, [&](int y, int x) {
            return x % 2 == 0 ? luma(y) : x % 4 == 1 ? u(y) : v(y);
        });
        break;
    case Form::Format_UYVY:
        fill(frame, 0, high, 2 * wide, [&](int y, int x) {
            return x % 2 == 1 ? luma(y) : x % 4 == 0 ? u(y) : v(y);
        });
        break;
    case Form::Format_NV12:
    case Form::Format_NV21: {
        const bool u_first = form == Form::Format_NV12;
        fill(frame, 0, high, wide, [&](int y, int) { return luma(y); });
        fill(frame, 1, high / 2, wide,
             [&](int y, int x) { return (x % 2 == 0) == u_first ? u(2 * y) : v(2 * y); });
        break;
    }
    case Form::Format_YUV420P:
    case Form::Format_YV12: {
        const bool u_first = form == Form::Format_YUV420P;
        fill(frame, 0, high, wide, [&](int y, int) { return luma(y); });
        fill(frame, u_first ? 1 : 2, high / 2, wide / 2, [&](int y, int) { return u(2 * y); });
        fill(frame, u_first ? 2 : 1, high / 2, wide / 2, [&](int y, int) { return v(2 * y); });
        break;
    }
    default:
        break;
    }
    frame.unmap();
    return frame;
}

bool about(const cv::Vec3b& pixel, int blue, int green, int red) {
    return std::abs(pixel[0] - blue) < 12 && std::abs(pixel[1] - green) < 12 && std::abs(pixel[2] - red) < 12;
}
bool is_red(const cv::Vec3b& pixel) { return about(pixel, 0, 0, 255); }
bool is_blue(const cv::Vec3b& pixel) { return about(pixel, 255, 0, 0); }

} // namespace

class FramePixelsTest : public QObject {
    Q_OBJECT

private slots:
    void every_form_gives_the_same_picture_data() {
        QTest::addColumn<Form::PixelFormat>("form");
        QTest::newRow("BGRA") << Form::Format_BGRA8888;
        QTest::newRow("BGRX") << Form::Format_BGRX8888;
        QTest::newRow("RGBA") << Form::Format_RGBA8888;
        QTest::newRow("RGBX") << Form::Format_RGBX8888;
        QTest::newRow("YUYV") << Form::Format_YUYV;
        QTest::newRow("UYVY") << Form::Format_UYVY;
        QTest::newRow("NV12") << Form::Format_NV12;
        QTest::newRow("NV21") << Form::Format_NV21;
        QTest::newRow("YUV420P") << Form::Format_YUV420P;
        QTest::newRow("YV12") << Form::Format_YV12;
    }
    void every_form_gives_the_same_picture() {
        QFETCH(Form::PixelFormat, form);
        QVERIFY(is_read(form));
        const cv::Mat pixels = upright_pixels(red_over_blue(form));
        QCOMPARE(pixels.size(), cv::Size(wide, high));
        QCOMPARE(pixels.type(), CV_8UC3);
        QVERIFY(is_red(pixels.at<cv::Vec3b>(0, 0)));
        QVERIFY(is_red(pixels.at<cv::Vec3b>(1, wide - 1)));
        QVERIFY(is_blue(pixels.at<cv::Vec3b>(high - 1, 0)));
    }

    void grey_is_grey() {
        QVideoFrame frame(Form(QSize(wide, high), Form::Format_Y8));
        QVERIFY(frame.map(QVideoFrame::WriteOnly));
        fill(frame, 0, high, wide, [](int y, int) { return 50 * y; });
        frame.unmap();
        const cv::Mat pixels = upright_pixels(frame);
        QVERIFY(about(pixels.at<cv::Vec3b>(3, 5), 150, 150, 150));
    }

    void a_jpeg_is_found_in_the_memory_that_is_larger_than_it() {
        std::vector<unsigned char> jpeg;
        cv::imencode(".jpg", cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, 255)), jpeg);
        QVideoFrame frame(Form(QSize(64, 48), Form::Format_Jpeg));
        QVERIFY(frame.map(QVideoFrame::WriteOnly));
        QVERIFY(frame.mappedBytes(0) > static_cast<int>(jpeg.size()));
        std::memcpy(frame.bits(0), jpeg.data(), jpeg.size());
        frame.unmap();
        const cv::Mat pixels = upright_pixels(frame);
        QCOMPARE(pixels.size(), cv::Size(64, 48));
        QVERIFY(is_red(pixels.at<cv::Vec3b>(24, 32)));
    }

    void turned_data() {
        QTest::addColumn<QVideoFrame::RotationAngle>("angle");
        QTest::addColumn<int>("y");
        QTest::addColumn<int>("x");
        QTest::newRow("90: what was up is at the right") << QVideoFrame::Rotation90 << 0 << high - 1;
        QTest::newRow("180: is below") << QVideoFrame::Rotation180 << high - 1 << 0;
        QTest::newRow("270: is at the left") << QVideoFrame::Rotation270 << wide - 1 << 0;
    }
    void turned() {
        QFETCH(QVideoFrame::RotationAngle, angle);
        QFETCH(int, y);
        QFETCH(int, x);
        QVideoFrame frame = red_over_blue(Form::Format_BGRA8888);
        frame.setRotationAngle(angle);
        const cv::Mat pixels = upright_pixels(frame);
        QVERIFY(is_red(pixels.at<cv::Vec3b>(y, x)));
        QVERIFY(is_blue(pixels.at<cv::Vec3b>(pixels.rows - 1 - y, pixels.cols - 1 - x)));
    }

    void a_mirrored_frame_is_turned_back() {
        QVideoFrame frame(Form(QSize(wide, high), Form::Format_Y8));
        QVERIFY(frame.map(QVideoFrame::WriteOnly));
        fill(frame, 0, high, wide, [](int, int x) { return x == 0 ? 255 : 0; });
        frame.unmap();
        frame.setMirrored(true);
        const cv::Mat pixels = upright_pixels(frame);
        QCOMPARE(static_cast<int>(pixels.at<cv::Vec3b>(0, wide - 1)[0]), 255);
        QCOMPARE(static_cast<int>(pixels.at<cv::Vec3b>(0, 0)[0]), 0);
    }

    void what_is_not_read_gives_nothing() {
        QVERIFY(!is_read(Form::Format_P010));
        QVERIFY(upright_pixels(QVideoFrame(Form(QSize(wide, high), Form::Format_P010))).empty());
        QVERIFY(upright_pixels(QVideoFrame()).empty());
        QVERIFY(upright_pixels(QVideoFrame(Form(QSize(7, 3), Form::Format_NV12))).empty());
    }

    void the_largest_form_that_one_can_aim_with_is_taken() {
        const std::vector<CameraForm> forms{
            {{640, 480}, Form::Format_YUYV, 60.0},   {{1920, 1080}, Form::Format_NV12, 30.0},
            {{1920, 1080}, Form::Format_YUYV, 10.0}, {{4000, 3000}, Form::Format_YUYV, 5.0},
            {{8000, 6000}, Form::Format_NV12, 30.0}, {{3000, 2000}, Form::Format_P010, 30.0}};
        QCOMPARE(best_form(forms), std::optional<std::size_t>(1));
    }

    void of_slow_forms_the_fastest_is_taken_and_of_unread_ones_none() {
        QCOMPARE(best_form({{{640, 480}, Form::Format_YUYV, 5.0}, {{320, 240}, Form::Format_YUYV, 8.0}}),
                 std::optional<std::size_t>(1));
        QVERIFY(!best_form({{{640, 480}, Form::Format_P010, 30.0}}));
        QVERIFY(!best_form({}));
    }
};

QTEST_GUILESS_MAIN(FramePixelsTest)
#include "frame_pixels_test.moc"
