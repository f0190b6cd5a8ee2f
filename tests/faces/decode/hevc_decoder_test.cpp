// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/hevc_decoder.hpp"
#include "faces/decode/libheif.hpp"
#include "faces/decode/picture.hpp"
#include "made_pictures.hpp"

#include <QTest>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <vector>

using namespace tp;
using tp::test::gradient;
namespace fs = std::filesystem;

namespace {

int decoded_by_ours = 0;

/// Ours, which counts what it decodes.
const heif_decoder_plugin& counting() {
    static const heif_decoder_plugin plugin = [] {
        heif_decoder_plugin ours = hevc_decoder();
        ours.id_name = "counting";
        ours.does_support_format = [](heif_compression_format format) {
            const int priority = hevc_decoder().does_support_format(format);
            return priority > 0 ? priority + 1 : 0;
        };
        ours.decode_image = [](void* coded, heif_image** out) {
            const heif_error error = hevc_decoder().decode_image(coded, out);
            decoded_by_ours += error.code == heif_error_Ok;
            return error;
        };
#if defined(heif_decoder_plugin_latest_version) && heif_decoder_plugin_latest_version >= 5
        ours.does_support_format2 = [](const heif_decoder_plugin_compressed_format_description* format) {
            const int priority = hevc_decoder().does_support_format2(format);
            return priority > 0 ? priority + 1 : 0;
        };
        ours.decode_next_image2 = [](void* coded, heif_image** out, std::uintptr_t* of_pushed,
                                     const heif_security_limits* limits) {
            const heif_error error = hevc_decoder().decode_next_image2(coded, out, of_pushed, limits);
            decoded_by_ours += error.code == heif_error_Ok;
            return error;
        };
#endif
        return ours;
    }();
    return plugin;
}

Bytes bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// What libheif, which converts what is no grey picture to RGB whatever it is asked for, makes of a decoder's
/// answer: planes with their depths, and how colours are coded.
struct Decoded {
    bool ok = false;
    std::map<int, std::pair<int, Bytes>> planes;
    std::vector<int> colours;

    bool operator==(const Decoded&) const = default;
};

Decoded decoded(const Bytes& file) {
    const LibHeif& heif = *load_libheif();
    const std::shared_ptr<heif_context> context(heif.heif_context_alloc(), heif.heif_context_free);
    heif.heif_context_set_max_decoding_threads(context.get(), 0);
    heif_image_handle* handle = nullptr;
    Decoded result;
    if (heif.heif_context_read_from_memory_without_copy(context.get(), file.data(), file.size(), nullptr)
                .code != 0 ||
        heif.heif_context_get_primary_image_handle(context.get(), &handle).code != 0)
        return result;
    const std::shared_ptr<heif_image_handle> primary(handle, heif.heif_image_handle_release);
    heif_image* image = nullptr;
    if (heif.heif_decode_image(handle, &image, heif_colorspace_undefined, heif_chroma_undefined, nullptr)
            .code != 0)
        return result;
    const std::shared_ptr<heif_image> decoded(image, heif.heif_image_release);
    result.ok = true;
    for (const heif_channel channel :
         {heif_channel_Y, heif_channel_R, heif_channel_G, heif_channel_B, heif_channel_Alpha}) {
        int step = 0;
        const unsigned char* const data = heif.heif_image_get_plane_readonly(image, channel, &step);
        if (data == nullptr)
            continue;
        auto& [bits, bytes] = result.planes[channel];
        bits = heif.heif_image_get_bits_per_pixel_range(image, channel);
        const int row = heif.heif_image_get_width(image, channel) * (bits > 8 ? 2 : 1);
        for (int y = 0; y < heif.heif_image_get_height(image, channel); ++y)
            bytes.insert(bytes.end(), data + static_cast<std::ptrdiff_t>(y) * step,
                         data + static_cast<std::ptrdiff_t>(y) * step + row);
    }
    heif_color_profile_nclx* colours = nullptr;
    if (heif.heif_image_get_nclx_color_profile(image, &colours).code == 0) {
        result.colours = {colours->color_primaries, colours->transfer_characteristics,
                          colours->matrix_coefficients, colours->full_range_flag};
        heif.heif_nclx_color_profile_free(colours);
    }
    return result;
}

/// As RGB already, where that may be.
Decoded decoded_as_rgb(const Bytes& file) {
    const HevcAsRgb as_rgb(HevcAsRgb::matrix_of({reinterpret_cast<const char*>(file.data()), file.size()}));
    return decoded(file);
}

/// By libheif's own decoder, whatever part of the file asks for one.
Decoded decoded_by_libde265(const Bytes& file) {
    const WithoutHevcDecoder without;
    return decoded(file);
}

/// Something with edges and grain, so that every tool of the coder is used.
cv::Mat lively(int width, int height) {
    cv::Mat picture = gradient(width, height), grain(height, width, CV_8UC3);
    cv::RNG random(7);
    random.fill(grain, cv::RNG::UNIFORM, 0, 30);
    cv::circle(picture, {width / 2, height / 2}, height / 3, {20, 200, 90}, -1);
    picture += grain;
    return picture;
}

cv::Mat deep(const cv::Mat& picture) {
    cv::Mat result;
    picture.convertTo(result, CV_16U, 257.0);
    return result;
}

cv::Mat grey(const cv::Mat& picture) {
    cv::Mat result;
    cv::cvtColor(picture, result, cv::COLOR_BGR2GRAY);
    return result;
}

cv::Mat see_through(const cv::Mat& picture) {
    cv::Mat result;
    cv::cvtColor(picture, result, cv::COLOR_BGR2BGRA);
    cv::insertChannel(grey(picture), result, 3);
    return result;
}

} // namespace

class HevcDecoderTest : public QObject {
    Q_OBJECT

    test::MadePictures made_;

    static QString text(const fs::path& file) { return test::MadePictures::text(file); }

private slots:
    void initTestCase() { QVERIFY(load_libheif() != nullptr); }

    void is_asked_before_libheifs_own_but_where_it_is_not_wanted() {
        const heif_decoder_descriptor* first = nullptr;
        QCOMPARE(load_libheif()->heif_get_decoder_descriptors(heif_compression_HEVC, &first, 1), 1);
        const QString id = load_libheif()->heif_decoder_descriptor_get_id_name(first);
        QCOMPARE(id, QString(hevc_decoder().id_name));
        QVERIFY(hevc_decoder().does_support_format(heif_compression_HEVC) > 100);
        QCOMPARE(hevc_decoder().does_support_format(heif_compression_AV1), 0);
        const WithoutHevcDecoder without;
        QCOMPARE(hevc_decoder().does_support_format(heif_compression_HEVC), 0);
    }

    void from_here_on_what_it_decodes_is_counted() {
        QCOMPARE(load_libheif()->heif_register_decoder_plugin(&counting()).code, heif_error_Ok);
    }

    void decodes_the_same_bits_data() {
        QTest::addColumn<cv::Mat>("stored");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("pictures"); // that are decoded: alpha is one of its own
        const cv::Mat colours = lively(200, 136);
        for (const QString chroma : {"420", "422", "444"}) {
            const QStringList options{"-p", "chroma=" + chroma, "-q", "60"};
            QTest::newRow(qPrintable(chroma)) << colours << options << 1;
            QTest::newRow(qPrintable(chroma + " odd sides")) << lively(203, 131) << options << 1;
            QTest::newRow(qPrintable(chroma + " limited range"))
                << colours << options + QStringList{"--full_range_flag=0"} << 1;
            for (const QString bits : {"10", "12"})
                QTest::newRow(qPrintable(chroma + " " + bits + " bit"))
                    << deep(colours) << options + QStringList{"-b", bits} << 1;
        }
        for (const QString matrix : {"0", "1", "5", "6", "8", "9"})
            QTest::newRow(qPrintable("matrix " + matrix))
                << colours << QStringList{"-p", "chroma=444", "--matrix_coefficients=" + matrix} << 1;
        QTest::newRow("wide colours")
            << colours
            << QStringList{"--colour_primaries=12", "--transfer_characteristic=13", "--matrix_coefficients=6"}
            << 1;
        QTest::newRow("lossless") << colours << QStringList{"-L"} << 1;
        QTest::newRow("grey") << grey(colours) << QStringList{"-q", "60"} << 1;
        QTest::newRow("grey 10 bit") << deep(grey(colours)) << QStringList{"-b", "10"} << 1;
        QTest::newRow("alpha") << see_through(colours) << QStringList{"-q", "60"} << 2;
        QTest::newRow("64 px") << lively(64, 64) << QStringList{"-q", "20"} << 1;
        QTest::newRow("large") << lively(1500, 1100) << QStringList{"-q", "40"} << 1;
    }
    void decodes_the_same_bits() {
        QFETCH(cv::Mat, stored);
        QFETCH(QStringList, options);
        QFETCH(int, pictures);
        const fs::path coded = made_.coded("a.heic", stored, options);
        std::vector<fs::path> files{coded};
        // heif-enc says how colours are coded in a box too, make_heif.py leaves it to the stream. What has
        // odd sides is a tile to heif-enc, which make_heif.py does not read.
        if (stored.cols % 2 == 0)
            files.push_back(made_.by_script("make_heif.py", "bare.heic", {text(coded)}));
        for (const fs::path& file : files) {
            const Bytes bytes = bytes_of(file);
            decoded_by_ours = 0;
            const Decoded ours = decoded(bytes), its = decoded_by_libde265(bytes);
            QCOMPARE(decoded_by_ours, file == coded ? pictures : 1);
            QVERIFY(ours.ok && its.ok);
            QVERIFY(!ours.planes.empty());
            QCOMPARE(ours.colours, its.colours);
            QVERIFY2(ours.planes == its.planes, qPrintable(QString("the bits of %1 differ").arg(text(file))));
            QVERIFY2(decoded_as_rgb(bytes) == its,
                     qPrintable(QString("the bits of %1 as RGB").arg(text(file))));
        }
    }

    void decodes_the_same_bits_in_tiles() {
        const cv::Mat whole = lively(384, 256);
        QStringList tiles;
        for (const int y : {0, 128})
            for (const int x : {0, 128, 256})
                tiles << text(made_.coded(QString("t%1_%2.heic").arg(x).arg(y).toStdString(),
                                          whole(cv::Rect(x, y, 128, 128)), {"-p", "chroma=420"}));
        const Bytes file = bytes_of(made_.by_script(
            "make_heif.py", "tiles.heic", tiles + QStringList{"--columns", "3", "--size", "370x250"}));
        decoded_by_ours = 0;
        const Decoded ours = decoded(file), its = decoded_by_libde265(file);
        QCOMPARE(decoded_by_ours, 6);
        QVERIFY(ours.ok && ours == its);
        QVERIFY(decoded_as_rgb(file) == its);
    }

    void the_matrix_is_the_one_that_the_boxes_say_data() {
        QTest::addColumn<QByteArray>("boxes");
        QTest::addColumn<int>("matrix"); // 0: none
        const auto box = [](const char* matrix_and_range) {
            return QByteArray("....colrnclx") + QByteArray::fromHex("00010002") +
                   QByteArray::fromHex(matrix_and_range);
        };
        QTest::newRow("nothing") << QByteArray("colrprof") << HevcAsRgb::as_the_stream_says;
        QTest::newRow("BT.709") << box("000180") << 1;
        QTest::newRow("a number of two bytes") << box("010180") << 257;
        QTest::newRow("BT.601, twice") << box("000680") + box("000680") << 6;
        QTest::newRow("limited range") << box("000600") << 0;
        QTest::newRow("two that differ") << box("000680") + box("000180") << 0;
        QTest::newRow("cut short") << box("0006") << 0;
    }
    void the_matrix_is_the_one_that_the_boxes_say() {
        QFETCH(QByteArray, boxes);
        QFETCH(int, matrix);
        QCOMPARE(HevcAsRgb::matrix_of(boxes.toStdString()).value_or(0), matrix);
    }

    /// Whatever our decoder finds wrong, no picture is lost that libheif's own would show.
    void what_the_other_reads_is_read() {
        const Bytes good = bytes_of(made_.coded("spoilt.heic", lively(128, 96), {"-q", "60"}));
        std::mt19937 random(11);
        int refused_by_ours_alone = 0;
        for (int i = 0; i < 300; ++i) {
            Bytes bad = good;
            const std::size_t at = good.size() / 8 + random() % (good.size() - good.size() / 8);
            bad[at] = static_cast<unsigned char>(bad[at] ^ (1U << random() % 8));
            const bool its = decoded_by_libde265(bad).ok;
            const auto picture = decode_picture(bad);
            QVERIFY2(picture.ok() || !its, picture.error().c_str());
            refused_by_ours_alone += its && !decoded(bad).ok;
        }
        QVERIFY2(refused_by_ours_alone > 0, "nothing was left to libheif's own decoder");
    }

    void refuses_units_that_are_cut_short() {
        const unsigned char whole[] = {0, 0, 0, 2, 0x46, 1}, cut[] = {0, 0, 0, 3, 0x46, 1},
                            no_length[] = {0, 0, 0};
        void* decoder = nullptr;
        QCOMPARE(hevc_decoder().new_decoder(&decoder).code, heif_error_Ok);
        QCOMPARE(hevc_decoder().push_data(decoder, whole, sizeof whole).code, heif_error_Ok);
        QCOMPARE(hevc_decoder().push_data(decoder, cut, sizeof cut).subcode, heif_suberror_End_of_data);
        QCOMPARE(hevc_decoder().push_data(decoder, no_length, sizeof no_length).subcode,
                 heif_suberror_End_of_data);
        heif_image* image = nullptr;
        QVERIFY(
            is_hevc_refused(hevc_decoder().decode_image(decoder, &image).message)); // no picture among them
        QVERIFY(image == nullptr);
        hevc_decoder().free_decoder(decoder);
    }
};

QTEST_GUILESS_MAIN(HevcDecoderTest)
#include "hevc_decoder_test.moc"
