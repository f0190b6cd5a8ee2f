// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/jpeg_picture.hpp"
#include "faces/decode/picture.hpp"
#include "made_pictures.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <exiv2/exiv2.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace picture_test {

using namespace tp;
using tp::test::largest_difference;
namespace fs = std::filesystem;

namespace {

cv::Mat sample(int width = 96, int height = 64) { return test::gradient(width, height); }

Bytes encoded(const cv::Mat& picture, const char* ending) {
    Bytes bytes;
    cv::imencode(ending, picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 98, cv::IMWRITE_WEBP_QUALITY, 101});
    return bytes;
}

/// `upright` as a camera held in the way of EXIF orientation `orientation` stores it: where row 0 and column
/// 0 of the stored picture are to be seen (EXIF 2.32, table of tag 0x0112).
cv::Mat stored_as(const cv::Mat& upright, int orientation) {
    const bool swaps = orientation >= 5;
    const int right = upright.cols - 1, bottom = upright.rows - 1;
    cv::Mat stored(swaps ? upright.cols : upright.rows, swaps ? upright.rows : upright.cols, CV_8UC3);
    for (int row = 0; row < stored.rows; ++row)
        for (int column = 0; column < stored.cols; ++column) {
            const cv::Point seen[] = {
                {column, row}, {right - column, row}, {right - column, bottom - row}, {column, bottom - row},
                {row, column}, {right - row, column}, {right - row, bottom - column}, {row, bottom - column}};
            stored.at<cv::Vec3b>(row, column) = upright.at<cv::Vec3b>(seen[orientation - 1]);
        }
    return stored;
}

Bytes cmyk_jpeg(const cv::Mat& picture) {
    // As Adobe stores it: what paper reflects; no black ink.
    cv::Mat inks(picture.size(), CV_8UC4);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) {
            const cv::Vec3b bgr = picture.at<cv::Vec3b>(y, x);
            inks.at<cv::Vec4b>(y, x) = cv::Vec4b(bgr[2], bgr[1], bgr[0], 255);
        }
    tjhandle handle = tjInitCompress();
    unsigned char* data = nullptr;
    unsigned long size = 0;
    tjCompress2(handle, inks.data, inks.cols, 0, inks.rows, TJPF_CMYK, &data, &size, TJSAMP_444, 97, 0);
    Bytes bytes(data, data + size);
    tjFree(data);
    tjDestroy(handle);
    return bytes;
}

void put_big_endian(Bytes& bytes, std::size_t at, unsigned value, int count) {
    for (int i = 0; i < count; ++i)
        bytes[at + static_cast<std::size_t>(i)] = static_cast<unsigned char>(value >> (8 * (count - 1 - i)));
}

/// A PNG that claims to be `side` × `side` px and holds no pixel; its checksum is right.
Bytes png_header(unsigned side) {
    Bytes bytes = encoded(sample(8, 8), ".png");
    put_big_endian(bytes, 16, side, 4);
    put_big_endian(bytes, 20, side, 4);
    unsigned crc = 0xFFFFFFFFu;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1u ? (crc >> 1) ^ 0xEDB88320u : crc >> 1;
    }
    put_big_endian(bytes, 29, ~crc, 4);
    bytes.resize(33);
    return bytes;
}

/// A JPEG whose frame header claims `side` × `side` px.
Bytes jpeg_claiming(unsigned side) {
    Bytes bytes = encoded(sample(16, 16), ".jpg");
    for (std::size_t at = 2; at + 9 < bytes.size(); at += 2u + (bytes[at + 2] * 256u + bytes[at + 3]))
        if (bytes[at + 1] == 0xC0) {
            put_big_endian(bytes, at + 5, side, 2);
            put_big_endian(bytes, at + 7, side, 2);
            break;
        }
    return bytes;
}

void tag_orientation(const fs::path& file, int orientation) {
    const auto image = Exiv2::ImageFactory::open(file.string());
    image->readMetadata();
    image->exifData()["Exif.Image.Orientation"] = static_cast<uint16_t>(orientation);
    image->writeMetadata();
}

Bytes text(const std::string& content) { return {content.begin(), content.end()}; }

Bytes first_part(const Bytes& bytes, double fraction) {
    return {bytes.begin(),
            bytes.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(bytes.size()))};
}

} // namespace

class PictureTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    fs::path path(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }

    fs::path written(const std::string& name, const Bytes& bytes) const {
        std::ofstream(path(name), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path(name);
    }

private slots:
    void decodes_what_was_encoded_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("jpeg") << ".jpg" << 8.0;
        QTest::newRow("png") << ".png" << 0.0;
        QTest::newRow("webp") << ".webp" << 0.0;
        QTest::newRow("tiff") << ".tiff" << 0.0;
        QTest::newRow("bmp") << ".bmp" << 0.0;
        QTest::newRow("jpeg2000") << ".jp2" << 8.0;
    }
    void decodes_what_was_encoded() {
        QFETCH(QString, ending);
        QFETCH(double, tolerance);
        const auto picture = read_picture(written("a.picture", encoded(sample(), ending.toUtf8())));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY(largest_difference(*picture, sample()) <= tolerance);
    }

    void turns_exif_orientations_upright_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("orientation");
        for (const QString ending : {".jpg", ".png", ".webp", ".tiff"})
            for (int orientation = 1; orientation <= 8; ++orientation)
                QTest::newRow(qPrintable(ending + " " + QString::number(orientation)))
                    << ending << orientation;
    }
    void turns_exif_orientations_upright() {
        QFETCH(QString, ending);
        QFETCH(int, orientation);
        const fs::path file = written("turned" + ending.toStdString(),
                                      encoded(stored_as(sample(), orientation), ending.toUtf8()));
        tag_orientation(file, orientation);

        const auto picture = read_picture(file);
        QVERIFY2(picture.ok(), picture.error().c_str());
        QCOMPARE(picture->cols, sample().cols);
        QVERIFY2(largest_difference(*picture, sample()) <= (ending == ".jpg" ? 8.0 : 0.0),
                 qPrintable(QString::number(largest_difference(*picture, sample()))));
    }
    void fits_a_screen_as_the_whole_picture_shrunk_does_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        for (const auto& [width, height] :
             {std::pair(300, 200), {299, 201}, {96, 64}, {75, 50}, {37, 500}, {11, 9}, {1, 1}})
            QTest::addRow("%d x %d", width, height) << width << height;
    }
    void fits_a_screen_as_the_whole_picture_shrunk_does() {
        QFETCH(int, width);
        QFETCH(int, height);
        const cv::Size box(width, height);
        for (int orientation = 1; orientation <= 8; ++orientation)
            for (const char* ending : {".jpg", ".png"}) {
                const fs::path file = written(std::string("fit") + ending,
                                              encoded(stored_as(sample(299, 201), orientation), ending));
                tag_orientation(file, orientation);
                const auto fitted = read_picture_to_fit(file, box);
                const cv::Mat whole = shrunk_to_fit(read_picture(file).value(), box);
                QVERIFY(fitted.ok() && fitted->size() == whole.size());
                QVERIFY(whole.cols <= std::max(1, width) && whole.rows <= std::max(1, height));
                QVERIFY(whole.cols >= std::min(299, width) - 1 || whole.rows >= std::min(201, height) - 1);
                const double difference = largest_difference(*fitted, whole);
                QVERIFY2(difference <= 8.0, std::to_string(difference).c_str());
            }
    }

    void what_is_shrunk_lies_where_it_lay_data() {
        QTest::addColumn<QString>("ending");
        QTest::newRow("JPEG") << ".jpg";
        QTest::newRow("PNG") << ".png";
    }
    void what_is_shrunk_lies_where_it_lay() {
        QFETCH(QString, ending);
        for (const cv::Size size : {cv::Size(800, 600), cv::Size(803, 597)})
            for (int orientation = 1; orientation <= 8; ++orientation) {
                const fs::path file = written(
                    "shrunk" + ending.toStdString(),
                    encoded(stored_as(sample(size.width, size.height), orientation), qPrintable(ending)));
                tag_orientation(file, orientation);
                const cv::Mat whole = *read_picture(file);
                const auto shrunk = read_picture_shrunk(file, 200);
                QVERIFY2(shrunk.ok(), shrunk.error().c_str());
                QVERIFY(shrunk->size == whole.size());
                // Sides of an odd size that are turned would leave a part of a pixel at the wrong end.
                QCOMPARE(shrunk->shrink, size.width == 800 || orientation == 1 ? 4 : 1);
                cv::Mat expected = whole;
                if (shrunk->shrink > 1) {
                    const cv::Size even(shrunk->shrink * (whole.cols / shrunk->shrink),
                                        shrunk->shrink * (whole.rows / shrunk->shrink));
                    cv::resize(whole(cv::Rect({0, 0}, even)), expected, even / shrunk->shrink, 0, 0,
                               cv::INTER_AREA);
                }
                const cv::Mat seen = shrunk->pixels(cv::Rect({0, 0}, expected.size()));
                QVERIFY2(cv::norm(seen, expected, cv::NORM_INF) <= 12.0,
                         qPrintable(QString::number(orientation)));
            }
    }

    void what_is_small_or_of_another_kind_is_not_shrunk() {
        const fs::path small = written("small.jpg", encoded(sample(299, 201), ".jpg"));
        const fs::path webp = written("large.webp", encoded(sample(900, 700), ".webp"));
        for (const fs::path& file : {small, webp}) {
            const auto shrunk = read_picture_shrunk(file, 200);
            QVERIFY(shrunk.ok());
            QCOMPARE(shrunk->shrink, 1);
            QCOMPARE(cv::norm(shrunk->pixels, *read_picture(file), cv::NORM_INF), 0.0);
        }
        QCOMPARE(read_picture_shrunk("/nowhere.jpg", 200).error(), read_picture("/nowhere.jpg").error());
        const std::vector<unsigned char> bytes = encoded(sample(900, 700), ".jpg");
        const fs::path cut = written(
            "cut.jpg", {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2)});
        QCOMPARE(read_picture_shrunk(cut, 200).error(), read_picture(cut).error());
    }

    void ignores_an_orientation_that_makes_no_sense() {
        const fs::path file = written("odd.jpg", encoded(sample(), ".jpg"));
        tag_orientation(file, 77);
        const auto picture = read_picture(file);
        QVERIFY2(picture.ok(), picture.error().c_str());
        QCOMPARE(picture->cols, sample().cols);
    }

    void widens_grey_data() {
        QTest::addColumn<QString>("ending");
        QTest::newRow("jpeg") << ".jpg";
        QTest::newRow("png") << ".png";
    }
    void widens_grey() {
        QFETCH(QString, ending);
        cv::Mat grey, wide;
        cv::cvtColor(sample(), grey, cv::COLOR_BGR2GRAY);
        cv::cvtColor(grey, wide, cv::COLOR_GRAY2BGR);
        const auto picture = read_picture(written("grey", encoded(grey, ending.toUtf8())));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY(largest_difference(*picture, wide) <= 4.0);
    }
    void converts_cmyk() {
        const auto picture = read_picture(written("cmyk.jpg", cmyk_jpeg(sample())));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY2(largest_difference(*picture, sample()) <= 12.0,
                 qPrintable(QString::number(largest_difference(*picture, sample()))));
    }
    void converts_16_bit_png() {
        cv::Mat deep;
        sample().convertTo(deep, CV_16U, 257.0);
        const auto picture = read_picture(written("deep.png", encoded(deep, ".png")));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY(largest_difference(*picture, sample()) <= 1.0);
    }
    void drops_alpha() {
        cv::Mat see_through;
        cv::cvtColor(sample(), see_through, cv::COLOR_BGR2BGRA);
        cv::Mat alpha(see_through.size(), CV_8U, cv::Scalar(10));
        cv::insertChannel(alpha, see_through, 3);
        const auto picture = read_picture(written("alpha.png", encoded(see_through, ".png")));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QCOMPARE(largest_difference(*picture, sample()), 0.0);
    }
    void reads_a_picture_of_one_pixel() {
        const auto picture =
            read_picture(written("one.png", encoded(cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)), ".png")));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QCOMPARE(picture->size(), cv::Size(1, 1));
    }
    void ignores_stray_bytes_in_a_jpeg() {
        Bytes bytes = encoded(sample(), ".jpg");
        const Bytes stray(40, 0x11);
        bytes.insert(bytes.end() - 2, stray.begin(), stray.end()); // libjpeg warns of them
        bytes.insert(bytes.end(), 5000, 0x55); // as a phone's motion photo follows the picture
        const auto picture = read_picture(written("stray.jpg", bytes));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY(largest_difference(*picture, sample()) <= 8.0);
    }

    /// Each scan costs as much as the picture is large, be it empty.
    void a_jpeg_has_at_most_a_hundred_scans() {
        Bytes progressive;
        cv::imencode(".jpg", sample(), progressive, {cv::IMWRITE_JPEG_PROGRESSIVE, 1});
        const std::array<unsigned char, 2> scan{0xFF, 0xDA};
        const auto last = std::find_end(progressive.begin(), progressive.end(), scan.begin(), scan.end());
        const Bytes more(last, progressive.end() - 2);
        const auto scans = [&](const Bytes& bytes) {
            int count = 0;
            for (std::size_t i = 0; i + 1 < bytes.size(); ++i)
                count += bytes[i] == scan[0] && bytes[i + 1] == scan[1] ? 1 : 0;
            return count;
        };
        while (scans(progressive) < 100)
            progressive.insert(progressive.end() - 2, more.begin(), more.end());
        QVERIFY(read_picture(written("many.jpg", progressive)).ok());
        progressive.insert(progressive.end() - 2, more.begin(), more.end());
        QCOMPARE(
            QString::fromStdString(read_picture(written("too_many.jpg", progressive)).error()),
            QString(
                "The JPEG file goes over its picture more often than any program does; it was not read."));
    }

    void says_what_is_wrong_data() {
        QTest::addColumn<Bytes>("bytes");
        QTest::addColumn<QString>("sentence");
        const auto add = [](const char* name, const Bytes& bytes, const char* sentence) {
            QTest::newRow(name) << bytes << sentence;
        };
        const Bytes jpeg = encoded(sample(400, 300), ".jpg"), png = encoded(sample(400, 300), ".png"),
                    webp = encoded(sample(400, 300), ".webp");
        const char* other = "The file is not a picture of a kind that can be read.";
        const char* short_jpeg = "The JPEG file is cut short: a part of the picture is missing.";
        const char* short_png = "The PNG file is cut short: a part of the picture is missing.";
        const char* short_webp = "The WebP file is cut short: a part of the picture is missing.";
        const char* too_large =
            "The picture is too large: 30000 × 30000 pixels, where at most 200 million can be read.";
        add("empty", {}, "The file is empty.");
        add("text named .jpg", text("Dear Anna, here are the photographs you asked for."), other);
        add("one byte", {0xFF}, other);
        add("random", Bytes(5000, 0xA7), other);
        add("heic header alone",
            text(std::string("\0\0\0\x18"
                             "ftypheic\0\0\0\0mif1heic",
                             24)),
            "The HEIC file is damaged.");
        add("jpeg cut in its pixels", first_part(jpeg, 0.6), short_jpeg);
        add("jpeg without its last byte", {jpeg.begin(), jpeg.end() - 2}, short_jpeg);
        add("jpeg cut in its header", {jpeg.begin(), jpeg.begin() + 30}, short_jpeg);
        add("jpeg's first three bytes", {0xFF, 0xD8, 0xFF}, short_jpeg);
        Bytes overwritten = jpeg;
        std::fill(overwritten.begin() + static_cast<std::ptrdiff_t>(overwritten.size() / 2),
                  overwritten.end() - 300, static_cast<unsigned char>(0xD7));
        add("jpeg overwritten in the middle", overwritten, "The JPEG file is damaged.");
        add("png cut in its pixels", first_part(png, 0.6), short_png);
        add("png signature alone", {png.begin(), png.begin() + 8}, short_png);
        Bytes flipped = png;
        flipped[png.size() / 2] ^= 0xFF;
        add("png with a byte changed", flipped, "The PNG file is damaged.");
        add("webp cut in its pixels", first_part(webp, 0.6), short_webp);
        add("huge png", png_header(30000), too_large);
        add("huge jpeg", jpeg_claiming(30000), too_large);
        Bytes header_only = jpeg_claiming(30000);
        header_only.resize(jpeg_header(header_only).scan - 14);
        add("huge jpeg, header only", header_only, too_large);
        add("png of no pixels", png_header(0), "The PNG file is damaged.");
        add("tiff header alone", text(std::string("II*\0\x08\0\0\0", 8)), "The TIFF file is damaged.");
        add("webp header alone", text("RIFF\x04" + std::string(3, '\0') + "WEBP"),
            "The WebP file is damaged.");
    }
    void says_what_is_wrong() {
        QFETCH(Bytes, bytes);
        QFETCH(QString, sentence);
        const auto picture = read_picture(written("bad.jpg", bytes));
        QVERIFY(!picture.ok());
        QCOMPARE(QString::fromStdString(picture.error()), sentence);
    }
    void says_that_there_is_no_file() {
        QCOMPARE(read_picture(path("nowhere.jpg")).error(), std::string("There is no such file."));
        QCOMPARE(read_picture(path("nowhere") / "a.jpg").error(), std::string("There is no such file."));
    }
    void says_that_a_folder_is_no_picture() {
        QCOMPARE(read_picture(folder_.path().toStdString()).error(),
                 std::string("This is a folder, not a picture."));
    }

    /// Whatever a file's bytes are, the answer is a picture or a sentence.
    void survives_any_byte_changed() {
        for (const char* ending : {".jpg", ".png", ".webp"}) {
            const Bytes good = encoded(sample(48, 40), ending);
            for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 150) {
                Bytes bad = good;
                bad[at] = static_cast<unsigned char>(bad[at] ^ 0xFF);
                const auto picture = read_picture(written("changed", bad));
                QVERIFY(picture.ok() ? !picture->empty() : !picture.error().empty());
            }
        }
    }
};

} // namespace picture_test

TP_TEST(picture_test, PictureTest, event_loop)
#include "picture_test.moc"
