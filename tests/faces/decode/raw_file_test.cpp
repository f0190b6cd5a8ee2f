// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "faces/decode/raw_file.hpp"
#include "made_pictures.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgcodecs.hpp>

#include <fstream>
#include <iterator>

namespace raw_file_test {

using namespace tp;
using tp::test::gradient;
using tp::test::largest_difference;
namespace fs = std::filesystem;

namespace {

constexpr double tolerance = 8.0; ///< levels, of a JPEG

const std::initializer_list<const char*> kinds{"dng", "cr2", "cr3", "nef", "arw", "orf", "rw2"};

Bytes bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

class RawFileTest : public QObject {
    Q_OBJECT

    test::MadePictures made_;

    QString jpeg(const std::string& name, const cv::Mat& picture) const {
        cv::imwrite(made_.path(name).string(), picture, {cv::IMWRITE_JPEG_QUALITY, 98});
        return test::MadePictures::text(made_.path(name));
    }
    /// A JPEG that says itself how it is turned.
    QString jpeg_turned(const std::string& name, const cv::Mat& picture, int orientation) const {
        Bytes bytes = bytes_of(jpeg(name, picture).toStdString());
        const std::string exif("\xFF\xE1\0\x22"
                               "Exif\0\0MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0",
                               29);
        Bytes segment(exif.begin(), exif.end());
        segment.push_back(static_cast<unsigned char>(orientation));
        segment.resize(36);
        bytes.insert(bytes.begin() + 2, segment.begin(), segment.end());
        std::ofstream(made_.path(name), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return test::MadePictures::text(made_.path(name));
    }
    fs::path raw(const char* kind, const QString& preview, const QStringList& more = {}) const {
        return made_.by_script("make_raw.py", std::string("a.") + kind, QStringList{kind, preview} + more);
    }

private slots:
    void shows_the_largest_preview_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : kinds)
            QTest::newRow(kind) << kind;
    }
    void shows_the_largest_preview() {
        QFETCH(QString, kind);
        const cv::Mat large = gradient(480, 320);
        const fs::path file =
            raw(qPrintable(kind), jpeg("large.jpg", large), {"--small", jpeg("small.jpg", gradient(60, 40))});
        QVERIFY(kind_of(bytes_of(file)) == PictureKind::raw);
        const auto picture = read_picture(file);
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY2(largest_difference(*picture, large) <= tolerance,
                 qPrintable(QString::number(picture->cols)));
        const auto fitted = read_picture_to_fit(file, {120, 120});
        QVERIFY(fitted && fitted->size() == cv::Size(120, 80));
        const auto shrunk = read_picture_shrunk(file, 200);
        QVERIFY(shrunk && shrunk->shrink == 2 && largest_difference(*shrunk->whole(), *picture) == 0.0);
    }

    void the_raw_files_orientation_counts_where_the_preview_has_none() {
        const cv::Mat stored = gradient(96, 64);
        for (const char* kind : kinds) {
            const auto picture = read_picture(raw(kind, jpeg("p.jpg", stored), {"--orientation", "6"}));
            QVERIFY2(picture.ok(), kind);
            QVERIFY2(largest_difference(*picture, turned(stored, 90)) <= tolerance, kind);
            const auto said_otherwise =
                read_picture(raw(kind, jpeg_turned("t.jpg", stored, 3), {"--orientation", "6"}));
            QVERIFY2(largest_difference(*said_otherwise, turned(stored, 180)) <= tolerance, kind);
        }
    }

    void a_preview_that_cannot_be_decoded_gives_way_to_the_next() {
        const cv::Mat small = gradient(60, 40);
        const QString large = jpeg("cut.jpg", gradient(480, 320));
        fs::resize_file(large.toStdString(), fs::file_size(large.toStdString()) / 2);
        const auto picture = read_picture(raw("nef", large, {"--small", jpeg("small.jpg", small)}));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY(largest_difference(*picture, small) <= tolerance);
    }

    void a_tiff_of_a_cameras_picture_is_a_tiff() {
        const fs::path file = raw("tiff", jpeg("p.jpg", gradient(96, 64)));
        QVERIFY(kind_of(bytes_of(file)) == PictureKind::tiff);
        const auto picture = read_picture(file);
        QVERIFY2(picture.ok(), picture.error().c_str());
        QCOMPARE(picture->size(), cv::Size(16, 12));
    }

    void says_that_nothing_in_it_can_be_shown() {
        const QString nothing = test::MadePictures::text(made_.path("no.jpg"));
        std::ofstream(nothing.toStdString()) << "no picture at all";
        for (const char* kind : {"cr2", "cr3", "arw", "rw2"})
            QCOMPARE(
                read_picture(raw(kind, nothing)).error(),
                std::string("The raw file holds no preview that can be read: save the picture as JPEG."));
    }

    void survives_any_byte_changed() {
        for (const char* kind : kinds) {
            const Bytes good = bytes_of(raw(kind, jpeg("p.jpg", gradient(48, 40))));
            for (std::size_t at = 0; at < good.size(); at += at < 400 ? 1 : 1 + good.size() / 100) {
                Bytes bad = good;
                bad[at] = static_cast<unsigned char>(bad[at] ^ 0xFF);
                const auto picture = decode_picture(bad);
                QVERIFY(picture.ok() ? !picture->empty() : picture.error().ends_with('.'));
            }
        }
    }
};

} // namespace raw_file_test

TP_TEST(raw_file_test, RawFileTest, event_loop)
#include "raw_file_test.moc"
