// SPDX-License-Identifier: Apache-2.0
// PNG that is shrunk while it is decoded, against OpenCV's decoder and its average of areas.
#include "faces/decode/picture.hpp"
#include "faces/decode/png_picture.hpp"
#include "faces/decode/upright_picture.hpp"
#include "made_pictures.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <filesystem>
#include <string>

namespace png_picture_test {

using namespace tp;
using tp::test::largest_difference;
namespace fs = std::filesystem;

namespace {

/// Each area by itself, at the right and lower edge what there is of it.
cv::Mat averaged(const cv::Mat& whole, int shrink) {
    cv::Mat small((whole.rows + shrink - 1) / shrink, (whole.cols + shrink - 1) / shrink, CV_8UC3);
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const cv::Rect area =
                cv::Rect(x * shrink, y * shrink, shrink, shrink) & cv::Rect({0, 0}, whole.size());
            const cv::Scalar mean = cv::mean(whole(area));
            small.at<cv::Vec3b>(y, x) = {cv::saturate_cast<uchar>(mean[0]), cv::saturate_cast<uchar>(mean[1]),
                                         cv::saturate_cast<uchar>(mean[2])};
        }
    return small;
}

} // namespace

class PngPictureTest : public QObject {
    Q_OBJECT

    test::MadePictures made_;

    fs::path made(int width, int height, int bits, const char* kind, bool interlaced = false) const {
        QStringList words{QString::number(width), QString::number(height), QString::number(bits), kind};
        if (interlaced)
            words << "--interlaced";
        return made_.by_script("make_png.py", "made.png", words);
    }

private slots:
    void every_kind_of_pixel_is_averaged_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("bits");
        const auto row = [](const char* kind, std::initializer_list<int> depths) {
            for (const int bits : depths)
                QTest::addRow("%s, %d bits", kind, bits) << kind << bits;
        };
        row("grey", {1, 2, 4, 8, 16});
        row("grey-key", {1, 8, 16});
        row("colour", {8, 16});
        row("colour-key", {8, 16});
        row("palette", {1, 2, 4, 8});
        row("grey-alpha", {8, 16});
        row("colour-alpha", {8, 16});
    }
    void every_kind_of_pixel_is_averaged() {
        QFETCH(QString, kind);
        QFETCH(int, bits);
        for (const bool interlaced : {false, true}) {
            const fs::path file = made(61, 43, bits, qPrintable(kind), interlaced);
            const cv::Mat whole = cv::imread(file.string(), cv::IMREAD_COLOR);
            QVERIFY(!whole.empty());
            const Bytes bytes = read_bytes(file).value();
            const auto same = decode_png(bare_png(bytes).value(), whole.size());
            QVERIFY2(same.ok(), same.error().c_str());
            QCOMPARE(largest_difference(*same, whole), 0.0);
            for (const int shrink : {2, 4, 8}) {
                const auto small = decode_png(bare_png(bytes).value(), whole.size(), shrink);
                QVERIFY2(small.ok(), small.error().c_str());
                QVERIFY(small->size() == averaged(whole, shrink).size());
                const double difference = largest_difference(*small, averaged(whole, shrink));
                QVERIFY2(difference <= 1.0, qPrintable(QString::number(difference)));
            }
        }
    }

    void a_large_one_is_shrunk_as_a_search_asks() {
        for (const bool interlaced : {false, true}) {
            const fs::path file = made(330, 222, 8, "colour", interlaced);
            const auto shrunk = read_picture_shrunk(file, 80);
            QVERIFY2(shrunk.ok(), shrunk.error().c_str());
            QCOMPARE(shrunk->shrink, 4);
            QVERIFY(shrunk->size == cv::Size(330, 222));
            QVERIFY(shrunk->pixels.size() == cv::Size(83, 56));
            const cv::Mat whole = cv::imread(file.string());
            QCOMPARE(largest_difference(shrunk->whole().value(), whole), 0.0);
            QVERIFY(largest_difference(shrunk->pixels, averaged(whole, 4)) <= 1.0);
        }
    }

    void what_is_damaged_is_one_sentence() {
        const Bytes bytes = read_bytes(made(61, 43, 8, "colour")).value();
        // A chunk of pixels with a right checksum and half of its rows.
        const Bytes fewer = read_bytes(made(61, 20, 8, "colour")).value();
        Bytes short_of_rows = fewer;
        std::copy(bytes.begin() + 8, bytes.begin() + 33, short_of_rows.begin() + 8); // its header
        QCOMPARE(bare_png(short_of_rows).ok(), true);
        for (const int side : {10, 20, 1'000})
            QCOMPARE(decoded_to_fit(short_of_rows, {side, side}).error(),
                     std::string("The PNG file is damaged."));
        Bytes of_another_kind = bytes;
        of_another_kind[25] = 4; // two samples a pixel, and a checksum of three
        QCOMPARE(decoded_to_fit(of_another_kind, {20, 20}).error(), std::string("The PNG file is damaged."));
    }
};

} // namespace png_picture_test

TP_TEST(png_picture_test, PngPictureTest, event_loop)
#include "png_picture_test.moc"
