// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/motion_photo.hpp"
#include "audio/recordings/byte_source.hpp"
#include "byte_mutants.hpp"
#include "made_video.hpp"
#include "motion_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace motion_photo_test {

using namespace tp;
using namespace tp::test;
using namespace std::string_literals;

namespace {

constexpr std::uint64_t seed = 20260501;
constexpr int mutated_photos = 20'000;

/// As far as finding it goes, a video.
const std::string video = "\0\0\0\x14"
                          "ftypmp42\0\0\0\0mp42 and all that follows"s;

std::string item(const std::string& semantic, const std::string& length, const std::string& padding = "0") {
    return "<rdf:li rdf:parseType=\"Resource\"><Container:Item Item:Semantic=\"" + semantic +
           "\" Item:Length=\"" + length + "\" Item:Padding=\"" + padding + "\"/></rdf:li>";
}

std::string items(const std::string& list) {
    return "><Container:Directory><rdf:Seq>" + list + "</rdf:Seq></Container:Directory>";
}

std::optional<std::string> found(const std::string& photo) {
    const auto place = video_inside(MemoryBytes(photo));
    return place ? std::optional(photo.substr(place->begin, place->size)) : std::nullopt;
}

} // namespace

class MotionPhotoTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCOMPARE(video.size(), std::size_t{41}); } // the numbers below count on it

    void the_video_is_found_as_each_maker_says_it() {
        QVERIFY(found(made_motion_photo(motion_photo_1(video.size()), video)) == video);
        QVERIFY(found(made_motion_photo(micro_video(video.size()), video)) == video);
        QVERIFY(found(made_motion_photo(">", samsung_end(video))) == video);
    }

    void the_video_in_a_heic_file_has_a_box_of_its_own() {
        const std::string head = "\0\0\0\x10"
                                 "ftypheic\0\0\0\0"s;
        const std::string other = "\0\0\0\x0A"
                                  "mdat12"s;
        const auto size = [](std::size_t bytes) { return "\0\0\0"s + static_cast<char>(bytes + 8); };
        const std::string box = size(video.size()) + "mpvd" + video;
        QVERIFY(found(head + other + box) == video);
        QVERIFY(found(head + box + other) == video);
        QVERIFY(found(head + other + "\0\0\0\0mpvd"s + video) == video); // to the end
        QVERIFY(found(head + other + "\0\0\0\1mpvd\0\0\0\0\0\0\0"s + static_cast<char>(video.size() + 16) +
                      video) == video);
        QVERIFY(!found(head + other));
        QVERIFY(!found(head + size(video.size() + 1) + "mpvd" + video)); // leads out of the file
        QVERIFY(!found(head + size(8) + "mpvdno video"));
        QVERIFY(!found(other + box));
    }

    void what_lies_around_it_is_not_its_own() {
        const std::string gain_map = "another picture";
        QVERIFY(found(made_motion_photo(
                    items(item("Primary", "0", "7") + item("GainMap", "15") + item("MotionPhoto", "41")),
                    "padding" + gain_map + video)) == video);
        QVERIFY(found(made_motion_photo(
                    items(item("Primary", "0") + item("MotionPhoto", "41", "3") + item("GainMap", "15", "2")),
                    video + "..." + gain_map + "..")) == video);
        // two ways at once, as some write it: the newer one counts
        QVERIFY(found(made_motion_photo("GCamera:MicroVideoOffset=\"3\" " + motion_photo_1(video.size()),
                                        video)) == video);
        // the newer one says nothing that can be: the older one does
        QVERIFY(found(made_motion_photo("GCamera:MicroVideoOffset=\"41\" " + motion_photo_1(4'000'000'000),
                                        video)) == video);
    }

    void a_prefix_is_only_a_prefix() {
        std::string photo = made_motion_photo(micro_video(video.size()), video);
        for (std::size_t at = 0; (at = photo.find("GCamera", at)) != std::string::npos;)
            photo.replace(at, 7, "Kamera_");
        QVERIFY(found(photo) == video);
        photo.replace(photo.find("photos/1.0/camera/"), 6, "fotos_");
        QVERIFY(!found(photo));
    }

    void what_leads_elsewhere_is_nothing_data() {
        QTest::addColumn<QByteArray>("photo");
        const auto row = [](const char* name, const std::string& photo) {
            QTest::newRow(name) << QByteArray::fromStdString(photo);
        };
        row("nothing said", made_motion_photo(">", video));
        for (const char* offset :
             {"0", "42", "40", "-41", "+41", " 41", "41 ", "4.1e1", "0x29", "", "99999999999999999999",
              "18446744073709551615", "18446744073709551575", "4000000000"})
            row(offset,
                made_motion_photo("GCamera:MicroVideoOffset=\"" + std::string(offset) + "\">", video));
        row("length beyond the file", made_motion_photo(items(item("MotionPhoto", "4000")), video));
        row("no length", made_motion_photo(items("<rdf:li rdf:parseType=\"Resource\"><Container:Item "
                                                 "Item:Semantic=\"MotionPhoto\"/></rdf:li>"),
                                           video));
        row("another's length wraps round",
            made_motion_photo(items(item("MotionPhoto", "41") + item("GainMap", "18446744073709551615")),
                              video));
        row("padding wraps round",
            made_motion_photo(items(item("MotionPhoto", "41", "18446744073709551615")), video));
        row("only pictures", made_motion_photo(items(item("Primary", "0") + item("GainMap", "41")), video));
        row("a list of texts", made_motion_photo(items("<rdf:li>MotionPhoto</rdf:li>"), video));
        row("no video there", made_motion_photo(micro_video(video.size()), std::string(video.size(), 'x')));
        row("no JPEG", "PNG" + made_motion_photo(micro_video(video.size()), video));
        row("cut", made_motion_photo(micro_video(video.size()), video).substr(0, 200));
        row("empty", {});
        std::string samsung = made_motion_photo(">", samsung_end(video));
        row("Samsung's list is cut", samsung.substr(0, samsung.size() - 1));
        // Sizes, places and numbers in it.
        for (const std::size_t from_end : std::initializer_list<std::size_t>{5, 6, 7, 8, 9, 12, 13, 16, 17, 20, 24}) {
            std::string changed = samsung;
            changed[samsung.size() - from_end] = '\x7F';
            row(("Samsung's list, byte " + std::to_string(from_end)).c_str(), changed);
        }
    }

    void what_leads_elsewhere_is_nothing() {
        QFETCH(QByteArray, photo);
        const auto inside = found(photo.toStdString());
        QCOMPARE(complaint_about_motion(photo.toStdString()), std::string());
        if (!QByteArray(QTest::currentDataTag()).startsWith("Samsung's list, byte"))
            QVERIFY(!inside);
    }

    void the_corpus_and_its_mutants() {
        const std::vector<Seed> seeds = corpus(tp::test::in_source("tests/app/album/metadata/motion_corpus"));
        QVERIFY(seeds.size() >= 6);
        for (const Seed& input : seeds) {
            const std::string complaint = complaint_about_motion(input.text);
            QVERIFY2(complaint.empty(), (input.name + ": " + complaint).c_str());
        }
        ByteMutator mutator(seed);
        int with_video = 0;
        for (int i = 0; i < mutated_photos; ++i) {
            const std::string bytes = mutator.mutant(seeds);
            const std::string complaint = complaint_about_motion(bytes);
            QVERIFY2(complaint.empty(), (std::to_string(i) + ": " + complaint).c_str());
            with_video += found(bytes) ? 1 : 0;
        }
        QVERIFY2(with_video > mutated_photos / 20, std::to_string(with_video).c_str());
    }
};

} // namespace motion_photo_test

TP_TEST(motion_photo_test, MotionPhotoTest, event_loop)
#include "motion_photo_test.moc"
