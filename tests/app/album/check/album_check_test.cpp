// SPDX-License-Identifier: Apache-2.0
#include "album_of_one.hpp"
#include "app/album/check/album_check.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/recording_file.hpp"

#include <QTest>

#include <algorithm>
#include <sys/stat.h>

using namespace tp;
namespace fs = std::filesystem;
using Kind = Finding::Kind;

class AlbumCheckTest : public QObject {
    Q_OBJECT

    /// What one check finds, by kind; a second one after mending finds what cannot be mended.
    static std::vector<Kind> kinds(const CheckReport& report) {
        std::vector<Kind> found;
        for (const Finding& finding : report.findings)
            found.push_back(finding.kind);
        return found;
    }
    static CheckReport check(const AlbumFolder& album, bool mend) {
        CheckOptions options;
        options.mend = mend;
        const auto report = check_album(album.path(), options);
        return report ? *report : CheckReport{};
    }

    /// Finds exactly this without writing anything, mends it, and then finds nothing.
    static void found_and_mended(const AlbumFolder& album, Kind kind) {
        const auto before = album.files();
        const CheckReport looked = check(album, false);
        QCOMPARE(kinds(looked), std::vector<Kind>{kind});
        QVERIFY(!looked.findings[0].mended && !looked.findings[0].mend.empty());
        QVERIFY(album.files() == before);
        const CheckReport mended = check(album, true);
        QCOMPARE(kinds(mended), std::vector<Kind>{kind});
        QVERIFY2(mended.findings[0].mended, mended.findings[0].problem.c_str());
        QCOMPARE(kinds(check(album, false)), std::vector<Kind>{});
    }

private slots:
    void an_album_in_order_has_nothing_found() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.name_face(album.photo, {0.5, 0.5, 0.2, 0.2, "Anna"}), std::string());
        album.folder.write("2026/IMG_9.xmp", "another program's, of a film");
        album.folder.write("2026/notes.txt", "x");
        const CheckReport report = check(album.folder, false);
        QCOMPARE(kinds(report), std::vector<Kind>{});
        QCOMPARE(report.photos, std::size_t{1});
        QCOMPARE(report.recordings, std::size_t{1});
        QVERIFY(!check_album(album.folder / "missing").ok());
    }

    void half_written_files_are_deleted() {
        AlbumOfOne album;
        album.folder.write("2026/.touchphoto-999999999-0.tmp", "half");
        found_and_mended(album.folder, Kind::half_written);
        album.folder.write("2026/.touchphoto-999999999-1.tmp", album.folder.read("2026/IMG_1.jpg.xmp"));
        found_and_mended(album.folder, Kind::half_written);
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
    }

    /// Killed between taking the place of what exiftool had just written and looking at it. Our own words in it are of before.
    void what_another_program_wrote_at_that_moment_is_brought_in() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.name_face(album.photo, {0.5, 0.5, 0.2, 0.3, "Anna"}), std::string());
        std::string theirs = album.folder.read("2026/IMG_1.jpg.xmp");
        const std::string end = "</rdf:RDF>";
        theirs.insert(theirs.find(end),
                      R"(<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/"
                         xmlns:xmp="http://ns.adobe.com/xap/1.0/" xmp:Rating="4"><dc:subject><rdf:Bag>
                         <rdf:li>lake</rdf:li></rdf:Bag></dc:subject></rdf:Description>)");
        QCOMPARE(album.keeper.name_face(album.photo, {0.5, 0.5, 0.2, 0.3, "Berta"}), std::string());
        album.folder.write("2026/.touchphoto-999999999-0.tmp", theirs);
        found_and_mended(album.folder, Kind::half_written);
        const auto record = read_record(album.photo);
        QCOMPARE(record->keywords, std::vector<std::string>{"lake"});
        QCOMPARE(record->persons, std::vector<std::string>{"Berta"});
        QVERIFY(album.folder.read("2026/IMG_1.jpg.xmp").find("Rating") != std::string::npos);
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
    }

    void a_file_that_is_being_written_is_left_alone() {
        AlbumOfOne album;
        auto file = NewFile::beside(album.folder / "2026/x");
        QVERIFY(file.ok());
        QCOMPARE(kinds(check(album.folder, true)), std::vector<Kind>{});
        QVERIFY(fs::exists(file->temporary()));
    }

    void a_recording_that_a_crash_stopped_is_finished_and_listed() {
        AlbumOfOne album;
        {
            auto part = start_recording(tags_folder(album.photo),
                                        {{RecordingKind::story, "Tom", {}, {}, {}, {}}, {}});
            QVERIFY2(part.ok(), part.error().c_str());
            const std::vector<std::int16_t> samples(48'000, 100);
            QCOMPARE(part->append(samples), std::string());
            QCOMPARE(part->sync(), std::string());
        }
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{Kind::unfinished_recording});
        QCOMPARE(kinds(check(album.folder, true)),
                 (std::vector<Kind>{Kind::unfinished_recording, Kind::unlisted_recording}));
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{});
        const auto record = read_record(album.photo);
        QCOMPARE(record->tags.size(), std::size_t{2});
        QCOMPARE(record->tags[1].label.person, std::string("Tom"));
        QCOMPARE(record->tags[1].duration_s, 1.0);
    }

    void an_unlisted_recording_is_listed_by_its_comments() {
        AlbumOfOne album;
        fs::remove(album.folder / "2026/IMG_1.jpg.xmp");
        found_and_mended(album.folder, Kind::unlisted_recording);
        QCOMPARE(read_record(album.photo)->tags.at(0).label.person, std::string("Anna"));
    }

    void a_recording_that_is_gone_is_said_and_stays_on_the_list() {
        AlbumOfOne album;
        fs::remove(tags_folder(album.photo) / album.file);
        for (const bool mend : {true, false}) {
            const CheckReport report = check(album.folder, mend);
            QCOMPARE(kinds(report), std::vector<Kind>{Kind::missing_recording});
            QVERIFY(report.findings[0].mend.empty() && !report.findings[0].mended);
        }
        QCOMPARE(read_record(album.photo)->tags.size(), std::size_t{1});
    }

    void a_deletion_that_was_cut_off_is_finished() {
        AlbumOfOne album;
        QVERIFY(Trash(album.folder.path()).put({tags_folder(album.photo) / album.file}, "memo").ok());
        found_and_mended(album.folder, Kind::missing_recording);
        QVERIFY(read_record(album.photo)->tags.empty());
    }

    /// Where nobody named the album, a recording goes to the trash of the photograph's own folder.
    void a_folder_inside_the_album_may_have_a_trash_of_its_own() {
        AlbumOfOne album;
        const fs::path inner = a_photo(album.folder, "2027/IMG_7.jpg", 7);
        QCOMPARE(album_around(inner), inner.parent_path());
        AlbumKeeper keeper(album_around(inner));
        const auto added = keeper.add_recording(inner, album.sound, {});
        const auto listed = read_record(inner)->tags;
        QCOMPARE(keeper.delete_recording(inner, added->tag.file), std::string());
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{});
        SidecarChanges cut_off; // before the list was written
        cut_off.tags = listed;
        QCOMPARE(write_sidecar(inner, cut_off), std::string());
        found_and_mended(album.folder, Kind::missing_recording);
        QCOMPARE(album_around(inner), inner.parent_path());
    }

    void what_a_killed_import_had_unpacked_is_nobody_s_photograph() {
        AlbumOfOne album;
        a_photo(album.folder, ".touchphoto/import/2026/0/x.jpg", 8);
        album.folder.write(".touchphoto/import/2026/0/y.jpg.tags/1.flac", "half");
        const CheckReport report = check(album.folder, true);
        QCOMPARE(kinds(report), std::vector<Kind>{});
        QCOMPARE(report.photos, std::size_t{1});
    }

    void a_sidecar_that_cannot_be_read_makes_way() {
        AlbumOfOne album;
        album.folder.write("2026/IMG_1.jpg.xmp", "<x:xmpmeta this is no XML");
        QCOMPARE(kinds(check(album.folder, false)),
                 (std::vector<Kind>{Kind::unreadable_sidecar, Kind::unlisted_recording}));
        check(album.folder, true);
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{});
        QCOMPARE(read_record(album.photo)->tags.size(), std::size_t{1});
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
    }

    void what_a_moved_photograph_left_behind_follows_it() {
        AlbumOfOne album;
        fs::create_directory(album.folder / "2027");
        fs::rename(album.photo, album.folder / "2027/renamed.jpg");
        found_and_mended(album.folder, Kind::left_behind);
        QCOMPARE(read_record(album.folder / "2027/renamed.jpg")->tags.size(), std::size_t{1});
        QVERIFY(!fs::exists(tags_folder(album.photo)));
    }

    void what_a_deleted_photograph_left_behind_is_said() {
        AlbumOfOne album;
        fs::remove(album.photo);
        const auto before = album.folder.files();
        const CheckReport report = check(album.folder, true);
        QCOMPARE(kinds(report), std::vector<Kind>{Kind::left_behind});
        QVERIFY(report.findings[0].mend.empty());
        QVERIFY(album.folder.files() == before);
    }

    void a_photograph_that_another_program_changed_is_said() {
        AlbumOfOne album;
        album.folder.write("2026/IMG_1.jpg", album.folder.read("2026/IMG_1.jpg") + "edited");
        found_and_mended(album.folder, Kind::changed_photo);
    }

    void recordings_that_others_may_hear_are_shut() {
        AlbumOfOne album;
        ::chmod((tags_folder(album.photo) / album.file).c_str(), 0644);
        found_and_mended(album.folder, Kind::open_to_others);
        ::chmod(tags_folder(album.photo).c_str(), 0755);
        found_and_mended(album.folder, Kind::open_to_others);
    }

    void words_of_a_photograph_that_others_may_not_see_are_shut() {
        AlbumOfOne album;
        const fs::path sidecar = album.photo.string() + ".xmp";
        album.folder.write("2026/IMG_1.jpg.contours.svg", "<svg/>");
        const fs::path contours = contours_file(album.photo);
        ::chmod(sidecar.c_str(), 0644); // as the photograph
        ::chmod(contours.c_str(), 0644);
        ::chmod(album.photo.c_str(), 0644);
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{});
        for (const fs::path& file : {sidecar, contours}) {
            ::chmod(album.photo.c_str(), 0640);
            QCOMPARE(kinds(check(album.folder, false)).size(), std::size_t{2});
            ::chmod((file == sidecar ? contours : sidecar).c_str(), 0600);
            found_and_mended(album.folder, Kind::open_to_others);
            QCOMPARE(fs::status(file).permissions(), fs::perms(0640));
            ::chmod(sidecar.c_str(), 0644);
            ::chmod(contours.c_str(), 0644);
        }
    }

    void names_in_order_are_not_found() {
        AlbumOfOne album; // Anna is whom its recording is about
        QCOMPARE(album.keeper.keep_name_recording("Anna", album.sound), std::string());
        QCOMPARE(album.keeper.name_face(album.photo, {0.5, 0.5, 0.2, 0.2, "../Ô/Jörg %"}), std::string());
        QCOMPARE(album.keeper.keep_name_recording("../Ô/Jörg %", album.sound), std::string());
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{});
    }

    void a_name_that_cannot_be_heard_makes_way() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.keep_name_recording("Anna", album.sound), std::string());
        const fs::path place = album.keeper.place_of_name("Anna");
        fs::resize_file(place, fs::file_size(place) / 4);
        found_and_mended(album.folder, Kind::unreadable_recording);
        QVERIFY(!fs::exists(place));
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
        QCOMPARE(album.keeper.keep_name_recording("Anna", album.sound), std::string());
    }

    /// A kill between the name's recording and its place.
    void a_name_without_its_place_goes_there() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.keep_name_recording("Anna", album.sound), std::string());
        const fs::path place = album.keeper.place_of_name("Anna"),
                       stray = place.parent_path() / "undated-person.flac";
        fs::rename(place, stray);
        const std::string sound = album.folder.read(".touchphoto/people/undated-person.flac");
        found_and_mended(album.folder, Kind::unlisted_recording);
        QVERIFY(!fs::exists(stray));
        QVERIFY(album.folder.read(".touchphoto/people/Anna.flac") == sound);
        // where a name has been recorded before, that one stays
        fs::copy_file(place, stray);
        found_and_mended(album.folder, Kind::unlisted_recording);
        QVERIFY(!fs::exists(stray) && fs::exists(place));
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
    }

    void half_written_names_are_deleted() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.keep_name_recording("Anna", album.sound), std::string());
        const fs::path half = album.folder.write(".touchphoto/people/.touchphoto-999999999-1.tmp", "half");
        found_and_mended(album.folder, Kind::half_written);
        QVERIFY(!fs::exists(half));
    }

    void a_name_of_nobody_is_said_and_stays() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.keep_name_recording("Nobody here", album.sound), std::string());
        for (const bool mend : {false, true}) {
            const CheckReport report = check(album.folder, mend);
            QCOMPARE(kinds(report), std::vector<Kind>{Kind::left_behind});
            QVERIFY(report.findings[0].sentence.find("Nobody here") != std::string::npos);
            QVERIFY(report.findings[0].mend.empty());
        }
        // who is on a photograph whose sidecar cannot be read is not known to be nobody
        const std::string sidecar = album.folder.read("2026/IMG_1.jpg.xmp");
        album.folder.write("2026/IMG_1.jpg.xmp", "no XMP");
        const auto found = kinds(check(album.folder, false));
        QVERIFY(std::find(found.begin(), found.end(), Kind::left_behind) == found.end());
        album.folder.write("2026/IMG_1.jpg.xmp", sidecar);
        QVERIFY(album.keeper.name_recording("Nobody here").has_value());
    }

    void names_that_others_may_hear_are_shut() {
        AlbumOfOne album;
        QCOMPARE(album.keeper.keep_name_recording("Anna", album.sound), std::string());
        fs::permissions(album.keeper.place_of_name("Anna"), fs::perms::all);
        found_and_mended(album.folder, Kind::open_to_others);
        fs::permissions(album.keeper.place_of_name("Anna").parent_path(), fs::perms::all);
        found_and_mended(album.folder, Kind::open_to_others);
    }

    void languages_of_names_in_order_are_not_found() {
        AlbumOfOne album;
        QCOMPARE(NameLanguages(album.keeper).choose("Anna", "fr"), std::string());
        QCOMPARE(kinds(check(album.folder, false)), std::vector<Kind>{});
        ::chmod(NameLanguages(album.keeper).place_of("Anna").c_str(), 0644);
        found_and_mended(album.folder, Kind::open_to_others);
    }

    void a_language_that_cannot_be_read_makes_way() {
        AlbumOfOne album;
        NameLanguages names(album.keeper);
        QCOMPARE(names.choose("Anna", "fr"), std::string());
        album.folder.write(".touchphoto/people/Anna.language", "");
        ::chmod(names.place_of("Anna").c_str(), 0600);
        found_and_mended(album.folder, Kind::damaged_name_language);
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
        QCOMPARE(names.choose("Anna", "de"), std::string());
    }

    void a_language_without_its_place_goes_there() {
        AlbumOfOne album;
        NameLanguages names(album.keeper);
        QCOMPARE(names.choose("Anna", "fr"), std::string());
        const fs::path place = names.place_of("Anna"), stray = place.parent_path() / "A copy.language";
        fs::rename(place, stray);
        found_and_mended(album.folder, Kind::damaged_name_language);
        QCOMPARE(*names.of("Anna"), std::string("fr"));
        fs::rename(place, stray); // where there is another one, that one stays
        QCOMPARE(names.choose("Anna", "de"), std::string());
        found_and_mended(album.folder, Kind::damaged_name_language);
        QCOMPARE(*names.of("Anna"), std::string("de"));
        QVERIFY(!fs::exists(stray));
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
    }

    void a_language_of_nobody_s_name_is_said_and_stays() {
        AlbumOfOne album;
        QCOMPARE(NameLanguages(album.keeper).choose("Nobody here", "fr"), std::string());
        for (const bool mend : {false, true}) {
            const CheckReport report = check(album.folder, mend);
            QCOMPARE(kinds(report), std::vector<Kind>{Kind::left_behind});
            QVERIFY(report.findings[0].sentence.find("Nobody here") != std::string::npos);
            QVERIFY(report.findings[0].mend.empty());
        }
        QCOMPARE(*NameLanguages(album.keeper).of("Nobody here"), std::string("fr"));
    }

    void another_machine_s_sidecar_is_merged_and_told() {
        AlbumOfOne album;
        const AlbumFolder elsewhere;
        const fs::path there = a_photo(elsewhere, "IMG_1.jpg", 1);
        AlbumKeeper other(elsewhere.path());
        QCOMPARE(other.name_face(there, {0.5, 0.5, 0.2, 0.2, "Tom"}), std::string());
        album.folder.write("2026/IMG_1.jpg.sync-conflict-20260501-101500-ABCDEFG.xmp",
                           elsewhere.read("IMG_1.jpg.xmp"));
        found_and_mended(album.folder, Kind::conflict_copy);
        QCOMPARE(read_record(album.photo)->persons, std::vector<std::string>{"Tom"});
        QCOMPARE(read_record(album.photo)->tags.size(), std::size_t{1});
    }

    void unfinished_imports_and_a_spoilt_trash_are_said() {
        AlbumOfOne album;
        const fs::path list = ImportList::place_of(album.folder.path(), "2026");
        QCOMPARE(make_folder(list.parent_path()), std::string());
        QCOMPARE(replace_file(list, R"({"into":"","sources":[]})"), std::string());
        album.folder.write(".touchphoto/import/2026.json", R"({"into":"","sources":[]})"); // by whomever
        album.folder.write(".touchphoto/trash/2026/list.json", "{");
        QCOMPARE(kinds(check(album.folder, true)),
                 (std::vector<Kind>{Kind::unfinished_import, Kind::import_list, Kind::damaged_trash}));
    }

    void links_and_pipes_are_counted_and_left() {
        AlbumOfOne album;
        fs::create_symlink("nowhere", album.folder / "2026/IMG_1.jpg.contours.svg");
        fs::create_directory_symlink("/", album.folder / "all");
        fs::remove_all(album.folder / ".touchphoto");
        fs::create_directory_symlink("..", album.folder / ".touchphoto");
        for (const bool mend : {false, true}) {
            const auto findings = check(album.folder, mend);
            QCOMPARE(kinds(findings), (std::vector<Kind>{Kind::link, Kind::link, Kind::link}));
        }
        QVERIFY(fs::is_symlink(album.folder / "all") && fs::is_symlink(album.folder / ".touchphoto"));
    }

    void a_recording_that_is_cut_short_is_said() {
        AlbumOfOne album;
        const fs::path place = tags_folder(album.photo) / album.file;
        fs::resize_file(place, fs::file_size(place) / 2);
        const CheckReport report = check(album.folder, true);
        QCOMPARE(kinds(report), std::vector<Kind>{Kind::unreadable_recording});
        QVERIFY(report.findings[0].sentence.ends_with("cannot be read to its end."));
        QVERIFY(fs::exists(place)); // what is left of it
    }

    void a_sound_that_is_none_is_said() {
        AlbumOfOne album;
        const auto file = tags_folder(album.photo).lexically_relative(album.folder.path()) / "x.flac";
        album.folder.write(file, "no sound");
        ::chmod((album.folder / file).c_str(), 0600);
        QCOMPARE(kinds(check(album.folder, true)), std::vector<Kind>{Kind::unreadable_recording});
    }
};

QTEST_GUILESS_MAIN(AlbumCheckTest)
#include "album_check_test.moc"
