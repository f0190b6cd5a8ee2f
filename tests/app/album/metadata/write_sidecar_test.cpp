// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/files/durable_file.hpp"
#include "made_photo.hpp"
#include "random_changes.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <filesystem>
#include <set>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace write_sidecar_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

const std::string foreign = "http://example.org/foreign/";

SidecarChanges keyword(const std::string& word) {
    SidecarChanges changes;
    changes.keywords = {word};
    return changes;
}

SidecarChanges faces(std::vector<FaceRegion> list) {
    SidecarChanges changes;
    changes.faces = std::move(list);
    return changes;
}

SidecarChanges changes_of(const PhotoRecord& record) {
    return {record.alt_text, record.description, record.faces,       record.persons,
            record.keywords, record.tags,        record.content_hash};
}

} // namespace

class WriteSidecarTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path photo_;
    fs::path sidecar_;
    std::string photo_bytes_;

    PhotoRecord record() const { return *read_record(photo_); }
    XmpPacket packet_in(const fs::path& file) const {
        auto packet = XmpPacket::from(bytes_of(file));
        if (!packet)
            qFatal("%s", packet.error().c_str());
        return std::move(*packet);
    }
    std::vector<std::string> list(const XmpName& name) const {
        return texts_of(packet_in(sidecar_).value(name).value_or(XmpValue{}));
    }

private slots:
    void a_sidecar_is_no_more_open_than_its_photograph() {
        ::umask(022);
        const auto mode = [&] { return fs::status(sidecar_).permissions(); };
        QCOMPARE(write_sidecar(photo_, keyword("one")), std::string());
        QCOMPARE(mode(), fs::perms(0600));
        ::chmod(sidecar_.c_str(), 0666); // as somebody wants it
        ::chmod(photo_.c_str(), 0644);
        QCOMPARE(write_sidecar(photo_, keyword("two")), std::string());
        QCOMPARE(mode(), fs::perms(0644));
        ::chmod(photo_.c_str(), 0600);
        QCOMPARE(write_sidecar(photo_, keyword("three")), std::string());
        QCOMPARE(mode(), fs::perms(0600));
    }

    void init() {
        const fs::path folder = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(folder);
        photo_ = folder / "IMG_1.jpg";
        sidecar_ = folder / "IMG_1.jpg.xmp";
        MadeMetadata made;
        made.exif["Exif.Photo.DateTimeOriginal"] = "2026:05:01 10:15:00";
        write_bytes(photo_, jpeg_bytes(400, 300));
        add_metadata(photo_, made);
        photo_bytes_ = bytes_of(photo_);
    }
    void cleanup() {
        QCOMPARE(bytes_of(photo_), photo_bytes_);
        for (const auto& entry : fs::directory_iterator(photo_.parent_path()))
            QVERIFY2(!is_temporary(entry.path()), entry.path().c_str());
    }

    void what_is_written_is_read() {
        std::mt19937_64 random(20260501);
        for (int i = 0; i < 100; ++i) {
            const SidecarChanges changes = random_changes(random);
            QCOMPARE(write_sidecar(photo_, changes), std::string());
            const PhotoRecord read = record();
            QVERIFY2(changes_of(read) == changes, std::to_string(i).c_str());
            QVERIFY(read.problems.empty());
            QCOMPARE(read.taken, std::string("2026-05-01T10:15:00"));
        }
        QCOMPARE(fs::file_size(sidecar_) < 100'000, true); // what is replaced leaves nothing behind
    }

    void only_what_is_named_changes() {
        std::mt19937_64 random(7);
        const SidecarChanges all = random_changes(random);
        QCOMPARE(write_sidecar(photo_, all), std::string());
        QCOMPARE(write_sidecar(photo_, keyword("sea")), std::string());
        SidecarChanges expected = all;
        expected.keywords = {"sea"};
        QVERIFY(changes_of(record()) == expected);
        const std::string before = bytes_of(sidecar_);
        QCOMPARE(write_sidecar(photo_, SidecarChanges{}), std::string());
        QCOMPARE(bytes_of(sidecar_), before);
    }

    void unknown_properties_survive() {
        std::mt19937_64 random(11);
        for (int i = 0; i < 40; ++i) {
            XmpPacket others;
            std::vector<std::pair<XmpName, XmpValue>> kept;
            for (int k = 0; k < 8; ++k) {
                const XmpName name{k % 2 == 0 ? foreign : xmp::iptc_ext_uri,
                                   std::string(1, static_cast<char>('a' + k))};
                XmpValue value = XmpValue::of(random_text(random));
                if (k % 3 == 0) {
                    XmpValue bag;
                    bag.form = XmpValue::Form::seq;
                    value.qualifiers = {{xmp::language, XmpValue::of("de")}};
                    bag.items = {value, XmpValue::of(random_text(random))};
                    value = bag;
                } else if (k % 3 == 1) {
                    XmpValue structure;
                    structure.form = XmpValue::Form::structure;
                    structure.set_field({foreign, "f"}, value);
                    value = structure;
                }
                others.set(name, value);
                kept.emplace_back(name, value);
            }
            write_bytes(sidecar_, others.bytes());
            for (int k = 0; k < 3; ++k)
                QCOMPARE(write_sidecar(photo_, random_changes(random)), std::string());
            const XmpPacket after = packet_in(sidecar_);
            for (const auto& [name, value] : kept)
                QVERIFY2(after.value(name) == value, name.name.c_str());
            fs::remove(sidecar_);
        }
    }

    void named_faces_come_first() {
        QCOMPARE(write_sidecar(photo_, faces({{0.1, 0.1, 0.1, 0.1, ""}, {0.5, 0.5, 0.1, 0.1, "Anna"}})),
                 std::string());
        QCOMPARE(record().faces.at(0).name, std::string("Anna"));
        QCOMPARE(record().faces.at(1).name, std::string());
    }

    void names_appear_where_other_programs_look() {
        write_bytes(
            sidecar_,
            packet("", "<digiKam:TagsList><rdf:Seq><rdf:li>Places/Graz</rdf:li><rdf:li>People/Zoe</rdf:li>"
                       "</rdf:Seq></digiKam:TagsList><lr:hierarchicalSubject><rdf:Bag>"
                       "<rdf:li>Places|Graz</rdf:li></rdf:Bag></lr:hierarchicalSubject>"));
        QCOMPARE(write_sidecar(photo_, faces({{0.5, 0.5, 0.1, 0.1, "Anna"}, {0.1, 0.5, 0.1, 0.1, "B/C|D"}})),
                 std::string());
        QCOMPARE(record().persons, (std::vector<std::string>{"Anna", "B/C|D"}));
        QCOMPARE(list(xmp::digikam_tags),
                 (std::vector<std::string>{"Places/Graz", "People/Zoe", "People/Anna", "People/B-C|D"}));
        QCOMPARE(list(xmp::lightroom_tags),
                 (std::vector<std::string>{"Places|Graz", "People|Anna", "People|B/C-D"}));

        QCOMPARE(write_sidecar(photo_, faces({{0.5, 0.5, 0.1, 0.1, "Eva"}})), std::string());
        QCOMPARE(record().persons, (std::vector<std::string>{"Eva"}));
        QCOMPARE(list(xmp::digikam_tags),
                 (std::vector<std::string>{"Places/Graz", "People/Zoe", "People/Eva"}));

        SidecarChanges persons;
        persons.persons = {"Omar"};
        QCOMPARE(write_sidecar(photo_, persons), std::string());
        QCOMPARE(record().persons, (std::vector<std::string>{"Omar", "Eva"})); // the face is still hers
    }

    void persons_of_the_photo_stay_when_a_face_gets_a_name() {
        MadeMetadata made;
        made.xmp = packet(
            "",
            "<Iptc4xmpExt:PersonInImage><rdf:Bag><rdf:li>Ben</rdf:li></rdf:Bag></Iptc4xmpExt:PersonInImage>"
            "<digiKam:TagsList><rdf:Seq><rdf:li>Places/Graz</rdf:li></rdf:Seq></digiKam:TagsList>");
        add_metadata(photo_, made);
        photo_bytes_ = bytes_of(photo_);
        QCOMPARE(write_sidecar(photo_, faces({{0.5, 0.5, 0.1, 0.1, "Anna"}})), std::string());
        QCOMPARE(record().persons, (std::vector<std::string>{"Ben", "Anna"}));
        QCOMPARE(list(xmp::digikam_tags),
                 (std::vector<std::string>{"Places/Graz", "People/Ben", "People/Anna"}));
    }

    void nothing_hides_what_the_photo_says() {
        MadeMetadata made;
        made.xmp = packet(
            "",
            "<Iptc4xmpExt:PersonInImage><rdf:Bag><rdf:li>Ben</rdf:li></rdf:Bag></Iptc4xmpExt:PersonInImage>"
            "<dc:subject><rdf:Bag><rdf:li>sea</rdf:li></rdf:Bag></dc:subject>"
            "<dc:description><rdf:Alt><rdf:li "
            "xml:lang='x-default'>Caption</rdf:li></rdf:Alt></dc:description>"
            "<MP:RegionInfo rdf:parseType='Resource'><MPRI:Regions><rdf:Bag><rdf:li "
            "MPReg:Rectangle='0.1,0.1,0.1,0.1' "
            "MPReg:PersonDisplayName='Ben'/></rdf:Bag></MPRI:Regions></MP:RegionInfo>");
        add_metadata(photo_, made);
        photo_bytes_ = bytes_of(photo_);
        QCOMPARE(record().faces.size(), std::size_t{1});
        SidecarChanges nothing{LanguageTexts{}, LanguageTexts{}, {{}}, {{}}, {{}}, {{}}, ""};
        QCOMPARE(write_sidecar(photo_, nothing), std::string());
        const PhotoRecord read = record();
        QVERIFY(read.faces.empty() && read.persons.empty() && read.keywords.empty() &&
                read.description.empty());
    }

    void what_others_said_of_a_region_stays_with_it() {
        write_bytes(
            sidecar_,
            packet("xmlns:f='" + foreign + "'",
                   "<mwg-rs:Regions rdf:parseType='Resource'><f:note>n</f:note><mwg-rs:RegionList><rdf:Bag>"
                   "<rdf:li "
                   "rdf:parseType='Resource'><mwg-rs:Type>Pet</mwg-rs:Type><mwg-rs:Name>Rex</mwg-rs:Name>"
                   "<mwg-rs:Area stArea:x='0.9' stArea:y='0.9' stArea:w='0.1' stArea:h='0.1'/></rdf:li>"
                   "<rdf:li rdf:parseType='Resource'><mwg-rs:Type>Face</mwg-rs:Type>"
                   "<mwg-rs:Area stArea:x='0.5' stArea:y='0.5' stArea:w='0.1' stArea:h='0.1'/>"
                   "<mwg-rs:Extensions "
                   "f:angle='270'/></rdf:li></rdf:Bag></mwg-rs:RegionList></mwg-rs:Regions>"));
        QCOMPARE(write_sidecar(photo_, faces({{0.5, 0.5, 0.1, 0.1, "Anna"}})), std::string());
        const auto regions = packet_in(sidecar_).value(xmp::regions);
        QCOMPARE(regions->field({foreign, "note"})->text, std::string("n"));
        const auto& items = regions->field(xmp::region_list)->items;
        QCOMPARE(items.size(), std::size_t{2});
        QCOMPARE(items[0].field(xmp::region_name)->text, std::string("Anna"));
        QCOMPARE(items[0].field({xmp::regions_uri, "Extensions"})->field({foreign, "angle"})->text,
                 std::string("270"));
        QCOMPARE(items[1].field(xmp::region_name)->text, std::string("Rex"));
        QCOMPARE(regions->field(xmp::applied_to)->field(xmp::dimensions_width)->text, std::string("400"));
    }

    void microsoft_regions_follow() {
        write_bytes(
            sidecar_,
            packet("xmlns:f='" + foreign + "'",
                   "<MP:RegionInfo rdf:parseType='Resource'><MPRI:Regions><rdf:Bag>"
                   "<rdf:li MPReg:Rectangle='0.1,0.1,0.1,0.1' MPReg:PersonDisplayName='Ben' f:id='7'/>"
                   "</rdf:Bag></MPRI:Regions></MP:RegionInfo>"));
        QCOMPARE(write_sidecar(photo_, faces({{0.5, 0.5, 0.5, 0.25, "Ben"}})), std::string());
        XmpPacket after = packet_in(sidecar_);
        after.remove(xmp::regions);
        const RecordParts parts = parts_from_xmp(after, {});
        QVERIFY(parts.faces == (std::vector<FaceRegion>{{0.5, 0.5, 0.5, 0.25, "Ben"}}));
        QVERIFY(after.bytes().find(">7<") != std::string::npos);
    }

    void a_field_of_a_newer_program_stays_with_its_tag() {
        write_bytes(sidecar_, packet("xmlns:f='" + foreign + "'",
                                     "<tp:tags><rdf:Seq><rdf:li tp:file='a.flac' tp:kind='memo' "
                                     "f:mood='glad'/></rdf:Seq></tp:tags>"));
        SidecarChanges changes;
        changes.tags = record().tags;
        changes.tags->at(0).order = 3;
        changes.tags->push_back({"b.flac", {}, 0.0, 0.0, 0});
        QCOMPARE(write_sidecar(photo_, changes), std::string());
        const auto tags = packet_in(sidecar_).value(xmp::tags);
        QCOMPARE(tags->items.at(0).field({foreign, "mood"})->text, std::string("glad"));
        QCOMPARE(tags->items.at(0).field(xmp::tag_order)->text, std::string("3"));
        QCOMPARE(tags->items.size(), std::size_t{2});
    }

    void it_starts_with_what_lightroom_wrote_for_this_file() {
        const fs::path lightroom = photo_.parent_path() / "IMG_1.xmp";
        const std::string text = packet("xmlns:crs='http://ns.adobe.com/camera-raw-settings/1.0/' "
                                        "crs:Exposure='+0.50' photoshop:SidecarForExtension='JPG'",
                                        "");
        write_bytes(lightroom, text);
        QCOMPARE(write_sidecar(photo_, keyword("sea")), std::string());
        QVERIFY(bytes_of(sidecar_).find("crs:Exposure") != std::string::npos);
        QCOMPARE(bytes_of(lightroom), text);
        fs::remove(sidecar_);
        write_bytes(lightroom, packet("photoshop:SidecarForExtension='NEF' photoshop:City='Graz'", ""));
        QCOMPARE(write_sidecar(photo_, keyword("sea")), std::string());
        QVERIFY(bytes_of(sidecar_).find("Graz") == std::string::npos); // the raw file's own settings
        QCOMPARE(record().place_name, std::string("Graz"));
    }

    void an_unreadable_sidecar_is_left_as_it_is() {
        for (const std::string& text :
             {std::string("<rdf:RDF"), std::string("\xFF\xFE<\0", 4), std::string("not XMP"),
              std::string("<rdf:RDF xmlns:rdf='" + xmp::rdf_uri + "'>\xFC</rdf:RDF>")}) {
            write_bytes(sidecar_, text);
            const std::string sentence = write_sidecar(photo_, keyword("sea"));
            QVERIFY(sentence.ends_with('.'));
            QVERIFY(sentence.find("IMG_1.jpg.xmp") != std::string::npos);
            QCOMPARE(bytes_of(sidecar_), text);
        }
        write_bytes(sidecar_, "");
        QCOMPARE(write_sidecar(photo_, keyword("sea")), std::string());
    }

    void the_spelling_that_is_there_is_kept() {
        const fs::path upper = photo_.parent_path() / "IMG_1.jpg.XMP";
        write_bytes(upper, packet("", ""));
        QCOMPARE(write_sidecar(photo_, keyword("sea")), std::string());
        QVERIFY(!fs::exists(sidecar_));
        QCOMPARE(record().keywords, (std::vector<std::string>{"sea"}));
    }

    void what_makes_no_sense_is_refused() {
        for (const char* file : {"../x", "/etc/passwd", "", "a/b", "a\\b", "\xFF.flac"}) {
            SidecarChanges changes;
            changes.tags = {{file, {}, 0.0, 0.0, 0}};
            QVERIFY2(!write_sidecar(photo_, changes).empty(), file);
        }
        SidecarChanges twice;
        twice.tags = {{"a", {}, 0.0, 0.0, 0}, {"a", {}, 0.0, 0.0, 0}};
        QVERIFY(!write_sidecar(photo_, twice).empty());
        QVERIFY(!write_sidecar(photo_, faces({{2.0, 0.5, 0.1, 0.1, "Anna"}})).empty());
        QVERIFY(!write_sidecar(photo_, faces({{std::nan(""), 0.5, 0.1, 0.1, "Anna"}})).empty());
        QVERIFY(!write_sidecar(photo_.parent_path() / "none.jpg", keyword("sea")).empty());
        QVERIFY(!fs::exists(sidecar_));
    }

    void what_xml_cannot_hold_is_left_out() {
        QCOMPARE(write_sidecar(photo_, keyword(std::string("a\0b\x01\xFF", 5))), std::string());
        QCOMPARE(record().keywords, (std::vector<std::string>{"ab\uFFFD"}));
    }

    void a_read_only_folder_is_told() {
        if (::geteuid() == 0)
            QSKIP("root may write anywhere");
        ::chmod(photo_.parent_path().c_str(), 0500);
        const std::string sentence = write_sidecar(photo_, keyword("sea"));
        ::chmod(photo_.parent_path().c_str(), 0700);
        QVERIFY(sentence.find("not allowed") != std::string::npos);
    }

    void our_own_writers_lose_nothing() {
        constexpr int writers = 4;
        constexpr int writes = 25;
        std::vector<std::thread> threads;
        std::atomic<int> failures{0};
        for (int i = 0; i < writers; ++i)
            threads.emplace_back([&, i] {
                for (int k = 0; k < writes; ++k) {
                    SidecarChanges changes; // each its own field
                    const std::string text = std::to_string(k);
                    if (i == 0)
                        changes.keywords = {text};
                    else if (i == 1)
                        changes.alt_text = LanguageTexts{{"en", text}};
                    else if (i == 2)
                        changes.description = LanguageTexts{{"en", text}};
                    else
                        changes.content_hash = text;
                    failures += write_sidecar(photo_, changes).empty() ? 0 : 1;
                }
            });
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(failures.load(), 0);
        const PhotoRecord read = record();
        const std::string last = std::to_string(writes - 1);
        QCOMPARE(read.keywords, (std::vector<std::string>{last}));
        QCOMPARE(read.alt_text, (LanguageTexts{{"en", last}}));
        QCOMPARE(read.description, (LanguageTexts{{"en", last}}));
        QCOMPARE(read.content_hash, last);
    }

    /// A second program that knows nothing of ours replaces the sidecar again and again; what it wrote last
    /// is there in the end, and so is what we wrote last.
    void a_second_program_loses_nothing() {
        std::atomic<bool> stop{false};
        std::string theirs;
        std::thread other([&] {
            for (int i = 0; !stop; ++i) {
                theirs = std::to_string(i);
                static_cast<void>(
                    replace_file(sidecar_, packet("xmlns:f='" + foreign + "' f:count='" + theirs + "'", "")));
                std::this_thread::sleep_for(std::chrono::milliseconds(i % 7));
            }
        });
        for (int i = 0; i < 60; ++i) {
            std::string sentence = write_sidecar(photo_, keyword(std::to_string(i)));
            while (sentence.find("keeps writing") !=
                   std::string::npos) // on a slow machine: then a person asks again
                sentence = write_sidecar(photo_, keyword(std::to_string(i)));
            QVERIFY2(sentence.empty(), sentence.c_str());
        }
        stop = true;
        other.join();
        QCOMPARE(write_sidecar(photo_, keyword("last")), std::string());
        QCOMPARE(packet_in(sidecar_).value({foreign, "count"})->text, theirs);
        QCOMPARE(record().keywords, (std::vector<std::string>{"last"}));
    }
};

} // namespace write_sidecar_test

TP_TEST(write_sidecar_test, WriteSidecarTest, event_loop)
#include "write_sidecar_test.moc"
