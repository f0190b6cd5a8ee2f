// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "made_pictures.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <fstream>
#include <iterator>
#include <vector>

namespace heif_picture_test {

using namespace tp;
using tp::test::gradient;
using tp::test::largest_difference;
namespace fs = std::filesystem;

namespace {

constexpr double tolerance = 14.0; ///< levels, of what is coded at quality 95

Bytes bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

cv::Mat flat(cv::Scalar colour) { return {64, 96, CV_8UC3, colour}; }

} // namespace

class HeifPictureTest : public QObject {
    Q_OBJECT

    test::MadePictures made_;

    fs::path heif(const std::string& name, const QStringList& arguments) const {
        return made_.by_script("make_heif.py", name, arguments);
    }
    static QString text(const fs::path& file) { return test::MadePictures::text(file); }

private slots:
    void decodes_what_was_encoded_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<cv::Mat>("stored");
        const cv::Mat colours = gradient(96, 64);
        cv::Mat grey, see_through, deep;
        cv::cvtColor(colours, grey, cv::COLOR_BGR2GRAY);
        cv::cvtColor(colours, see_through, cv::COLOR_BGR2BGRA);
        cv::insertChannel(cv::Mat(see_through.size(), CV_8U, cv::Scalar(10)), see_through, 3);
        colours.convertTo(deep, CV_16U, 257.0);
        for (const QString ending : {"heic", "avif"}) {
            QTest::newRow(qPrintable("colours " + ending)) << ending << colours;
            QTest::newRow(qPrintable("odd sides " + ending)) << ending << gradient(93, 61);
            QTest::newRow(qPrintable("alpha " + ending)) << ending << see_through;
        }
        QTest::newRow("grey heic") << "heic" << grey;
        QTest::newRow("10 bit heic") << "heic" << deep;
    }
    void decodes_what_was_encoded() {
        QFETCH(QString, ending);
        QFETCH(cv::Mat, stored);
        const auto picture = read_picture(made_.coded("a." + ending.toStdString(), stored));
        QVERIFY2(picture.ok(), picture.error().c_str());
        cv::Mat expected = stored;
        if (stored.channels() == 1)
            cv::cvtColor(stored, expected, cv::COLOR_GRAY2BGR);
        else if (stored.channels() == 4)
            cv::cvtColor(stored, expected, cv::COLOR_BGRA2BGR);
        if (stored.depth() == CV_16U)
            expected.convertTo(expected, CV_8U, 1.0 / 257.0);
        QVERIFY2(largest_difference(*picture, expected) <= tolerance,
                 qPrintable(QString::number(largest_difference(*picture, expected))));
    }

    /// As phones do: the picture in tiles, which reach beyond it.
    void tiles_are_put_together() {
        const cv::Mat whole = gradient(192, 128);
        QStringList tiles;
        for (const int y : {0, 64})
            for (const int x : {0, 64, 128})
                tiles << text(made_.coded("tile" + std::to_string(y) + "_" + std::to_string(x) + ".heic",
                                          whole(cv::Rect(x, y, 64, 64))));
        const auto picture =
            read_picture(heif("tiles.heic", tiles + QStringList{"--columns", "3", "--size", "180x100"}));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY2(largest_difference(*picture, whole(cv::Rect(0, 0, 180, 100))) <= tolerance,
                 qPrintable(QString::number(largest_difference(*picture, whole(cv::Rect(0, 0, 180, 100))))));
    }

    void the_files_own_turn_counts_and_exifs_does_not_data() {
        QTest::addColumn<int>("turn");
        QTest::addColumn<int>("mirror");
        QTest::addColumn<int>("exif");
        for (const int turn : {0, 90, 180, 270})
            for (const int mirror : {-1, 0, 1})
                for (const int exif : {0, 1, 6, 8})
                    QTest::addRow("%d %d %d", turn, mirror, exif) << turn << mirror << exif;
    }
    void the_files_own_turn_counts_and_exifs_does_not() {
        QFETCH(int, turn);
        QFETCH(int, mirror);
        QFETCH(int, exif);
        const cv::Mat stored = gradient(96, 64);
        static const QString coded = text(made_.coded("to_turn.heic", stored));
        QStringList arguments{coded, "--turn", QString::number(turn)};
        if (mirror >= 0)
            arguments << "--mirror" << QString::number(mirror);
        if (exif > 0)
            arguments << "--exif-orientation" << QString::number(exif);
        cv::Mat expected = turned(stored, (360 - turn) % 360);
        if (mirror >= 0)
            cv::flip(expected, expected, mirror);
        const auto picture = read_picture(heif("turned.heic", arguments));
        QVERIFY2(picture.ok(), picture.error().c_str());
        QVERIFY2(largest_difference(*picture, expected) <= tolerance,
                 qPrintable(QString::number(largest_difference(*picture, expected))));
    }

    void of_several_the_primary_is_meant() {
        const QString red = text(made_.coded("red.heic", flat({0, 0, 200}))),
                      blue = text(made_.coded("blue.heic", flat({200, 0, 0})));
        for (const int primary : {0, 1}) {
            const auto picture =
                read_picture(heif("two.heic", {red, blue, "--primary", QString::number(primary)}));
            QVERIFY2(picture.ok(), picture.error().c_str());
            QVERIFY(picture->at<cv::Vec3b>(30, 30)[primary == 0 ? 2 : 0] > 150);
        }
    }

    void fits_a_screen_as_the_whole_picture_shrunk_does() {
        const fs::path file = made_.coded("fit.heic", gradient(298, 202));
        const cv::Mat whole = *read_picture(file);
        for (const cv::Size box : {cv::Size(300, 300), {149, 300}, {75, 50}, {20, 500}, {1, 1}}) {
            const auto fitted = read_picture_to_fit(file, box);
            QVERIFY2(fitted.ok(), fitted.error().c_str());
            QVERIFY2(largest_difference(*fitted, shrunk_to_fit(whole, box)) <= 3.0,
                     qPrintable(QString::number(largest_difference(*fitted, shrunk_to_fit(whole, box)))));
        }
    }

    /// The thumbnail is of another colour, which shows what was decoded.
    void a_thumbnail_stands_in_where_it_fills_the_screen() {
        const QString whole =
            text(made_.coded("whole.heic", cv::Mat(200, 300, CV_8UC3, cv::Scalar(0, 0, 200))));
        const QString small =
            text(made_.coded("small.heic", cv::Mat(100, 150, CV_8UC3, cv::Scalar(200, 0, 0))));
        const QString other =
            text(made_.coded("other.heic", cv::Mat(150, 150, CV_8UC3, cv::Scalar(200, 0, 0))));
        const auto is_blue = [&](const fs::path& file, int width) {
            const auto picture = read_picture_to_fit(file, {width, 1000});
            return picture && picture->size() == cv::Size(width, width * 2 / 3) &&
                   picture->at<cv::Vec3b>(10, 10)[0] > 150;
        };
        const fs::path file = heif("thumb.heic", {whole, "--thumbnail", small});
        QVERIFY(is_blue(file, 90) && is_blue(file, 150) && !is_blue(file, 153));
        QVERIFY(read_picture(file)->at<cv::Vec3b>(10, 10)[2] > 150);
        QVERIFY(!is_blue(heif("other_thumb.heic", {whole, "--thumbnail", other}),
                         90)); // of another shape: not the whole
    }

    void is_shrunk_to_places_that_lie_where_they_lay() {
        const fs::path file = made_.coded("shrunk.heic", gradient(802, 602));
        for (const char* turn : {"0", "90"}) {
            const fs::path stands = heif("shrunk_turned.heic", {text(file), "--turn", turn});
            const cv::Mat whole = *read_picture(stands);
            const auto shrunk = read_picture_shrunk(stands, 200);
            QVERIFY2(shrunk.ok(), shrunk.error().c_str());
            QCOMPARE(shrunk->shrink, 4);
            QVERIFY(shrunk->size == whole.size());
            const cv::Size even = whole.size() / 4 * 4;
            cv::Mat expected;
            cv::resize(whole(cv::Rect({0, 0}, even)), expected, even / 4, 0, 0, cv::INTER_AREA);
            QVERIFY(largest_difference(shrunk->pixels, expected) <= 2.0);
            QCOMPARE(largest_difference(*shrunk->whole(), whole), 0.0);
        }
        const auto as_it_is = read_picture_shrunk(file, 500);
        QVERIFY(as_it_is && as_it_is->shrink == 1 &&
                largest_difference(as_it_is->pixels, *as_it_is->whole()) == 0.0);
    }

    void says_what_is_wrong() {
        const QString coded = text(made_.coded("good.heic", gradient(96, 64))),
                      av1 = text(made_.coded("good.avif", gradient(96, 64)));
        const auto error = [&](const QStringList& arguments) {
            return QString::fromStdString(read_picture(heif("bad", arguments)).error());
        };
        QCOMPARE(error({coded}), QString());
        QCOMPARE(error({coded, "--cut", "20"}),
                 QString("The HEIC file is cut short: a part of the picture is missing."));
        QCOMPARE(error({av1, "--cut", "20"}),
                 QString("The AVIF file is cut short: a part of the picture is missing."));
        QCOMPARE(
            error({coded, "--says", "20000x20000"}),
            QString(
                "The picture is too large: 20000 × 20000 pixels, where at most 200 million can be read."));
        QCOMPARE(error({coded, "--says", "60000x10"}),
                 QString("The HEIC file says that it holds more than any photograph does; it was not read."));
        // A canvas that is much larger than the picture is said to be.
        QCOMPARE(error({coded, "--columns", "1", "--size", "30000x30000", "--says", "96x64"}),
                 QString("The HEIC file says that it holds more than any photograph does; it was not read."));
        // And a coded picture that is.
        QCOMPARE(error({text(made_.coded("large.heic", gradient(800, 600))), "--says", "96x64"}),
                 QString("The HEIC file is damaged."));
    }

    /// Whatever a file's bytes are, the answer is a picture or a sentence.
    void survives_any_byte_changed() {
        for (const char* name : {"small.heic", "small.avif"}) {
            const Bytes good = bytes_of(made_.coded(name, gradient(48, 40)));
            QVERIFY(good.size() > 300);
            for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 400) {
                Bytes bad = good;
                bad[at] = static_cast<unsigned char>(bad[at] ^ 0xFF);
                const auto picture = decode_picture(bad);
                QVERIFY(picture.ok() ? !picture->empty() : picture.error().ends_with('.'));
            }
        }
    }
};

} // namespace heif_picture_test

TP_TEST(heif_picture_test, HeifPictureTest, event_loop)
#include "heif_picture_test.moc"
