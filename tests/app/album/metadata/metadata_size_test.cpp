// SPDX-License-Identifier: Apache-2.0
// How much metadata a photograph may carry, to the byte, wherever it stands in the file. Files are sparse.
#include "app/album/metadata/metadata_size.hpp"
#include "made_photo.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <filesystem>
#include <string>

namespace metadata_size_test {

using namespace tp;
using namespace tp::test;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t most = 16u << 20; ///< bytes

std::string big(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>((value >> (8 * i)) & 0xFF);
    return text;
}

std::string little(std::uint32_t value, int bytes = 4) {
    const std::string text = big(value, bytes);
    return {text.rbegin(), text.rend()};
}

const std::string png_start = "\x89PNG\r\n\x1A\n";
const std::string webp_start = "RIFF\0\0\0\0WEBP"s;

std::string png_chunk(const std::string& type, const std::string& data) {
    return big(static_cast<std::uint32_t>(data.size())) + type + data + "crc.";
}
std::string webp_chunk(const std::string& type, const std::string& data) {
    return type + little(static_cast<std::uint32_t>(data.size())) + data + std::string(data.size() % 2, '\0');
}

} // namespace

class MetadataSizeTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;

    /// Of a file of these bytes that is `size` long; 0: no longer than they are.
    bool oversized(const std::string& bytes, std::uintmax_t size = 0) const {
        const fs::path file = fs::path(dir_.path().toStdString()) / "photo";
        write_bytes(file, bytes);
        if (size > 0)
            fs::resize_file(file, size);
        return has_oversized_metadata(file);
    }

private slots:
    void a_chunk_of_a_png() {
        const std::string start = png_start + png_chunk("IHDR", "width, height");
        for (const char* type : {"iTXt", "eXIf", "zTXt", "iCCP"}) {
            QVERIFY(!oversized(start + big(most) + type));
            QVERIFY(oversized(start + big(most + 1) + type));
        }
        QVERIFY(!oversized(start + big(100'000'000) + "IDAT")); // the picture itself may be large
        const std::string large = start + png_chunk("IDAT", std::string(1'000, 'x')) + png_chunk("tEXt", "");
        QVERIFY(oversized(large + big(most + 1) + "iTXt"));
        QVERIFY(!oversized(large + png_chunk("IEND", "") + big(most + 1) + "iTXt")); // behind its end
        QVERIFY(!oversized(png_start));
        QVERIFY(!oversized(png_start + big(most + 1) + "iTX")); // cut
    }

    void a_chunk_of_a_webp() {
        for (const char* type : {"XMP ", "EXIF", "ICCP"}) {
            QVERIFY(!oversized(webp_start + type + little(most)));
            QVERIFY(oversized(webp_start + type + little(most + 1)));
        }
        QVERIFY(!oversized(webp_start + "VP8L" + little(100'000'000)));
        for (const char* data : {"", "1", "12", "123"})
            QVERIFY(oversized(webp_start + webp_chunk("VP8 ", data) + webp_chunk("ALPH", data) + "EXIF" +
                              little(most + 1)));
        QVERIFY(!oversized(webp_start + "EXIF" + little(most + 1).substr(0, 3))); // cut
        QVERIFY(!oversized("RIFF\0\0\0\0WAVE"s + "EXIF" + little(most + 1)));
    }

    /// 700 is the tag of XMP, of one byte each.
    void the_xmp_of_a_tiff() {
        for (const bool is_little : {true, false}) {
            const auto number = is_little ? little : big;
            const auto entry = [&](std::uint32_t tag, std::uint32_t count) {
                return number(tag, 2) + number(1, 2) + number(count, 4) + "here";
            };
            const auto file = [&](const std::string& entries, std::uint32_t count, std::uint32_t at = 8) {
                return (is_little ? "II*\0"s : "MM\0*"s) + number(at, 4) + std::string(at - 8, ' ') +
                       number(count, 2) + entries;
            };
            QVERIFY(!oversized(file(entry(700, most), 1)));
            QVERIFY(oversized(file(entry(700, most + 1), 1)));
            QVERIFY(oversized(file(entry(256, 1) + entry(257, 1) + entry(700, most + 1), 3)));
            QVERIFY(oversized(file(entry(256, 1) + entry(700, most + 1), 2, 300)));
            QVERIFY(!oversized(file(entry(256, 1) + entry(700, most + 1), 1))); // not in the list any more
            QVERIFY(!oversized(file(entry(273, most + 1), 1))); // where the picture's strips are
            QVERIFY(!oversized(file(entry(700, most + 1).substr(0, 11), 1))); // cut
            QVERIFY(!oversized(file(entry(256, 1), 60'000)));
        }
        QVERIFY(!oversized("IM*\0"s + little(8) + little(1, 2) + little(700, 2) + little(1, 2) +
                           little(most + 1)));
    }

    /// Of kinds whose order is not known here, and not of those that end at 64 KB each.
    void a_file_of_another_kind() {
        constexpr std::uintmax_t most_of_other_kinds = std::uintmax_t{128} << 20;
        for (const std::string& start : {"\0\0\0\x18"
                                         "ftypheic"s,
                                         ""s, "RIFF"s, "RIFF\0\0\0\0WAVE"s, "II"s, "\xFF"s, "\x89PN"s}) {
            QVERIFY(!oversized(start, most_of_other_kinds));
            QVERIFY(oversized(start, most_of_other_kinds + 1));
        }
        QVERIFY(!oversized("\xFF\xD8", most_of_other_kinds + 1));
        QVERIFY(!has_oversized_metadata(fs::path(dir_.path().toStdString()) / "missing"));
    }

    void no_picture_has_a_hundred_thousand_chunks() {
        for (const int chunks : {99'999, 100'000}) {
            std::string png = png_start, webp = webp_start;
            for (int i = 0; i < chunks; ++i) {
                png += png_chunk("tEXt", "");
                webp += webp_chunk("tEXt", "");
            }
            png += png_chunk("IEND", "");
            QCOMPARE(oversized(png), chunks == 100'000);
            QCOMPARE(oversized(webp), chunks == 100'000);
        }
    }
};

} // namespace metadata_size_test

TP_TEST(metadata_size_test, MetadataSizeTest, event_loop)
#include "metadata_size_test.moc"
