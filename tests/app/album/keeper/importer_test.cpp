// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "core/files/foreign_folder.hpp"
#include "made_zip.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>

namespace importer_test {

using namespace tp;
namespace fs = std::filesystem;
using Fate = ImportedPhoto::Fate;
using tp::test::write_zip;

class ImporterTest : public QObject {
    Q_OBJECT

    static std::map<std::string, std::string> photos_in(const AlbumFolder& album) {
        auto files = album.files();
        std::erase_if(files, [](const auto& file) { return file.first.starts_with(".touchphoto/"); });
        return files;
    }

private slots:
    /// Read, a list takes 75 times its size in memory.
    void a_list_is_never_larger_than_one_that_is_read() {
        const AlbumFolder album;
        ImportList list;
        list.sources.assign(30'000, fs::path("/" + std::string(100, 'a')));
        const auto id = list.save(album.path());
        QVERIFY2(id.ok(), id.error().c_str());
        QCOMPARE(ImportList::read(album.path(), *id)->sources.size(), std::size_t{30'000});
        list.sources.assign(50'000, list.sources[0]);
        QVERIFY(list.save(album.path()).error().starts_with("That is more than can be imported at once"));
        QCOMPARE(ImportList::all(album.path()).size(), std::size_t{1});
        QCOMPARE(replace_file(ImportList::place_of(album.path(), "2"), std::string((4 << 20) + 1, ' ')),
                 std::string());
        QVERIFY(!ImportList::read(album.path(), "2").ok());
    }

    void a_photograph_comes_with_all_that_is_its_own() {
        const AlbumFolder card, album;
        card.write("DCIM/100/IMG_1.JPG", "one");
        card.write("DCIM/100/IMG_1.JPG.xmp", "sidecar");
        card.write("DCIM/100/IMG_1.JPG.contours.svg", "svg");
        card.write("DCIM/100/IMG_1.JPG.tags/2026-memo.flac", "sound");
        card.write("DCIM/100/IMG_2.jpg", "two");
        card.write("DCIM/100/IMG_2.xmp", "Lightroom's");
        card.write("DCIM/100/IMG_3.jpg", "three");
        card.write("DCIM/100/IMG_3.png", "three too");
        card.write("DCIM/100/IMG_3.xmp", "whose?");
        card.write("DCIM/100/._IMG_1.JPG", "another system's");
        card.write("DCIM/.thumbnails/IMG_1.JPG", "small");
        card.write("DCIM/100/readme.txt", "text");
        const auto before = card.files();
        std::vector<ImportProgress> said;
        ImportTools tools;
        tools.progress = [&](const ImportProgress& p) { said.push_back(p); };
        const auto report = import_photos(album.path(), "Summer", {card / "DCIM"}, tools);
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(report->count(Fate::imported), std::size_t{4});
        QVERIFY((photos_in(album) == std::map<std::string, std::string>{
                                         {"Summer/100/IMG_1.JPG", "one"},
                                         {"Summer/100/IMG_1.JPG.xmp", "sidecar"},
                                         {"Summer/100/IMG_1.JPG.contours.svg", "svg"},
                                         {"Summer/100/IMG_1.JPG.tags/2026-memo.flac", "sound"},
                                         {"Summer/100/IMG_2.jpg", "two"},
                                         {"Summer/100/IMG_2.xmp", "Lightroom's"},
                                         {"Summer/100/IMG_3.jpg", "three"},
                                         {"Summer/100/IMG_3.png", "three too"},
                                     }));
        QVERIFY(card.files() == before);
        QCOMPARE(said.size(), std::size_t{5});
        QCOMPARE(said.back().done, std::size_t{4});
        QCOMPARE(said.back().bytes_done, said.back().bytes_total);
        QVERIFY(unfinished_imports(album.path()).empty());
        struct stat about {};
        QCOMPARE(::stat((album / "Summer/100/IMG_1.JPG.tags/2026-memo.flac").c_str(), &about), 0);
        QCOMPARE(about.st_mode & 0777u, 0600u);
        QCOMPARE(::stat((album / "Summer/100/IMG_1.JPG.xmp").c_str(), &about), 0);
        QCOMPARE(about.st_mode & 0777u, 0600u);
    }

    void what_only_its_owner_may_see_stays_so() {
        ::umask(022);
        const AlbumFolder album, card;
        for (const auto& [name, mode] : {std::pair{"a.jpg", 0600u}, {"b.jpg", 0640u}, {"c.jpg", 0777u}}) {
            card.write(name, name);
            card.write(std::string(name) + ".xmp", "sidecar");
            ::chmod((card / name).c_str(), mode);
            ::chmod((card / (std::string(name) + ".xmp")).c_str(), 0666);
        }
        const auto report = import_photos(album.path(), {}, {card.path()}, {});
        QCOMPARE(report->count(Fate::imported), std::size_t{3});
        for (const auto& [name, mode] : {std::pair{"a.jpg", 0600u}, {"b.jpg", 0640u}, {"c.jpg", 0644u}}) {
            QCOMPARE(fs::status(album / name).permissions(), fs::perms(mode));
            QCOMPARE(fs::status(album / (std::string(name) + ".xmp")).permissions(), fs::perms(0600));
        }
    }

    /// Anna sends a photograph, Otto adds to it and sends it back; meanwhile she has added to hers.
    void a_reply_is_merged() {
        const AlbumFolder annas, ottos, post;
        const fs::path hers = a_photo(annas, "one.jpg", 1);
        AlbumKeeper anna(annas.path());
        const RecordingLabel memo{RecordingKind::memo, {}, {}, "en", "2026-05-01T10:15:00+02:00", {}};
        const RecordingLabel story{RecordingKind::story, {}, "Otto", "de", "2026-06-01T10:15:00+02:00",
                                   "Es war einmal"};
        QVERIFY(anna.add_recording(hers, a_sound(annas, "memo.wav", 1.0, 440.0), memo).ok());
        QCOMPARE(anna.describe(hers, "en", "A garden", ""), std::string());
        QCOMPARE(write_bundle(post / "to Otto.touchphoto", annas.path(), {hers}), std::string());
        QVERIFY(import_photos(ottos.path(), {}, {post / "to Otto.touchphoto"}, {}).ok());
        const fs::path his = ottos / "one.jpg";
        AlbumKeeper otto(ottos.path());
        const auto told = otto.add_recording(his, a_sound(ottos, "story.wav", 2.0, 500.0), story);
        QVERIFY(told.ok());
        QCOMPARE(otto.describe(his, "de", "Ein Garten", ""), std::string());
        QCOMPARE(otto.describe(his, "en", "A yard", ""), std::string());
        QCOMPARE(otto.name_face(his, {0.5, 0.5, 0.2, 0.2, "Clara"}), std::string());
        QCOMPARE(write_bundle(post / "to Anna.touchphoto", ottos.path(), {his}), std::string());

        QVERIFY(anna.add_recording(hers, a_sound(annas, "mine.wav", 3.0, 600.0), memo).ok());
        QCOMPARE(anna.delete_recording(hers, read_record(hers)->tags[0].file), std::string());
        const auto report = import_photos(annas.path(), {}, {post / "to Anna.touchphoto"}, {});
        QVERIFY(report.ok());
        QCOMPARE(report->count(Fate::duplicate), std::size_t{1});
        QCOMPARE(report->count_replies(), std::size_t{1});
        const ImportedPhoto& photo = report->photos.front();
        QVERIFY(photo.reply.words);
        QCOMPARE(photo.reply.recordings, std::vector<std::string>{told->tag.file});
        QVERIFY2(photo.problem.find("A yard") != std::string::npos,
                 photo.problem.c_str()); // hers stays, his is told
        const auto record = read_record(hers);
        QCOMPARE(record->alt_text, (LanguageTexts{{"en", "A garden"}, {"de", "Ein Garten"}}));
        QCOMPARE(record->persons, std::vector<std::string>{"Clara"});
        QCOMPARE(record->tags.size(), std::size_t{2}); // what she threw away does not come back
        const auto his_story = std::ranges::find(record->tags, told->tag.file, &Tag::file);
        QVERIFY(his_story != record->tags.end());
        QVERIFY(his_story->label == told->tag.label);
        QVERIFY(fs::file_size(tags_folder(hers) / told->tag.file) > 0);
        QCOMPARE(fs::status(tags_folder(hers) / told->tag.file).permissions() & fs::perms(077),
                 fs::perms::none);

        const auto before = photos_in(annas);
        const auto again = import_photos(annas.path(), {}, {post / "to Anna.touchphoto"}, {});
        QCOMPARE(again->count_replies(), std::size_t{0});
        QVERIFY(photos_in(annas) == before);
    }

    /// In its first second nobody can tell how long the rest takes.
    void how_long_the_rest_takes_is_not_guessed_at_once() {
        const AlbumFolder card, album;
        for (int i = 0; i < 4; ++i)
            card.write(std::to_string(i) + ".jpg", std::to_string(i));
        const auto begun = std::chrono::steady_clock::now();
        std::vector<fs::path> done;
        bool guessed = false;
        ImportTools tools;
        tools.progress = [&](const ImportProgress& p) {
            guessed |= p.done == 0 && p.seconds_left.has_value();
            if (std::chrono::steady_clock::now() - begun < std::chrono::seconds(1))
                guessed |= p.done < 4 && p.seconds_left.has_value();
            if (p.done == 4)
                QCOMPARE(*p.seconds_left, 0.0);
            QCOMPARE(p.current.empty(), p.done == 4);
            QCOMPARE(p.bytes_done, std::uintmax_t(p.done));
            QCOMPARE(p.bytes_total, std::uintmax_t(4));
            QCOMPARE(p.total, std::size_t{4});
        };
        tools.done = [&](const ImportedPhoto& photo) { done.push_back(photo.source.filename()); };
        QVERIFY(import_photos(album.path(), {}, {card.path()}, tools).ok());
        QVERIFY(!guessed);
        QCOMPARE(done, (std::vector<fs::path>{"0.jpg", "1.jpg", "2.jpg", "3.jpg"}));
    }

    void the_same_bytes_come_once() {
        const AlbumFolder card, album;
        card.write("a.jpg", "one");
        card.write("copy of a.jpg", "one");
        card.write("b.jpg", "known elsewhere");
        const fs::path elsewhere = album.write("old/b.jpg", "known elsewhere");
        const auto hash = content_hash(elsewhere);
        const auto known = [&](const std::string& of) {
            return of == *hash ? std::optional<fs::path>(elsewhere) : std::nullopt;
        };
        const auto report = import_photos(album.path(), {}, {card.path()}, {known, {}, {}, {}});
        QCOMPARE(report->count(Fate::imported), std::size_t{1});
        QCOMPARE(report->count(Fate::duplicate), std::size_t{2});
        QCOMPARE(report->photos[1].place, elsewhere);
        const auto again = import_photos(album.path(), {}, {card.path()}, {});
        QCOMPARE(again->count(Fate::duplicate), std::size_t{2}); // nothing() does not know what is in old/
        QCOMPARE(photos_in(album).size(), std::size_t{3});
    }

    void what_is_no_photograph_stays_where_it_is() {
        const AlbumFolder card, album;
        card.write("IMG_1.jpg", "one");
        card.write("IMG_1.jpg.xmp", "sidecar");
        card.write("IMG_1.txt", "of the camera");
        card.write("notes.txt", "text");
        const auto report = import_photos(
            album.path(), {},
            {card / "notes.txt", card / "IMG_1.txt", card / "IMG_1.jpg.xmp", card / "IMG_1.jpg"}, {});
        QCOMPARE(report->photos.size(), std::size_t{2});
        QCOMPARE(report->photos[0].source, card / "notes.txt");
        QCOMPARE(report->photos[0].problem,
                 "\"" + (card / "notes.txt").string() +
                     "\" was not imported: it is not a photograph of a kind that can be read here.");
        QVERIFY((photos_in(album) ==
                 std::map<std::string, std::string>{{"IMG_1.jpg", "one"}, {"IMG_1.jpg.xmp", "sidecar"}}));
        QVERIFY(unfinished_imports(album.path()).empty()); // going on would change nothing
    }

    void nothing_to_import_is_said() {
        const AlbumFolder card, album;
        card.write("empty/notes.txt", "text");
        const auto report = import_photos(album.path(), {}, {card / "empty"}, {});
        QCOMPARE(report->count(Fate::failed), std::size_t{1});
        QVERIFY(report->photos[0].problem.ends_with("empty\" was not imported: it holds no photograph."));
        QVERIFY(unfinished_imports(album.path()).empty());
    }

    void a_zip_file_of_photographs_is_unpacked() {
        const AlbumFolder card, album;
        write_zip(card / "FAMILY.ZIP",
                  {{"2019/a.jpg", "one"}, {"2019/a.jpg.xmp", "sidecar"}, {"2019/notes.txt", "text"}});
        write_zip(card / "notes.zip", {{"notes.txt", "text"}});
        const auto report = import_photos(album.path(), {}, {card / "FAMILY.ZIP", card / "notes.zip"}, {});
        QCOMPARE(report->count(Fate::imported), std::size_t{1});
        QCOMPARE(report->count(Fate::failed), std::size_t{1});
        QVERIFY((photos_in(album) ==
                 std::map<std::string, std::string>{{"2019/a.jpg", "one"}, {"2019/a.jpg.xmp", "sidecar"}}));
    }

    /// A folder is read once for all its photographs: what begins like another's name is not that one's.
    void names_that_begin_alike_keep_their_own() {
        const AlbumFolder card;
        for (const char* name : {"a.jpg", "a.jpg.XMP", "a.jpg.tags/1.flac", "a.jpg.jpg", "a.jpg.jpg.xmp",
                                 "a.xmp", "ab.jpg", "ab.Xmp", "a.b.jpg", "b/a.jpg", "b/a.xmp", "b/a.png"})
            card.write(name, name);
        FolderCompanions beside;
        const auto names = [&](const char* photo) {
            std::vector<std::string> found;
            for (const Companion& one : beside.of(card / photo))
                found.push_back(one.file.lexically_relative(card.path()).string() +
                                (one.by_stem ? " by stem" : ""));
            return found;
        };
        using Names = std::vector<std::string>;
        QCOMPARE(names("a.jpg"), (Names{"a.jpg.XMP", "a.jpg.tags", "a.xmp by stem"}));
        QCOMPARE(names("b/a.jpg"), Names{});
        QCOMPARE(names("a.jpg.jpg"), (Names{"a.jpg.jpg.xmp"}));
        QCOMPARE(names("ab.jpg"), (Names{"ab.Xmp by stem"}));
        QCOMPARE(names("a.b.jpg"), Names{});
    }

    void a_name_that_is_taken_gets_a_number() {
        const AlbumFolder card, album;
        album.write("IMG_1.jpg", "another");
        album.write("IMG_1 (2).jpg.xmp", "somebody's");
        card.write("IMG_1.jpg", "new");
        card.write("IMG_1.jpg.xmp", "new sidecar");
        const auto report = import_photos(album.path(), {}, {card / "IMG_1.jpg"}, {});
        QCOMPARE(report->photos[0].place, album / "IMG_1 (3).jpg");
        QCOMPARE(album.read("IMG_1 (3).jpg"), std::string("new"));
        QCOMPARE(album.read("IMG_1 (3).jpg.xmp"), std::string("new sidecar"));
        QCOMPARE(album.read("IMG_1.jpg"), std::string("another"));
    }

    void a_stopped_import_goes_on_where_it_was() {
        const AlbumFolder card, album;
        for (int i = 0; i < 10; ++i)
            card.write("IMG_" + std::to_string(i) + ".jpg", std::to_string(i));
        std::stop_source stop;
        ImportTools tools;
        tools.stop = stop.get_token();
        tools.progress = [&](const ImportProgress& p) {
            if (p.done == 4)
                stop.request_stop();
        };
        const auto stopped = import_photos(album.path(), "in", {card.path()}, tools);
        QVERIFY(stopped->stopped);
        QCOMPARE(photos_in(album).size(), std::size_t{4});
        QCOMPARE(unfinished_imports(album.path()), std::vector<std::string>{stopped->id});
        const auto rest = go_on_importing(album.path(), stopped->id, {});
        QVERIFY2(rest.ok(), rest.error().c_str());
        QCOMPARE(rest->count(Fate::duplicate), std::size_t{4});
        QCOMPARE(rest->count(Fate::imported), std::size_t{6});
        QCOMPARE(photos_in(album).size(), std::size_t{10});
        QVERIFY(unfinished_imports(album.path()).empty());
        QVERIFY(!go_on_importing(album.path(), stopped->id, {}).ok());
    }

    /// A kill between a companion and its photograph leaves the companion; the next try uses it.
    void a_companion_that_came_before_a_kill_is_used() {
        const AlbumFolder card, album;
        card.write("a.jpg", "photo");
        card.write("a.jpg.xmp", "sidecar");
        card.write("a.jpg.tags/1.flac", "1");
        card.write("a.jpg.tags/2.flac", "2");
        album.write("a.jpg.xmp", "sidecar");
        album.write("a.jpg.tags/1.flac", "1");
        const auto report = import_photos(album.path(), {}, {card.path()}, {});
        QCOMPARE(report->photos[0].place, album / "a.jpg");
        QVERIFY(photos_in(album) == card.files());
    }

    void another_recording_of_that_name_is_kept() {
        const AlbumFolder card, album;
        card.write("a.jpg", "photo");
        card.write("a.jpg.tags/1.flac", "1");
        album.write("a.jpg.tags/1.flac", "orphan of another photograph");
        const auto report = import_photos(album.path(), {}, {card.path()}, {});
        QCOMPARE(report->photos[0].place, album / "a (2).jpg");
        QCOMPARE(album.read("a.jpg.tags/1.flac"), std::string("orphan of another photograph"));
        QCOMPARE(album.read("a (2).jpg.tags/1.flac"), std::string("1"));
    }

    void one_that_fails_does_not_stop_the_others() {
        const AlbumFolder card, album;
        card.write("a.jpg", "photo");
        QCOMPARE(::mkfifo((card / "b.jpg").c_str(), 0600), 0);
        card.write("large.jpg", std::string(100'000, 'x'));
        card.write("z.jpg", "last");
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 4096, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto report =
            import_photos(album.path(), {}, {card / "a.jpg", card / "b.jpg", card.path()}, {});
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY(report.ok());
        QCOMPARE(report->count(Fate::failed), std::size_t{2});
        QCOMPARE(report->count(Fate::imported), std::size_t{2});
        for (const ImportedPhoto& photo : report->photos)
            QCOMPARE(photo.fate == Fate::failed, !photo.problem.empty());
        QVERIFY(
            (photos_in(album) == std::map<std::string, std::string>{{"a.jpg", "photo"}, {"z.jpg", "last"}}));
        QCOMPARE(unfinished_imports(album.path()).size(), std::size_t{1});
        const auto rest = go_on_importing(album.path(), report->id, {});
        QCOMPARE(album.read("large.jpg").size(), std::size_t{100'000});
        QCOMPARE(rest->count(Fate::failed), std::size_t{1}); // the pipe
        album.write(".touchphoto/import/" + report->id + "/0/x.jpg", "what a kill left of a bundle");
        QCOMPARE(give_up_import(album.path(), report->id), std::string());
        QVERIFY(!fs::exists(album / ".touchphoto/import" / report->id));
        QVERIFY(unfinished_imports(album.path()).empty());
    }

    void what_is_not_there_is_said_before_anything_is_copied() {
        const AlbumFolder card, album;
        card.write("a.jpg", "photo");
        QVERIFY(!import_photos(album.path(), {}, {card / "a.jpg", card / "missing"}, {}).ok());
        QVERIFY(album.files().empty());
        QVERIFY(!go_on_importing(album.path(), "../x", {}).ok());
        const fs::path bad = ImportList::place_of(album.path(), "bad"),
                       evil = ImportList::place_of(album.path(), "evil");
        QCOMPARE(make_folder(bad.parent_path()), std::string());
        QCOMPARE(replace_file(bad, "{}"), std::string());
        QVERIFY(!go_on_importing(album.path(), "bad", {}).ok());
        QCOMPARE(replace_file(evil, R"({"into":"../..","sources":["/tmp"]})"), std::string());
        QVERIFY(!go_on_importing(album.path(), "evil", {}).ok());
    }

    /// A stranger's wish: this person's photographs on that stick.
    void a_list_in_the_album_is_followed_by_nobody() {
        const AlbumFolder own, album;
        own.write("private.jpg", "private");
        const fs::path list = album.write(".touchphoto/import/1.json",
                                          R"({"into":"","sources":[")" + own.path().string() + R"("]})");
        album.write(".touchphoto/import/1/0/x.jpg", "unpacked");
        QVERIFY(unfinished_imports(album.path()).empty());
        QVERIFY(!go_on_importing(album.path(), "1", {}).ok());
        QVERIFY(!give_up_import(album.path(), "1").empty());
        QCOMPARE(import_lists_in_album(album.path()), std::vector<fs::path>{list});
        QVERIFY((album.files().size() == 2));
    }

    void what_an_unfinished_import_takes_from_where_is_known() {
        const AlbumFolder card, album;
        ImportList list{"in", {card.path()}};
        const auto id = list.save(album.path());
        QVERIFY(id.ok());
        const auto import = unfinished_import(album.path(), *id);
        QVERIFY(import.ok());
        QCOMPARE(import->sources, std::vector<fs::path>{card.path()});
        QCOMPARE(import->into, album / "in");
        QVERIFY(!unfinished_import(album.path(), "another").ok());
        // Another album is another's: nothing of it goes on there.
        QVERIFY(unfinished_imports(card.path()).empty());
    }

    void links_in_a_source_are_told_and_stay_there() {
        const AlbumFolder own, card, album;
        own.write("secret", "secret");
        own.write("tags/1.flac", "secret");
        card.write("a.jpg", "a");
        fs::create_symlink(own / "secret", card / "a.jpg.contours.svg");
        fs::create_directory_symlink(own / "tags", card / "a.jpg.tags");
        fs::create_symlink(own / "secret", card / "b.jpg");
        fs::create_directory_symlink(own.path(), card / "folder");
        const auto report = import_photos(album.path(), {}, {card.path()}, {});
        QVERIFY(report.ok());
        QVERIFY(album.files() == (std::map<std::string, std::string>{{"a.jpg", "a"}}));
        std::string told;
        for (const ImportedPhoto& photo : report->photos)
            told += photo.problem;
        for (const char* link : {"a.jpg.contours.svg", "a.jpg.tags", "b.jpg", "folder"})
            QVERIFY2(told.find(left_alone(card / link)) != std::string::npos, (told + " " + link).c_str());
        for (const auto& file : fs::recursive_directory_iterator(album.path()))
            QVERIFY(!file.is_symlink());
    }

    void a_camera_s_sound_becomes_a_recording() {
        const AlbumFolder card, album;
        a_photo(card, "IMG_1.JPG", 1);
        a_sound(card, "IMG_1.WAV", 0.5, 440.0);
        for (int i = 0; i < 2; ++i) { // the second time nothing comes twice
            const auto report = import_photos(album.path(), {}, {card.path()}, {});
            QVERIFY(report.ok());
            QCOMPARE(report->photos.at(0).problem, std::string());
            const auto record = read_record(album / "IMG_1.JPG");
            QCOMPARE(record->tags.size(), std::size_t{1});
            QVERIFY(record->tags[0].label.kind == RecordingKind::ambient);
        }
        card.write("IMG_2.JPG", "x");
        card.write("IMG_2.WAV", "no sound");
        const auto report = import_photos(album.path(), {}, {card / "IMG_2.JPG"}, {});
        QVERIFY(report->photos.at(0).fate == Fate::imported);
        QVERIFY(!report->photos.at(0).problem.empty());
    }

    void a_bundle_is_imported_as_it_was() {
        const AlbumFolder family, album, place;
        const fs::path a = a_photo(family, "2025/a.jpg", 1), b = a_photo(family, "b.jpg", 2);
        family.write("2025/a.jpg.xmp", "sidecar");
        family.write("b.jpg.tags/1.flac", "sound");
        QCOMPARE(write_bundle(place / "f.touchphoto", family.path(), {a, b}), std::string());
        const auto report = import_photos(album.path(), "from Tom", {place / "f.touchphoto"}, {});
        QCOMPARE(report->count(Fate::imported), std::size_t{2});
        std::map<std::string, std::string> expected;
        for (const auto& [name, bytes] : family.files())
            expected["from Tom/" + name] = bytes;
        QVERIFY(photos_in(album) == expected);
        QVERIFY(album.files() == photos_in(album)); // nothing is left of the unpacking
        place.write("bad.touchphoto", "no zip file");
        const auto bad = import_photos(album.path(), {}, {place / "bad.touchphoto"}, {});
        QCOMPARE(bad->count(Fate::failed), std::size_t{1});
        QVERIFY(!bad->photos.at(0).problem.empty());
        QVERIFY(!import_photos(album.path(), "../out", {a}, {}).ok());
    }

    void strange_names_come_as_they_are() {
        const AlbumFolder card, album;
        const std::vector<std::string> names{std::string("J\xF6rg.jpg"),
                                             "line\nend.jpg",
                                             "👵🏽 שלום.jpg",
                                             std::string(240, 'n') + ".jpg",
                                             "100%.jpg",
                                             " .jpg",
                                             "-rf.jpg"};
        for (const std::string& name : names)
            card.write(name, name);
        const auto report = import_photos(album.path(), {}, {card.path()}, {});
        QCOMPARE(report->count(Fate::imported), names.size());
        QVERIFY(photos_in(album) == card.files());
    }
};

} // namespace importer_test

TP_TEST(importer_test, ImporterTest, event_loop)
#include "importer_test.moc"
