// SPDX-License-Identifier: Apache-2.0
// Albums from somebody else, with links and lists that he put there: every verb is tried on each, and nothing outside the album is
// read into it, changed or removed.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr const char* secret = "SECRET-of-this-person";

QString text(const fs::path& path) { return QString::fromStdString(path.string()); }

std::string bytes_of(const fs::path& file) {
    const auto bytes = read_whole(file, 1 << 26);
    return bytes ? *bytes : bytes.error();
}

/// All below a folder: names, kinds, bytes, rights and times, where links lead.
std::map<std::string, std::string> state_of(const fs::path& folder) {
    std::map<std::string, std::string> all;
    const auto add = [&](const fs::path& place) {
        struct stat about {};
        ::lstat(place.c_str(), &about);
        std::string state = std::to_string(about.st_mode) + " " + std::to_string(about.st_mtim.tv_sec) + "." +
                            std::to_string(about.st_mtim.tv_nsec) + " ";
        if (S_ISREG(about.st_mode))
            state += bytes_of(place);
        else if (S_ISLNK(about.st_mode))
            state += fs::read_symlink(place).string();
        all[place.lexically_relative(folder).string()] = state;
    };
    add(folder);
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        add(entry.path());
    return all;
}

/// The links below a folder, with where they lead.
std::map<std::string, std::string> links_in(const fs::path& folder) {
    std::map<std::string, std::string> links;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_symlink())
            links[entry.path().lexically_relative(folder).string()] = fs::read_symlink(entry.path()).string();
    return links;
}

/// Files below a folder in which the secret stands; links are not followed.
std::vector<std::string> with_secret(const fs::path& folder) {
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (fs::is_regular_file(entry.symlink_status()) &&
            bytes_of(entry.path()).find(secret) != std::string::npos)
            found.push_back(entry.path().lexically_relative(folder).string());
    return found;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += name + " ";
    return text;
}

Run album(const QStringList& words) { return lab(QStringList{"album"} + words); }

/// A person's home with private things, an album of their own, and a stick with a stranger's album.
struct World {
    AlbumFolder place;
    fs::path home = place / "home", own = place / "home/album", stick = place / "stick",
             results = place / "results";
    QString memo;     ///< a sound
    std::string file; ///< the recording of one.jpg

    World() {
        for (const fs::path& folder : {home, own, stick, results})
            fs::create_directories(folder);
        place.write("home/.ssh/id_rsa", secret);
        place.write("home/.bashrc", "");
        place.write("home/dir/x.json", R"({"into":"","sources":[]})");
        place.write("home/dir/x/inside", secret);
        place.write("home/dir/list.json", R"({"what":"x","files":["one.jpg"]})");
        a_photo(place, "home/dir/private.jpg", 77);
        a_sound(place, "home/dir/private.wav", 0.2, 500.0);
        a_photo(place, "home/album/mine.jpg", 70);
        a_photo(place, "home/photos/private.jpg", 78);
        fs::copy_file(test::in_source("resources/samples/anna_smiling.jpg"), stick / "one.jpg");
        a_photo(place, "stick/two.jpg", 2);
        a_photo(place, "stick/sub/three.jpg", 3);
        memo = text(a_sound(place, "home/memo.wav", 0.3, 440.0));
        if (album(
                {"tag", "add", text(stick / "one.jpg"), "--from", memo, "--kind", "memo", "--person", "Anna"})
                    .code != 0 ||
            album({"tag", "add", text(own / "mine.jpg"), "--from", memo, "--kind", "memo"}).code != 0 ||
            album({"tag", "delete", text(own / "mine.jpg"), text(recording_of("home/album/mine.jpg"))})
                    .code != 0)
            qFatal("the album cannot be made");
        file = recording_of("stick/one.jpg").string();
        fs::copy_file(stick / "one.jpg.tags" / file, home / "dir/outside.flac");
    }

    fs::path recording_of(const std::string& photo) const {
        return fs::directory_iterator((place / photo).string() + ".tags")->path().filename();
    }
    QString photo() const { return text(stick / "one.jpg"); }
    void link(const fs::path& to, const std::string& name) const {
        fs::remove_all(stick / name);
        fs::create_directories((stick / name).parent_path());
        fs::create_symlink(to, stick / name);
    }
};

struct Case {
    const char* name;
    std::function<void(World&)> plant;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"imports are a link", [](World& w) { w.link(w.home / "dir", ".touchphoto/import"); }},
        {"recordings are a link", [](World& w) { w.link(w.home / "dir", "one.jpg.tags"); }},
        {"recordings of the other are a link", [](World& w) { w.link(w.home / ".ssh", "two.jpg.tags"); }},
        {"the trash is the person's own",
         [](World& w) { w.link(w.own / ".touchphoto/trash", ".touchphoto/trash"); }},
        {"a deletion is a link",
         [](World& w) {
             w.link(w.home / "dir", ".touchphoto/trash/2026-05-01T101500.000");
             w.place.write("stick/.touchphoto/trash/2026-05-02T101500.000/list.json",
                           R"({"what":"x","deleted":"2026","files":["four.jpg"]})");
             w.link(w.home / "dir", ".touchphoto/trash/2026-05-02T101500.000/0");
         }},
        {"the list of a deletion is a link",
         [](World& w) {
             w.link(w.home / "dir/list.json", ".touchphoto/trash/2026-05-02T101500.000/list.json");
             w.link(w.home / "dir/private.jpg", ".touchphoto/trash/2026-05-02T101500.000/0");
         }},
        {"the album's own folder is a link", [](World& w) { w.link(w.home / "dir", ".touchphoto"); }},
        {"people are a link", [](World& w) { w.link(w.home / "dir", ".touchphoto/people"); }},
        {"a person's name is a link",
         [](World& w) { w.link(w.home / "dir/outside.flac", ".touchphoto/people/Anna.flac"); }},
        {"what was merged is a link", [](World& w) { w.link(w.home / "dir", ".touchphoto/merged"); }},
        {"a recording is a link",
         [](World& w) { w.link(w.home / "dir/outside.flac", "one.jpg.tags/" + w.file); }},
        {"what was drawn is a key", [](World& w) { w.link(w.home / ".ssh/id_rsa", "one.jpg.contours.svg"); }},
        {"what was drawn never ends", [](World& w) { w.link("/dev/zero", "one.jpg.contours.svg"); }},
        {"what was drawn is a pipe",
         [](World& w) { QCOMPARE(::mkfifo((w.stick / "one.jpg.contours.svg").c_str(), 0600), 0); }},
        {"what is drawn goes by a link",
         [](World& w) {
             w.link(w.home / ".bashrc", "scene.svg");
             w.link(w.home / ".bashrc", "one.jpg.overlay.png");
         }},
        {"a sidecar is a file that a shell reads",
         [](World& w) {
             w.link(w.home / ".bashrc", "one.jpg.xmp");
             w.place.write("stick/one.xmp", R"(<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF)"
                                            R"( xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">)"
                                            "\ntouch /tmp/owned\n</rdf:RDF></x:xmpmeta>");
         }},
        {"a shared sidecar is a key", [](World& w) { w.link(w.home / ".ssh/id_rsa", "two.xmp"); }},
        {"a conflict copy is a key",
         [](World& w) { w.link(w.home / ".ssh/id_rsa", "one.jpg (conflicted copy).xmp"); }},
        {"a photograph is a key", [](World& w) { w.link(w.home / ".ssh/id_rsa", "four.jpg"); }},
        {"a photograph is the person's", [](World& w) { w.link(w.home / "photos/private.jpg", "four.jpg"); }},
        {"a folder is the person's", [](World& w) { w.link(w.home / "photos", "photos"); }},
        {"a folder on the way is a link",
         [](World& w) {
             fs::remove_all(w.stick / "sub");
             w.link("../home/photos", "sub");
         }},
        {"a folder is the whole computer", [](World& w) { w.link("/", "all"); }},
        {"a folder is the kernel's", [](World& w) { w.link("/proc/self", "all"); }},
        {"a loop", [](World& w) { w.link("one.jpg.tags", "one.jpg.tags"), w.link("..", "sub/up"); }},
        {"links to nothing",
         [](World& w) {
             w.link(w.home / "new.flac", "two.jpg.tags");
             w.link(w.home / "new.xmp", "two.jpg.xmp");
             w.link(w.home / "new.svg", "two.jpg.contours.svg");
             w.link(w.home / "new", ".touchphoto/trash");
         }},
        {"another name of a file",
         [](World& w) {
             fs::remove(w.stick / "one.jpg.tags" / w.file);
             fs::create_hard_link(w.home / "dir/outside.flac", w.stick / "one.jpg.tags" / w.file);
             fs::permissions(w.home / "dir/outside.flac", fs::perms(0644));
             fs::create_hard_link(w.home / ".bashrc", w.stick / "two.jpg.xmp");
         }},
        {"a list of what to import",
         [](World& w) {
             w.place.write("stick/.touchphoto/import/2026-05-01T101500.000.json",
                           R"({"into":"","sources":[")" + (w.home / "photos").string() + R"("]})");
         }},
        {"a list of what to import is a link",
         [](World& w) { w.link(w.home / "dir/x.json", ".touchphoto/import/2026-05-01T101500.000.json"); }},
        {"something half-written is a link",
         [](World& w) {
             w.link(w.home / "dir", ".touchphoto-1-1.tmp");
             w.link(w.home / ".ssh/id_rsa", "one.jpg.tags/.touchphoto-1-2.tmp");
             w.link(w.home / ".ssh/id_rsa", "one.jpg.tags/x.wav.part");
         }},
    };
    return all;
}

/// Every verb that looks at an album or works on one, in an order in which each has something to do.
std::vector<QStringList> verbs(const World& w, bool looking) {
    const QString album = text(w.stick), photo = w.photo(), file = QString::fromStdString(w.file);
    const QString other = text(w.stick / "two.jpg"), third = text(w.stick / "sub/three.jpg"),
                  results = text(w.results);
    std::vector<QStringList> all{
        {"album", "scan", album},
        {"album", "list", album},
        {"album", "show", photo},
        {"album", "show", other},
        {"album", "search", album, "anna"},
        {"album", "check", album},
        {"album", "import", album, "--give-up"},
        {"album", "import", album, "--continue"},
        {"album", "export", album, "--to", results + "/all.touchphoto"},
        {"album", "export", album, photo, other, "--to", results + "/two.touchphoto"},
        {"album", "export", album, third, "--to", results + "/three.touchphoto"},
        {"album", "tag", "list", photo},
        {"album", "tag", "label", photo, file, "--person", "Otto", "--transcript", "text"},
        {"album", "tag", "add", photo, "--from", w.memo, "--kind", "story"},
        {"album", "tag", "add", other, "--from", w.memo, "--kind", "memo"},
        {"album", "tag", "add", third, "--from", w.memo, "--kind", "memo"},
        {"album", "tag", "add", text(w.stick / "four.jpg"), "--from", w.memo, "--kind", "memo"},
        {"album", "tag", "order", photo, file},
        {"album", "tag", "trim", photo, file, "--end", "0.1"},
        {"album", "tag", "delete", photo, file},
        {"album", "tag", "delete", other, "outside.flac"},
        {"album", "person", "name", photo, "Anna", "--face", "0.5,0.5,0.2,0.3"},
        {"album", "person", "name", third, "Anna", "--face", "0.5,0.5,0.2,0.3"},
        {"album", "person", "record", album, "Anna", "--from", w.memo},
        {"album", "person", "record", album, "Otto", "--from", w.memo},
        {"album", "person", "language", album, "Anna", "de"},
        {"album", "person", "rename", album, "Anna", "Berta"},
        {"album", "person", "list", album},
        {"album", "import", album, text(w.own)},
        {"album", "import", album, text(w.own), "--into", "sub/new"},
        {"album", "check", album, "--mend"},
        {"album", "trash", "list", album},
        {"album", "trash", "restore", album, "2026-05-02T101500.000"},
        {"album", "trash", "empty", album, "--yes"},
        {"album", "scan", album},
        {"album", "export", album, "--to", results + "/later.touchphoto"},
    };
    const std::vector<QStringList> looks{
        {"faces", photo, "--svg", album, "--overlay", album},
        {"scene", photo, "--out", results + "/scene.svg"},
        {"scene", photo, "--out", album + "/scene.svg"},
        {"correction", photo},
        {"tactile", photo, results + "/sheet.svg"},
    };
    if (looking)
        all.insert(all.begin(), looks.begin(), looks.end());
    return all;
}

} // namespace

class ForeignAlbumTest : public QObject {
    Q_OBJECT

    QTemporaryDir cache_;

private slots:
    void initTestCase() {
        qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
        qputenv("XDG_STATE_HOME", (cache_.path() + "/state").toUtf8());
    }

    void nothing_outside_is_touched_data() {
        QTest::addColumn<int>("number");
        for (int i = 0; i < static_cast<int>(cases().size()); ++i)
            QTest::newRow(cases()[static_cast<std::size_t>(i)].name) << i;
    }
    void nothing_outside_is_touched() {
        QFETCH(int, number);
        World world;
        cases()[static_cast<std::size_t>(number)].plant(world);
        const auto before = state_of(world.home);
        const auto planted = links_in(world.stick);
        const bool looking =
            std::string_view(QTest::currentDataTag()).find("drawn") != std::string_view::npos;
        for (const QStringList& words : verbs(world, looking)) {
            const Run run = lab(words);
            QVERIFY2(run.code >= 0 && run.code <= 2 && !run.err.contains("crashed or hung"),
                     qPrintable(words.join(" ") + ": " + run.err));
            QVERIFY2(!run.out.contains(secret) && !run.err.contains(secret), qPrintable(words.join(" ")));
            const auto after = state_of(world.home);
            for (const auto& [name, state] : before)
                QVERIFY2(after.contains(name) && after.at(name) == state,
                         qPrintable(words.join(" ") + ": " + QString::fromStdString(name) + " was changed"));
            QVERIFY2(after.size() == before.size(), qPrintable(words.join(" ") + ": something was made"));
        }
        QVERIFY2(links_in(world.stick) == planted, "a link was removed, made or rewritten");
        QCOMPARE(joined(with_secret(world.results)), std::string());
        QCOMPARE(joined(with_secret(world.stick)), std::string());
        QVERIFY(fs::is_character_file("/dev/zero"));

        // Into an album of the person's own comes nothing of theirs by a stranger's links, and no link.
        const AlbumFolder mine;
        album({"import", text(mine.path()), text(world.stick)});
        QCOMPARE(joined(with_secret(mine.path())), std::string());
        QVERIFY(links_in(mine.path()).empty());
        for (const char* name : {"private.jpg", "private.wav"})
            for (const auto& entry : fs::recursive_directory_iterator(mine.path()))
                QVERIFY2(bytes_of(entry.path()) != bytes_of(world.home / "dir" / name) &&
                             bytes_of(entry.path()) != bytes_of(world.home / "photos" / name),
                         entry.path().c_str());
        QVERIFY(state_of(world.home) == before);
    }

    void each_link_is_told_by_the_check() {
        World world;
        world.link(world.home / "dir", ".touchphoto/people");
        world.link(world.home / ".ssh/id_rsa", "one.jpg.contours.svg");
        world.link(world.home / "photos", "photos");
        world.link("nowhere", "two.jpg.xmp");
        world.link(world.home / "photos/private.jpg", "four.jpg");
        QCOMPARE(::mkfifo((world.stick / "two.jpg.contours.svg").c_str(), 0600), 0);
        const Run run = album({"check", text(world.stick), "--json"});
        QCOMPARE(run.code, 1);
        std::set<QString> links, others;
        for (const QJsonValue& finding : QJsonDocument::fromJson(run.out)["findings"].toArray())
            (finding["kind"] == "link" ? links : others).insert(finding["sentence"].toString());
        const auto told = [&](const char* name) {
            return links.contains("\"" + text(world.stick / name) + "\" is a link; it is left alone.");
        };
        for (const char* name :
             {".touchphoto/people", "one.jpg.contours.svg", "photos", "two.jpg.xmp", "four.jpg"})
            QVERIFY2(told(name), name);
        QCOMPARE(links.size(), std::size_t{5});
        QVERIFY(others.contains("\"" + text(world.stick / "two.jpg.contours.svg") +
                                "\" is not a file; it is left alone."));
        const Run scan = album({"scan", text(world.stick)});
        QVERIFY2(scan.err.contains("photos\" is a link; it is left alone."), scan.err.constData());
    }

    void an_export_says_what_it_leaves_out() {
        World world;
        world.link(world.home / ".ssh/id_rsa", "one.jpg.contours.svg");
        world.link(world.home / "photos/private.jpg", "four.jpg");
        const Run run = album({"export", text(world.stick), "--to", text(world.results / "b.touchphoto")});
        QCOMPARE(run.code, 0);
        for (const char* name : {"one.jpg.contours.svg", "four.jpg"})
            QVERIFY2(run.err.contains((name + QByteArray("\" is a link; it is left alone."))),
                     run.err.constData());
    }

    void a_list_in_the_album_is_told_and_left() {
        World world;
        world.place.write("stick/.touchphoto/import/1.json",
                          R"({"into":"","sources":[")" + (world.home / "photos").string() + R"("]})");
        for (const char* what : {"--continue", "--give-up"}) {
            const Run run = album({"import", text(world.stick), what});
            QVERIFY2(run.err.contains("1.json\" says what to import") &&
                         run.err.contains("it is left alone."),
                     run.err.constData());
            QVERIFY(!fs::exists(world.stick / "private.jpg"));
            QVERIFY(fs::exists(world.stick / ".touchphoto/import/1.json"));
        }
        QVERIFY(album({"check", text(world.stick), "--json"}).out.contains("\"import_list\""));
    }

    /// What was begun here goes on, and is said first.
    void an_import_names_its_sources_before_it_goes_on() {
        World world;
        a_photo(world.place, "home/card/good.jpg", 5);
        world.place.write("home/card/b.touchphoto", "not yet whole");
        const Run begun = album(
            {"import", text(world.own), text(world.home / "card"), text(world.home / "card/b.touchphoto")});
        QCOMPARE(begun.code, 1);
        QVERIFY(!fs::exists(world.own / ".touchphoto/import") ||
                fs::is_empty(world.own / ".touchphoto/import"));
        const Run check = album({"check", text(world.own)});
        QVERIFY2(check.out.contains("was not finished") &&
                     check.out.contains(text(world.home / "card").toUtf8()),
                 check.out.constData());
        const Run on = album({"import", text(world.own), "--continue"});
        QVERIFY2(on.err.contains("Continuing the import of \"" + text(world.home / "card").toUtf8()),
                 on.err.constData());
        QCOMPARE(album({"import", text(world.own), "--give-up"}).code, 0);
        QVERIFY(!album({"check", text(world.own)}).out.contains("was not finished"));
    }
};

QTEST_GUILESS_MAIN(ForeignAlbumTest)
#include "foreign_album_test.moc"
