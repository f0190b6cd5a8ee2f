// SPDX-License-Identifier: Apache-2.0
// Where a motion photo says that its video lies, number by number: JPEG segments, Google's list, Samsung's list.
#include "app/album/metadata/motion_photo.hpp"
#include "audio/recordings/byte_source.hpp"
#include "made_video.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace motion_borders_test {

using namespace tp;
using namespace tp::test;
using namespace std::string_literals;

namespace {

/// As far as finding it goes, a video; long enough that its size has three bytes.
const std::string video = "\0\0\0\x14"
                          "ftypmp42\0\0\0\0mp42"s +
                          std::string(70'000, 'v');

std::string big(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>((value >> (8 * i)) & 0xFF);
    return text;
}

std::string little(std::uint64_t value, int bytes) {
    const std::string text = big(value, bytes);
    return {text.rbegin(), text.rend()};
}

std::string segment(char marker, const std::string& data) {
    return "\xFF"s + marker + big(data.size() + 2, 2) + data;
}

bool finds(const std::string& photo) {
    const auto place = video_inside(MemoryBytes(photo));
    return place && photo.substr(place->begin, place->size) == video;
}

/// A photograph whose XMP says that the video lies at its end; `before` stands before the segment that says so.
std::string photo_with(const std::string& before) {
    const std::string photo = made_motion_photo(micro_video(video.size()), video);
    return photo.substr(0, 2) + before + photo.substr(2);
}

std::string item(const std::string& attributes) {
    return "<rdf:li rdf:parseType=\"Resource\">" + attributes + "</rdf:li>";
}

std::string directory(const std::vector<std::pair<const char*, std::string>>& items) {
    std::string list;
    for (const auto& [semantic, length] : items)
        list +=
            item("<Item:Semantic>"s + semantic + "</Item:Semantic><Item:Length>" + length + "</Item:Length>");
    return "><Container:Directory><rdf:Seq>" + list + "</rdf:Seq></Container:Directory>";
}

struct Block {
    std::string bytes;
    std::optional<std::size_t> said_size = {}, said_back = {};
};

std::string block(const std::string& name, const std::string& data) {
    return little(0, 2) + little(0x0A30, 2) + little(name.size(), 4) + name + data;
}

/// What Samsung's cameras put at the end: blocks, and the list of them with `padding` behind its entries.
std::string samsung(const std::vector<Block>& blocks, std::size_t padding = 0,
                    std::optional<std::size_t> count = {}) {
    std::string all, list = "SEFH" + little(106, 4) + little(count.value_or(blocks.size()), 4);
    std::size_t back = 0;
    for (const Block& one : blocks)
        back += one.bytes.size();
    for (const Block& one : blocks) {
        list += little(0, 2) + little(0x0A30, 2) + little(one.said_back.value_or(back), 4) +
                little(one.said_size.value_or(one.bytes.size()), 4);
        all += one.bytes;
        back -= one.bytes.size();
    }
    list += std::string(padding, '\0');
    return made_motion_photo(">", all + list + little(list.size(), 4) + "SEFT");
}

} // namespace

class MotionBordersTest : public QObject {
    Q_OBJECT
private slots:
    void the_xmp_is_found_among_other_segments() {
        QVERIFY(finds(photo_with("")));
        QVERIFY(finds(photo_with(segment('\xE0', "JFIF") + segment('\xE1', "Exif\0\0and so on"s) +
                                 segment('\xDB', ""))));
        QVERIFY(finds(photo_with("\xFF\xFF\xFF"))); // bytes to fill up with
        QVERIFY(finds(photo_with(segment('\xE1', std::string(60'000, 'x')))));
        QVERIFY(!finds(photo_with(segment('\xDA', "the picture begins"))));
        QVERIFY(!finds(photo_with("\xFF\xD9")));
        QVERIFY(!finds(photo_with("\xFF\xE0\0\1"s)));
        QVERIFY(!finds(photo_with("xx")));
        QVERIFY(!finds(photo_with("\xFE\xE0\0\2"s)));
    }

    void a_thousand_segments_are_looked_at() {
        std::string before;
        for (int i = 0; i < 999; ++i)
            before += segment('\xE2', "");
        QVERIFY(finds(photo_with(before)));
        QVERIFY(!finds(photo_with(before + segment('\xE2', ""))));
    }

    void lengths_are_added_from_the_end() {
        const std::string size = std::to_string(video.size());
        const auto finds_by = [](const std::string& properties, const std::string& behind) {
            return finds(made_motion_photo(properties, behind));
        };
        QVERIFY(finds_by(directory({{"Primary", "0"}, {"MotionPhoto", size}}), video));
        QVERIFY(
            finds_by(directory({{"Primary", "0"}, {"MotionPhoto", size}, {"GainMap", "3"}, {"Depth", "4"}}),
                     video + "1234567"));
        QVERIFY(!finds_by(directory({{"Primary", "0"}, {"MotionPhoto", size}, {"GainMap", "3"}}),
                          video + "1234567"));
        QVERIFY(!finds_by(directory({{"Primary", "0"}, {"MotionPhoto", "0"}}), video));
        QVERIFY(!finds_by(directory({{"Primary", "0"}, {"MotionPhoto", size}, {"GainMap", ""}}), video));
        QVERIFY(
            !finds_by(directory({{"MotionPhoto", size}, {"GainMap", "80000"}, {"Depth", "80000"}}), video));
        // As text, never as a link or a list.
        QVERIFY(!finds_by("><GCamera:MicroVideoOffset rdf:resource=\"" + size + "\"/>", video));
        QVERIFY(finds_by("><GCamera:MicroVideoOffset>" + size + "</GCamera:MicroVideoOffset>", video));
        QVERIFY(!finds_by("><GCamera:MicroVideoOffset>" + size + "x</GCamera:MicroVideoOffset>", video));
    }

    void samsung_s_list_leads_to_the_block_of_that_name() {
        const Block it{block("MotionPhoto_Data", video)}, other{block("Image_UTC_Data", "1234")};
        QVERIFY(finds(samsung({it})));
        QVERIFY(finds(samsung({other, it})));
        QVERIFY(finds(samsung({it, other, other})));
        QVERIFY(finds(samsung({it}, 7)));
        QVERIFY(finds(samsung({it}, 0, 1'000))); // more than there are
        QVERIFY(!finds(samsung({it}, 0, 0)));
        QVERIFY(!finds(samsung({other, it}, 0, 1)));
        QVERIFY(!finds(samsung({other})));
        QVERIFY(!finds(samsung({{block("MotionPhoto_Date", video)}})));
        QVERIFY(!finds(samsung({{block("MotionPhoto_Data2", video)}})));
        QVERIFY(!finds(samsung({{block("xMotionPhoto_Data", video)}})));
    }

    void what_leads_out_of_the_file_is_passed_over() {
        const Block it{block("MotionPhoto_Data", video)};
        const std::size_t size = it.bytes.size();
        const Block too_far{"", 30, 1'000'000}, too_large{"", 31, 30}, empty{block("MotionPhoto_Data", "")};
        QVERIFY(finds(samsung({too_far, too_large, empty, it})));
        QVERIFY(!finds(samsung({{it.bytes, size + 1}})));
        QVERIFY(!finds(samsung({{it.bytes, size - 1}})));
        QVERIFY(!finds(samsung({{it.bytes, size, size + 1}})));
        QVERIFY(!finds(samsung({{it.bytes, size, size - 1}})));
        QVERIFY(!finds(samsung({{it.bytes, 24}})));
        // The file itself as a block; the number before its name does not fit.
        std::string broken = it.bytes;
        broken[4] = 15;
        QVERIFY(!finds(samsung({{broken}})));
    }

    void samsung_s_list_is_as_long_as_it_says_and_no_longer_than_64_kilobytes() {
        const Block it{block("MotionPhoto_Data", video)};
        constexpr std::size_t head_and_entry = 24, most = 1 << 16;
        QVERIFY(finds(samsung({it}, most - head_and_entry)));
        QVERIFY(!finds(samsung({it}, most - head_and_entry + 1)));
        const std::string photo = samsung({it});
        const auto with_size = [&](std::size_t list_size) {
            std::string changed = photo;
            changed.replace(changed.size() - 8, 4, little(list_size, 4));
            return changed;
        };
        QVERIFY(finds(with_size(head_and_entry)));
        for (const std::size_t wrong :
             {std::size_t{0}, std::size_t{11}, std::size_t{12}, std::size_t{23}, std::size_t{25}})
            QVERIFY(!finds(with_size(wrong)));
        std::string no_list = photo;
        no_list.replace(no_list.rfind("SEFH"), 4, "SEFX");
        QVERIFY(!finds(no_list));
        QVERIFY(!finds(photo + " "));
        for (const char* end : {"SEFT", "\xFF\xD8SEFT", "\xFF\xD8    SEFT", "\xFF\xD8 \0\0\0SEFT"})
            QVERIFY(!finds(end));
    }
};

} // namespace motion_borders_test

TP_TEST(motion_borders_test, MotionBordersTest, event_loop)
#include "motion_borders_test.moc"
