// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <csignal>
#include <set>
#include <string>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

QString text(const fs::path& path) { return QString::fromStdString(path.string()); }

std::vector<QJsonObject> lines_of(const Run& run) {
    std::vector<QJsonObject> lines;
    for (const QByteArray& line : run.out.split('\n'))
        if (!line.isEmpty())
            lines.push_back(QJsonDocument::fromJson(line).object());
    return lines;
}

/// The verb of `album`, with an index of its own.
Run album(const QStringList& words) { return lab(QStringList{"album"} + words); }

} // namespace

class AlbumVerbTest : public QObject {
    Q_OBJECT

    QTemporaryDir cache_;

    struct Family {
        AlbumFolder folder, card;
        Family() {
            a_photo(card, "DCIM/IMG_1.JPG", 1);
            a_photo(card, "DCIM/IMG_2.JPG", 2);
            a_photo(card, "DCIM/again.JPG", 2);
            a_sound(card, "DCIM/IMG_2.WAV", 0.4, 300.0);
            a_sound(card, "memo.wav", 0.5, 440.0);
        }
        QString album() const { return text(folder.path()); }
        QString photo() const { return text(folder / "Mai/IMG_1.JPG"); }
    };

private slots:
    void initTestCase() { qputenv("XDG_CACHE_HOME", cache_.path().toUtf8()); }

    void an_afternoon_from_card_to_bundle() {
        const Family family;
        const Run imported =
            album({"import", family.album(), text(family.card / "DCIM"), "--into", "Mai", "--json"});
        QCOMPARE(imported.code, 0);
        QStringList fates;
        for (const QJsonObject& line : lines_of(imported)) {
            fates << line["fate"].toString();
            QVERIFY(line.contains("source") && line.contains("photo") && line["problem"].isNull());
        }
        QCOMPARE(fates, (QStringList{"imported", "imported", "duplicate"}));
        QVERIFY(lines_of(imported).at(0)["sound"].isNull());
        const QJsonObject sound = lines_of(imported).at(1)["sound"].toObject();
        QCOMPARE(sound["source"].toString(), "sound_file");
        QVERIFY(
            fs::exists(family.folder / "Mai/IMG_2.JPG.tags" / sound["recording"].toString().toStdString()));

        const Run added =
            album({"tag", "add", family.photo(), "--kind", "memo", "--from", text(family.card / "memo.wav"),
                   "--person", "Anna", "--language", "de-AT", "--json"});
        QCOMPARE(added.code, 0);
        const QJsonObject tag = lines_of(added).at(0);
        QCOMPARE(tag["kind"].toString(), "memo");
        QCOMPARE(tag["person"].toString(), "Anna");
        QCOMPARE(tag["language"].toString(), "de-AT");
        QCOMPARE(tag["duration_s"].toDouble(), 0.5);
        QVERIFY(!tag["recorded"].toString().isEmpty());
        QCOMPARE(lines_of(album({"tag", "list", family.photo(), "--json"})).at(0), tag);
        QCOMPARE(album({"person", "name", family.photo(), "Jörg", "--face", "0.5,0.5,0.2,0.3"}).code, 0);

        QCOMPARE(album({"scan", family.album()}).code, 0);
        for (const QStringList& query : {QStringList{"search", family.album(), "jorg"},
                                         {"search", family.album(), "ANN"},
                                         {"list", family.album(), "--person", "Jörg"}}) {
            const Run found = album(query + QStringList{"--json"});
            QCOMPARE(found.code, 0);
            QCOMPARE(lines_of(found).size(), std::size_t{1});
            QCOMPARE(lines_of(found)[0]["photo"].toString(), family.photo());
        }
        QCOMPARE(lines_of(album({"list", family.album(), "--json"})).size(), std::size_t{2});
        QCOMPARE(album({"person", "record", family.album(), "Jörg", "--from", text(family.card / "memo.wav")})
                     .code,
                 0);
        QCOMPARE(album({"person", "language", family.album(), "Jörg"}).out, QByteArray());
        QCOMPARE(album({"person", "language", family.album(), "Jörg", "de-AT"}).code, 0);
        QCOMPARE(album({"person", "language", family.album(), "Jörg", "de_AT"}).code, 1);
        QCOMPARE(album({"person", "language", family.album(), "Jörg"}).out, QByteArray("de-AT\n"));
        const QJsonObject person = lines_of(album({"person", "list", family.album(), "--json"})).at(0);
        QCOMPARE(person["person"].toString(), "Jörg");
        QCOMPARE(person["language"].toString(), "de-AT");
        QCOMPARE(album({"person", "list", family.album()}).out,
                 QByteArray("Jörg\t1\tname recorded\tread as de-AT\n"));
        QCOMPARE(album({"person", "rename", family.album(), "Jörg", "Georg"}).code, 0);
        QCOMPARE(album({"person", "language", family.album(), "Jörg"}).out, QByteArray());
        QCOMPARE(album({"person", "language", family.album(), "Georg"}).out, QByteArray("de-AT\n"));
        QVERIFY(fs::exists(family.folder / ".touchphoto/people/Georg.flac"));
        const QJsonObject shown = lines_of(album({"show", family.photo(), "--json"})).at(0);
        QCOMPARE(shown["persons"].toArray(), QJsonArray{"Georg"});
        QCOMPARE(shown["faces"].toArray().at(0)["name"].toString(), "Georg");
        QCOMPARE(shown["tags"].toArray().at(0).toObject(), tag);

        const QString file = tag["file"].toString();
        QCOMPARE(album({"tag", "trim", family.photo(), file, "--begin", "0.1", "--end", "0.3"}).code, 0);
        const QJsonObject trimmed = lines_of(album({"tag", "list", family.photo(), "--json"})).at(0);
        QCOMPARE(trimmed["duration_s"].toDouble(), 0.2);
        QCOMPARE(album({"tag", "label", family.photo(), trimmed["file"].toString(), "--kind", "story"}).code,
                 0);
        QCOMPARE(lines_of(album({"tag", "list", family.photo(), "--json"})).at(0)["person"].toString(),
                 "Anna");
        QCOMPARE(album({"tag", "delete", family.photo(), trimmed["file"].toString()}).code, 0);
        const auto trash = lines_of(album({"trash", "list", family.album(), "--json"}));
        QCOMPARE(trash.size(), std::size_t{2});
        QCOMPARE(album({"trash", "restore", family.album(), trash[0]["id"].toString()}).code, 0);
        QCOMPARE(lines_of(album({"tag", "list", family.photo(), "--json"})).at(0)["kind"].toString(),
                 "story");
        QCOMPARE(album({"trash", "empty", family.album()}).code, 2);
        QCOMPARE(album({"trash", "empty", family.album(), "--yes"}).code, 0);

        const Run checked = album({"check", family.album(), "--json"});
        QVERIFY2(checked.code == 0, checked.out);
        QCOMPARE(lines_of(checked).at(0)["photos"].toInt(), 2);
        QCOMPARE(lines_of(checked).at(0)["recordings"].toInt(), 2);
        QCOMPARE(album({"person", "language", family.album(), "Georg", ""}).code, 0);
        QVERIFY(!fs::exists(family.folder / ".touchphoto/people/Georg.language"));
        const QString bundle = text(family.card / "f.touchphoto");
        QCOMPARE(album({"export", family.album(), "--to", bundle}).code, 0);
        const AlbumFolder other;
        QCOMPARE(album({"import", text(other.path()), bundle}).code, 0);
        QCOMPARE(QByteArray::fromStdString(other.read("Mai/IMG_1.JPG.xmp")),
                 QByteArray::fromStdString(family.folder.read("Mai/IMG_1.JPG.xmp")));
    }

    void no_verb_changes_the_bytes_of_a_photograph() {
        const Family family;
        const AlbumFolder other;
        const auto photographs_in = [](const AlbumFolder& folder) {
            std::set<std::string> photographs;
            for (const auto& [name, bytes] : folder.files())
                if (bytes.starts_with("\xFF\xD8"))
                    photographs.insert(bytes);
            return photographs;
        };
        const auto originals = photographs_in(family.card);
        QCOMPARE(originals.size(), std::size_t{2});
        const QString folder = family.album(), photo = family.photo(), memo = text(family.card / "memo.wav");
        const QString bundle = text(family.card / "family.touchphoto"), face = "0.5,0.5,0.2,0.3";
        QStringList files; // of the recordings, as the steps find them
        const auto does = [&](const QStringList& words) {
            const Run run = album(words);
            QVERIFY2(run.code == 0, qPrintable(words.join(' ') + ": " + run.err));
            QVERIFY2(photographs_in(family.folder) == originals, qPrintable(words.join(' ')));
            files.clear();
            for (const QJsonObject& tag : lines_of(album({"tag", "list", photo, "--json"})))
                files << tag["file"].toString();
        };
        does({"import", folder, text(family.card / "DCIM"), "--into", "Mai"});
        does({"tag", "add", photo, "--kind", "memo", "--from", memo});
        does({"tag", "add", photo, "--kind", "story", "--from", memo});
        QCOMPARE(files.size(), 2);
        does({"tag", "label", photo, files[0], "--kind", "place"});
        does({"tag", "order", photo, files[1], files[0]});
        does({"tag", "trim", photo, files[0], "--begin", "0.1", "--end", "0.3"});
        does({"tag", "delete", photo, files[0]});
        does({"person", "name", photo, "Anna", "--face", face});
        does({"scan", folder});
        does({"person", "record", folder, "Anna", "--from", memo});
        does({"person", "rename", folder, "Anna", "Tom"});
        does({"list", folder});
        does({"search", folder, "Tom"});
        does({"show", photo});
        does({"export", folder, "--to", bundle});
        does({"trash", "restore", folder,
              lines_of(album({"trash", "list", folder, "--json"})).at(0)["id"].toString()});
        does({"trash", "empty", folder, "--yes"});
        family.folder.write(".touchphoto-999999999-1.tmp", "half");
        does({"check", folder, "--mend"});
        does({"rebuild", folder});
        fs::rename(family.folder / "Mai/IMG_1.JPG", family.folder / "garden.JPG");
        does({"scan", folder});
        does({"import", text(other.path()), bundle});
        QVERIFY(photographs_in(other) == originals);
    }

    void a_photograph_is_said_in_words() {
        const QString photo = tp::test::in_source("resources/samples/anna_smiling.jpg");
        const QJsonObject shown = lines_of(album({"show", photo, "--json"})).at(0);
        const QJsonObject face = shown["seen"].toObject()["faces"].toArray().at(0).toObject();
        QVERIFY(face["expression"].toString().contains("smiling"));
        QCOMPARE(face["facing"].toString(), "camera");
        const QJsonObject words = shown["words"].toObject();
        QCOMPARE(words["en"].toObject()["short"].toString().left(12), QString("one person, "));
        QCOMPARE(words["de"].toObject()["full"].toString().left(13), QString("Eine Person, "));
        QVERIFY(words["ko"].toObject()["full"].toString().startsWith(QString::fromUtf8("한 사람")));
        QVERIFY(album({"show", photo}).out.contains("in words     One person, "));
    }

    void a_check_says_and_mends() {
        const Family family;
        QCOMPARE(album({"import", family.album(), text(family.card / "DCIM")}).code, 0);
        family.folder.write(".touchphoto-999999999-1.tmp", "half");
        const Run said = album({"check", family.album()});
        QCOMPARE(said.code, 1);
        QVERIFY(said.out.contains("With --mend: It is deleted."));
        QCOMPARE(album({"check", family.album(), "--mend"}).code, 0);
        QCOMPARE(album({"check", family.album()}).code, 0);
    }

    void a_moved_photograph_is_known_and_an_index_is_rebuilt_the_same() {
        const Family family;
        QCOMPARE(album({"import", family.album(), text(family.card / "DCIM")}).code, 0);
        QCOMPARE(album({"tag", "add", text(family.folder / "IMG_1.JPG"), "--kind", "memo", "--from",
                        text(family.card / "memo.wav")})
                     .code,
                 0);
        QCOMPARE(album({"scan", family.album()}).code, 0);
        const fs::path renamed = family.folder / "renamed.jpg";
        fs::rename(family.folder / "IMG_1.JPG", renamed);
        const QJsonObject looked = lines_of(album({"scan", family.album(), "--look-only", "--json"})).at(0);
        QCOMPARE(looked["moves"].toArray().at(0)["to"].toString(), text(renamed));
        QVERIFY(looked["followed"].toArray().isEmpty());
        QVERIFY(lines_of(album({"tag", "list", text(renamed), "--json"})).empty());
        const QJsonObject report = lines_of(album({"scan", family.album(), "--json"})).at(0);
        QCOMPARE(report["followed"].toArray(), looked["moves"].toArray());
        QCOMPARE(lines_of(album({"tag", "list", text(renamed), "--json"})).size(), std::size_t{1});
        QVERIFY(lines_of(album({"scan", family.album(), "--json"})).at(0)["moves"].toArray().isEmpty());
        const QByteArray listed = album({"list", family.album(), "--json"}).out;
        QCOMPARE(album({"rebuild", family.album()}).code, 0);
        QCOMPARE(album({"list", family.album(), "--json"}).out, listed);
    }

    void bad_words_and_bad_files_are_said_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("code");
        QTest::newRow("no verb") << QStringList{} << 2;
        QTest::newRow("unknown verb") << QStringList{"dance"} << 2;
        QTest::newRow("no kind") << QStringList{"tag", "add", "x.jpg", "--from", "y.wav", "--kind", "song"}
                                 << 2;
        QTest::newRow("no sound named") << QStringList{"tag", "add", "x.jpg"} << 2;
        QTest::newRow("no photograph") << QStringList{"tag", "add", "/missing/x.jpg", "--from", "y.wav"} << 1;
        QTest::newRow("no album") << QStringList{"check", "/missing"} << 1;
        QTest::newRow("no folder") << QStringList{"scan", "/missing"} << 1;
        QTest::newRow("nothing to import") << QStringList{"import", "/tmp"} << 2;
        QTest::newRow("no face") << QStringList{"person", "name", "x.jpg", "Anna", "--face", "1,2"} << 2;
        QTest::newRow("no album for a name")
            << QStringList{"person", "language", "/missing", "Anna", "fr"} << 1;
        QTest::newRow("no language") << QStringList{"person", "language", "/tmp", "Anna", "French, please"}
                                     << 1;
        QTest::newRow("no such entry") << QStringList{"trash", "restore", "/tmp", "../x"} << 1;
        QTest::newRow("no end") << QStringList{"tag", "trim", "x.jpg", "y.flac"} << 2;
        QTest::newRow("no file to write") << QStringList{"export", "/tmp"} << 2;
    }

    void bad_words_and_bad_files_are_said() {
        QFETCH(QStringList, words);
        QFETCH(int, code);
        const Run run = album(words);
        QCOMPARE(run.code, code);
        QVERIFY(!run.err.isEmpty() && run.out.isEmpty());
        if (code == 1)
            QVERIFY2(is_one_sentence(run.err), run.err);
    }

    void help_tells_of_every_verb() {
        for (const char* verb : {"", "scan", "list", "search", "show", "import", "export", "tag", "person",
                                 "trash", "check", "rebuild"}) {
            QStringList words{"--help"};
            if (*verb)
                words.prepend(verb);
            const Run run = album(words);
            QCOMPARE(run.code, 0);
            QVERIFY2(run.out.contains("touchphoto-lab album"), verb);
        }
    }
};

QTEST_GUILESS_MAIN(AlbumVerbTest)
#include "album_test.moc"
