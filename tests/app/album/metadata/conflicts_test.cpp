// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "made_photo.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace conflicts_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* syncthing = "IMG_1.jpg.sync-conflict-20260501-101500-ABCDEFG.xmp";

bool tells(const std::vector<std::string>& sentences, const std::string& word) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& s) { return s.find(word) != std::string::npos; });
}

Tag tag(const std::string& file, const std::string& speaker, const std::string& transcript) {
    Tag result;
    result.file = file;
    result.label.speaker = speaker;
    result.label.transcript = transcript;
    return result;
}

} // namespace

class ConflictsTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path photo_;
    fs::path sidecar_;
    fs::path trash_;
    std::string photo_bytes_;

    /// Writes changes as a sidecar of their own and gives it a conflict copy's name.
    fs::path copy_with(const SidecarChanges& changes, const std::string& name) {
        const fs::path aside = sidecar_.parent_path() / "aside";
        const bool there = fs::exists(sidecar_);
        if (there)
            fs::rename(sidecar_, aside);
        if (const std::string sentence = write_sidecar(photo_, changes); !sentence.empty())
            qFatal("%s", sentence.c_str());
        const fs::path copy = sidecar_.parent_path() / name;
        fs::rename(sidecar_, copy);
        if (there)
            fs::rename(aside, sidecar_);
        return copy;
    }
    static void make_newer(const fs::path& file, const fs::path& than) {
        fs::last_write_time(file, fs::last_write_time(than) + std::chrono::hours(1));
    }
    std::vector<std::string> merge() {
        auto sentences = merge_conflicts(photo_, trash_);
        if (!sentences)
            qFatal("%s", sentences.error().c_str());
        return *sentences;
    }

private slots:
    void init() {
        const fs::path folder = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(folder);
        photo_ = folder / "IMG_1.jpg";
        sidecar_ = folder / "IMG_1.jpg.xmp";
        trash_ = folder / ".touchphoto" / "trash";
        write_bytes(photo_, jpeg_bytes(400, 300));
        photo_bytes_ = bytes_of(photo_);
    }
    void cleanup() { QCOMPARE(bytes_of(photo_), photo_bytes_); }

    void names_data() {
        QTest::addColumn<QString>("original");
        const auto row = [](const char* name, const char* original) { QTest::newRow(name) << original; };
        row(syncthing, "IMG_1.jpg.xmp");
        row("IMG_1.jpg.sync-conflict-20150501-101500.xmp", "IMG_1.jpg.xmp");
        row("IMG_1.sync-conflict-20260501-101500-ABCDEFG.xmp", "IMG_1.xmp");
        row("IMG_1.sync-conflict-20260501-101500-ABCDEFG.jpg.xmp", ""); // the sidecar of a photograph's copy
        row("IMG_1.jpg (conflicted copy 2026-05-01 101500).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (conflicted copy Anna B. 2026-05-01 101500).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg_conflict-20260501-101500.xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg_conflict-Anna-20260501-101500.xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (Anna's conflicted copy 2026-05-01).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (Anna's MacBook's conflicted copy 2026-05-01 (2)).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (case clash from Anna).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (Case Conflict 1).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (SFConflict anna@example.org 2026-05-01-10-15-00).xmp", "IMG_1.jpg.xmp");
        row("IMG_1.jpg (conflicted copy 2026-05-01 101500) (conflicted copy 2026-05-02 101500).xmp",
            "IMG_1.jpg.xmp");
        row("2026-05-01T101500-memo.sync-conflict-20260501-101500-ABCDEFG.flac",
            "2026-05-01T101500-memo.flac");
        row("IMG_1.jpg.xmp", "");
        row("IMG_1 (1).jpg.xmp", "");
        row("a_conflict-of-interest.jpg.xmp", "");
        row("", "");
    }
    void names() {
        QFETCH(QString, original);
        QCOMPARE(QString::fromStdString(conflict_original(QTest::currentDataTag()).value_or("")), original);
    }

    void no_copy_no_word() {
        QVERIFY(merge().empty());
        QVERIFY(!fs::exists(sidecar_));
        QVERIFY(!fs::exists(trash_));
    }

    void both_versions_are_kept() {
        SidecarChanges here;
        here.alt_text = LanguageTexts{{"en", "here"}, {"de", "hier"}};
        here.keywords = {"sea", "both"};
        here.faces = {{0.2, 0.2, 0.1, 0.1, "Anna"}, {0.8, 0.8, 0.1, 0.1, ""}};
        here.tags = {tag("a.flac", "Anna", ""), tag("both.flac", "Anna", "spoken here")};
        SidecarChanges there;
        there.alt_text = LanguageTexts{{"en", "there"}, {"fr", "là"}};
        there.keywords = {"both", "snow"};
        there.faces = {
            {0.21, 0.2, 0.1, 0.1, "Anne"}, {0.8, 0.8, 0.1, 0.1, "Ben"}, {0.5, 0.5, 0.1, 0.1, "Eva"}};
        there.tags = {tag("both.flac", "Ben", ""), tag("b.flac", "Ben", "")};
        there.content_hash = "abc";

        QCOMPARE(write_sidecar(photo_, here), std::string());
        const fs::path copy = copy_with(there, syncthing);
        const std::string copy_bytes = bytes_of(copy);
        make_newer(copy, sidecar_);
        const auto sentences = merge();

        const PhotoRecord read = *read_record(photo_);
        QCOMPARE(read.alt_text, (LanguageTexts{{"en", "here"}, {"de", "hier"}, {"fr", "là"}}));
        QCOMPARE(read.keywords, (std::vector<std::string>{"sea", "both", "snow"}));
        QCOMPARE(read.persons, (std::vector<std::string>{"Anna", "Anne", "Ben", "Eva"}));
        QCOMPARE(read.faces.size(), std::size_t{3});
        QCOMPARE(read.tags.size(), std::size_t{3});
        QCOMPARE(read.tags[1].label.speaker, std::string("Ben")); // the newer
        QCOMPARE(read.tags[1].label.transcript, std::string("spoken here"));
        QCOMPARE(read.content_hash, std::string("abc"));
        for (const char* word :
             {"\"there\"", "\"Anne\"", "\"Anna\" in another copy", "trash", "\"both.flac\""})
            QVERIFY2(tells(sentences, word), word);

        QVERIFY(!fs::exists(copy));
        QCOMPARE(bytes_of(trash_ / syncthing), copy_bytes);
        QVERIFY(merge().empty());
    }

    void the_older_label_is_told() {
        SidecarChanges changes;
        changes.tags = {tag("a.flac", "Anna", "")};
        QCOMPARE(write_sidecar(photo_, changes), std::string());
        changes.tags = {tag("a.flac", "Ben", "")};
        const fs::path copy = copy_with(changes, syncthing);
        make_newer(sidecar_, copy);
        const auto sentences = merge();
        QCOMPARE(read_record(photo_)->tags.at(0).label.speaker, std::string("Anna"));
        QVERIFY(tells(sentences, "\"Ben\" in another copy"));
    }

    void a_copy_without_a_sidecar_becomes_one() {
        SidecarChanges changes;
        changes.keywords = {"sea"};
        copy_with(changes, "IMG_1.jpg (Anna's conflicted copy 2026-05-01).xmp");
        QCOMPARE(merge().size(), std::size_t{1});
        QCOMPARE(read_record(photo_)->keywords, (std::vector<std::string>{"sea"}));
    }

    void what_other_programs_wrote_is_not_lost() {
        const std::string foreign = "http://example.org/foreign/";
        write_bytes(
            sidecar_,
            packet("xmlns:f='" + foreign + "' f:a='1' f:b='1'",
                   "<digiKam:TagsList><rdf:Seq><rdf:li>Places/Graz</rdf:li></rdf:Seq></digiKam:TagsList>"));
        write_bytes(
            sidecar_.parent_path() / syncthing,
            packet("xmlns:f='" + foreign + "' f:b='2' f:c='2'",
                   "<digiKam:TagsList><rdf:Seq><rdf:li>Places/Linz</rdf:li></rdf:Seq></digiKam:TagsList>"));
        const auto sentences = merge();
        const auto after = XmpPacket::from(bytes_of(sidecar_));
        QCOMPARE(after->value({foreign, "a"})->text, std::string("1"));
        QCOMPARE(after->value({foreign, "b"})->text, std::string("1"));
        QCOMPARE(after->value({foreign, "c"})->text, std::string("2"));
        QCOMPARE(after->value(xmp::digikam_tags)->items.size(), std::size_t{2});
        QVERIFY(tells(sentences, "differs in: b"));
    }

    void several_copies_and_a_name_taken_in_the_trash() {
        for (int i = 0; i < 3; ++i) {
            SidecarChanges changes;
            changes.keywords = {std::to_string(i)};
            copy_with(changes,
                      i < 2 ? "IMG_1.jpg (conflicted copy 2026-05-0" + std::to_string(i + 1) + " 101500).xmp"
                            : syncthing);
        }
        fs::create_directories(trash_);
        write_bytes(trash_ / syncthing, "an earlier one");
        QCOMPARE(merge().size(), std::size_t{3});
        QCOMPARE(read_record(photo_)->keywords.size(), std::size_t{3});
        QCOMPARE(bytes_of(trash_ / syncthing), std::string("an earlier one"));
        QCOMPARE(std::distance(fs::directory_iterator(trash_), fs::directory_iterator()), std::ptrdiff_t{4});
    }

    void an_unreadable_copy_stays() {
        write_bytes(sidecar_.parent_path() / syncthing, "<rdf:RDF");
        const auto sentences = merge();
        QVERIFY(tells(sentences, "stays where it is"));
        QVERIFY(fs::exists(sidecar_.parent_path() / syncthing));
    }

    /// Also those of the sidecar that is named by the stem, which two photographs share.
    void a_copy_belongs_to_the_photographs_of_its_name_and_stem() {
        const fs::path folder = photo_.parent_path();
        const std::string mark = ".sync-conflict-20260501-101500-ABCDEFG";
        const fs::path whole = folder / ("IMG_1.jpg" + mark + ".xmp"),
                       shared = folder / ("IMG_1" + mark + ".XMP");
        for (const fs::path& copy : {whole, shared})
            write_bytes(copy, packet("", ""));
        make_newer(whole, shared);
        write_bytes(folder / ("IMG_1.jpg" + mark + ".jpg"), "another machine's photograph");
        write_bytes(folder / "IMG_1 (1).jpg.xmp", packet("", ""));
        fs::create_symlink(whole, folder / ("IMG_1.jpg.sync-conflict-20260502-101500-ABCDEFG.xmp"));
        ConflictCopies copies;
        QVERIFY(copies.of(photo_) == (std::vector<fs::path>{shared, whole})); // oldest first
        QVERIFY(copies.of(folder / "IMG_1.nef") == std::vector<fs::path>{shared});
        QVERIFY(copies.of(folder / "IMG_1") == std::vector<fs::path>{shared}); // its own name
        QVERIFY(copies.of(folder / "IMG_2.jpg").empty());
        QVERIFY(copies.of(folder / "elsewhere" / "IMG_1.jpg").empty());
        fs::remove(shared);
        QVERIFY(copies.of(photo_) == std::vector<fs::path>{whole});
        QVERIFY(copies.of(folder / "IMG_1.nef").empty());
    }

    void another_photos_copy_is_not_ours() {
        write_bytes(sidecar_.parent_path() / "IMG_11.jpg.sync-conflict-20260501-101500-ABCDEFG.xmp",
                    packet("", ""));
        write_bytes(sidecar_.parent_path() / "IMG_1.png.sync-conflict-20260501-101500-ABCDEFG.xmp",
                    packet("", ""));
        QVERIFY(ConflictCopies().of(photo_).empty());
    }

    /// What ours displaced may say what a person has taken away since.
    void of_a_displaced_sidecar_keywords_are_brought_in_and_no_recording_comes_back() {
        SidecarChanges before;
        before.keywords = {"lake"};
        before.tags = {tag("deleted.flac", "Anna", {})};
        const fs::path displaced = copy_with(before, ".touchphoto-1-0.tmp");
        SidecarChanges now;
        now.tags = {tag("kept.flac", "Anna", {})};
        QCOMPARE(write_sidecar(photo_, now), std::string());
        QVERIFY(merge_foreign(photo_, displaced).ok());
        const auto record = read_record(photo_);
        QCOMPARE(record->keywords, std::vector<std::string>{"lake"});
        QCOMPARE(record->tags.size(), std::size_t{1});
        QCOMPARE(record->tags[0].file, std::string("kept.flac"));
    }
};

} // namespace conflicts_test

TP_TEST(conflicts_test, ConflictsTest, event_loop)
#include "conflicts_test.moc"
