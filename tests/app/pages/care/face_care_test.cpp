// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/name_languages.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/pages/care/face_care.hpp"
#include "care_bench.hpp"
#include "full_disk.hpp"
#include "known_faces.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <cmath>

namespace face_care_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

Face face_at(double left, double top, double size) {
    Face face;
    face.box = {Vec2(left, top), Vec2(left + size, top + size)};
    return face;
}

/// Two faces on a picture of 200 × 100 px: a larger one at the left, a smaller one at the right.
FoundFaces two_faces() {
    FoundFaces found;
    found.image = QImage(200, 100, QImage::Format_RGB32);
    found.image.fill(Qt::blue);
    found.extraction.width = 200;
    found.extraction.height = 100;
    found.extraction.faces = {face_at(20, 20, 50), face_at(140, 30, 30)};
    found.extraction.faces[1].problem = "It is turned to the side.";
    return found;
}

struct Bench {
    CareBench album{{"a.jpg", "b.jpg"}};
    CareTeller teller{album.narrator, album.earcons};
    KeeperSteps steps;
    CaredPhoto photo{steps};
    FoundFaces found = two_faces();
    FaceFinder finder{[this](const fs::path&, const std::stop_token&) { return found; }};
    FaceCare faces{photo, finder, *album.groups, teller, [](const QString& typed) {
                       QStringList all{"Anna", "Bert", "Tom"};
                       return all.filter(typed, Qt::CaseInsensitive);
                   }};

    void open(const std::string& name = "a.jpg") {
        const fs::path place = album.photo(name);
        photo.open({place, &album.album->keeper_for(place)});
        rest();
    }
    void rest() { CARE_TRY_VERIFY(!steps.busy() && !faces.looking()); }
    /// Names the larger face and opens it again.
    void name(const QString& name) {
        faces.choose(0);
        faces.name(name);
        rest();
        CARE_TRY_COMPARE(texts().value(1), name);
        faces.choose(1);
        QVERIFY(album.sounded(Earcon::saved));
    }
    std::string language_of(const std::string& person) const {
        const auto language = NameLanguages(*photo.place().keeper).of(person);
        return language ? *language : language.error();
    }
    QStringList texts() const {
        QStringList texts;
        for (const QVariant& face : faces.faces())
            texts << face.toMap()["text"].toString();
        return texts;
    }
};

} // namespace

class FaceCareTest : public QObject {
    Q_OBJECT
private slots:
    void faces_that_were_found_are_listed_with_their_crops() {
        Bench bench;
        bench.open();
        QCOMPARE(bench.texts(), QStringList({"Face without a name", "Face without a name"}));
        QCOMPARE(bench.faces.summary(), QString("2 face(s), 2 without a name."));
        QCOMPARE(bench.faces.faces().at(1).toMap()["problem"].toString(), QString("It is turned to the side."));
        const QImage crop = bench.faces.faces().at(0).toMap()["picture"].value<QImage>();
        QCOMPARE(crop.size(), QSize(76, 76)); // with a quarter more at each side, in whole pixels
    }

    void a_face_is_named_and_the_next_one_without_a_name_is_asked_for() {
        Bench bench;
        bench.open();
        QSignalSpy chosen(&bench.faces, &FaceCare::faceChosen);
        bench.faces.choose(0);
        QCOMPARE(bench.album.last_said(), QString("Face without a name, 1 of 2. Type a name or choose one below."));
        bench.faces.name("  Anna  Maria ");
        bench.rest();
        CARE_TRY_COMPARE(bench.album.last_said(), QString("Saved: Anna Maria. Who is the next face?"));
        QCOMPARE(chosen.size(), 2);
        const PhotoRecord record = bench.album.record();
        QCOMPARE(record.faces.size(), std::size_t{1});
        QCOMPARE(record.faces[0].name, std::string("Anna Maria"));
        QVERIFY(std::abs(record.faces[0].x - 45.0 / 200.0) < 1e-6);
        QVERIFY(std::abs(record.faces[0].height - 0.5) < 1e-6);
        QCOMPARE(record.persons, std::vector<std::string>{"Anna Maria"});
        QCOMPARE(bench.texts(), QStringList({"Face without a name", "Anna Maria"})); // those without a name first
        QCOMPARE(bench.faces.chosen(), 0);
        bench.faces.name("Tom");
        bench.rest();
        CARE_TRY_COMPARE(bench.album.last_said(), QString("Saved: Tom."));
        QCOMPARE(bench.faces.chosen(), -1);
        QCOMPARE(bench.texts(), QStringList({"Anna Maria", "Tom"})); // the larger one first
        QCOMPARE(bench.faces.summary(), QString("2 face(s), all with a name."));
    }

    void who_a_face_may_be_is_offered_and_one_word_is_enough() {
        Bench bench;
        const fs::path a = bench.album.photo("a.jpg"), b = bench.album.photo("b.jpg");
        bench.found.extraction.faces = {face_at(10, 20, 20), face_at(70, 20, 20)}; // as look_at places them
        bench.found.extraction.width = bench.found.extraction.height = 100;
        bench.found.extraction.faces[0].box = {Vec2(5, 20), Vec2(25, 40)};
        bench.found.extraction.faces[1].box = {Vec2(35, 20), Vec2(55, 40)};
        QCOMPARE(look_at(*bench.album.album, a, {1, 2}), std::string());
        QCOMPARE(look_at(*bench.album.album, b, {1, 2}), std::string());
        bench.album.groups->go_on();
        bench.open();
        for (const char* name : {"Anna", "Bert"}) {
            bench.faces.choose(0);
            bench.faces.name(name);
            bench.rest();
            CARE_TRY_VERIFY(bench.texts().contains(name));
            bench.album.album->touched(a);
        }
        bench.open("b.jpg");
        CARE_TRY_COMPARE(bench.texts(), QStringList({"Perhaps Anna", "Perhaps Bert"}));
        QVERIFY(bench.album.record("b.jpg").faces.empty());
        bench.faces.accept(0);
        CARE_TRY_COMPARE(bench.album.last_said(), QString("Saved: Anna. Perhaps Bert?"));
        CARE_TRY_COMPARE(bench.texts(), QStringList({"Perhaps Bert", "Anna"}));
        QCOMPARE(bench.album.record("b.jpg").faces.at(0).name, std::string("Anna"));
        bench.faces.choose(0); // somebody else, then
        QCOMPARE(bench.faces.suggestions("").value(0), QString("Bert"));
        bench.faces.accept(1); // has a name already
        bench.faces.name("Carl");
        bench.rest();
        CARE_TRY_COMPARE(bench.texts(), QStringList({"Anna", "Carl"}));
        bench.album.groups->set_on(false);
        bench.open("b.jpg");
        CARE_TRY_COMPARE(bench.texts(), QStringList({"Anna", "Carl"}));
    }

    /// The disk is slow; the person has gone on to another face, or to another photograph.
    void a_name_that_is_kept_late_moves_nothing_elsewhere() {
        Bench bench;
        bench.open();
        for (const bool same_photo : {true, false}) {
            SlowDisk disk("a.jpg.xmp");
            bench.faces.choose(same_photo ? 0 : 1);
            bench.faces.name(same_photo ? "Anna" : "Anne");
            CARE_TRY_VERIFY(disk.waits());
            if (!same_photo)
                bench.photo.open({bench.album.photo("b.jpg"), bench.photo.place().keeper});
            CARE_TRY_COMPARE(bench.faces.count(), 2);
            bench.faces.choose(1);
            const QSignalSpy chosen(&bench.faces, &FaceCare::faceChosen);
            disk.let(1);
            CARE_TRY_COMPARE(bench.album.last_said(),
                             same_photo ? QString("Saved: Anna.") : QString("Saved: Anne."));
            bench.rest();
            QCOMPARE(chosen.size(), 0); // the field for the name is left as it is
            QVERIFY(bench.faces.chosen() >= 0);
            QCOMPARE(bench.faces.chosenName(), QString());
        }
        QCOMPARE(bench.album.record("a.jpg").persons, std::vector<std::string>{"Anne"});
        QVERIFY(bench.album.record("b.jpg").persons.empty());
    }

    void of_one_face_alone_it_says_whether_it_has_a_name() {
        Bench bench;
        bench.found.extraction.faces.pop_back();
        bench.open();
        QCOMPARE(bench.faces.summary(), QString("One face, without a name."));
        bench.faces.choose(0);
        bench.faces.name("Anna");
        bench.rest();
        CARE_TRY_COMPARE(bench.faces.summary(), QString("One face, with a name."));
    }

    void nobody_takes_the_name_away() {
        Bench bench;
        bench.open();
        bench.faces.choose(0);
        bench.faces.name("Anna");
        bench.rest();
        CARE_TRY_COMPARE(bench.texts(), QStringList({"Face without a name", "Anna"}));
        bench.faces.choose(1);
        bench.faces.name("");
        bench.rest();
        CARE_TRY_COMPARE(bench.album.last_said(), QString("This face has no name now."));
        QVERIFY(bench.album.record().persons.empty());
    }

    void a_face_that_another_program_marked_wider_is_the_same_face() {
        Bench bench;
        SidecarChanges changes;
        changes.faces = {{0.225, 0.45, 0.35, 0.7, "Anna"}};
        QCOMPARE(write_sidecar(bench.album.photo("a.jpg"), changes), std::string());
        bench.open();
        QCOMPARE(bench.texts(), QStringList({"Face without a name", "Anna"}));
        bench.faces.choose(1);
        QCOMPARE(bench.faces.chosenName(), QString("Anna"));
        bench.faces.name("Bert");
        bench.rest();
        CARE_TRY_COMPARE(bench.texts(), QStringList({"Face without a name", "Bert"}));
        QCOMPARE(bench.album.record().faces.size(), std::size_t{1});
    }

    void a_marked_face_that_was_not_found_is_listed_too() {
        Bench bench;
        bench.found.extraction.faces.clear();
        SidecarChanges changes;
        changes.faces = {{0.5, 0.5, 0.2, 0.2, "Anna"}};
        QCOMPARE(write_sidecar(bench.album.photo("a.jpg"), changes), std::string());
        bench.open();
        QCOMPARE(bench.texts(), QStringList{"Anna"});
    }

    void a_name_is_read_in_a_language_of_its_own() {
        Bench bench;
        bench.open();
        bench.name("Giulia");
        QCOMPARE(bench.faces.language(), -1);
        const auto italian = static_cast<int>(bench.faces.languages().indexOf("italiano"));
        QVERIFY(italian >= 0);
        // the voice is told before it says so
        connect(&bench.photo, &CaredPhoto::name_languages_read, this,
                [&](const fs::path& album, const std::vector<NameLanguage>& names) {
                    QCOMPARE(album, bench.album.root());
                    SpokenNames spoken;
                    for (const NameLanguage& name : names)
                        spoken.push_back({QString::fromStdString(name.person), QString::fromStdString(name.language)});
                    bench.album.voice.set_name_languages(spoken);
                });
        bench.faces.readNameIn(italian);
        bench.rest();
        QCOMPARE(bench.album.last_said(), QString("Saved: Giulia. Language of the name: italiano."));
        QCOMPARE(bench.album.voice.names_when_said().back(), (SpokenNames{{"Giulia", "it"}}));
        QVERIFY(bench.album.sounded(Earcon::saved));
        QCOMPARE(bench.language_of("Giulia"), std::string("it"));
        QCOMPARE(bench.faces.language(), italian);
        QCOMPARE(bench.faces.chosen(), 1); // still open
        bench.faces.readNameIn(-1);
        bench.rest();
        QCOMPARE(bench.album.last_said(), QString("Saved: Giulia is read in the page's language."));
        QCOMPARE(bench.language_of("Giulia"), std::string());
        QCOMPARE(bench.faces.language(), -1);
        bench.steps.undo([](const QString&) {});
        bench.photo.read_again();
        bench.rest();
        QCOMPARE(bench.faces.language(), italian);
        QCOMPARE(bench.steps.next_undo(), QString("the language of the name of Giulia was chosen"));
    }

    void a_language_that_is_not_offered_is_kept_in_the_list() {
        Bench bench;
        bench.open();
        bench.name("Giulia");
        const QStringList usual = bench.faces.languages();
        QCOMPARE(usual, QStringList({"English", "Deutsch", "한국어", "français", "español", "italiano", "português",
                                     "Nederlands", "polski", "Türkçe", "Tiếng Việt"}));
        QCOMPARE(NameLanguages(*bench.photo.place().keeper).choose("Giulia", "sv"), std::string());
        QSignalSpy changed(&bench.faces, &FaceCare::languagesChanged);
        bench.photo.read_again();
        bench.rest();
        QCOMPARE(bench.faces.languages(), usual + QStringList{"svenska"});
        QCOMPARE(bench.faces.language(), static_cast<int>(usual.size()));
        bench.faces.readNameIn(0);
        bench.rest();
        QCOMPARE(bench.faces.language(), 0);
        QCOMPARE(changed.size(), 1); // it may be chosen again, and the keyboard stays where it is
        bench.faces.choose(0);
        QCOMPARE(bench.faces.languages(), usual);
    }

    void nothing_is_chosen_for_a_face_without_a_name_or_over_what_cannot_be_read() {
        Bench bench;
        bench.open();
        bench.faces.readNameIn(0); // no face is open
        bench.faces.choose(0);
        bench.faces.readNameIn(0);
        QVERIFY(!bench.steps.busy());
        bench.name("Giulia");
        bench.faces.readNameIn(99);
        QVERIFY(!bench.steps.busy());
        bench.album.folder.write("album/.touchphoto/people/Giulia.language", "?");
        bench.faces.readNameIn(0);
        bench.rest();
        QVERIFY(bench.album.last_said().contains("Giulia.language"));
        QVERIFY(bench.album.sounded(Earcon::error));
        QCOMPARE(bench.album.folder.read("album/.touchphoto/people/Giulia.language"), std::string("?"));
        QCOMPARE(bench.faces.language(), -1);
    }

    void people_are_suggested_those_on_the_photograph_last() {
        Bench bench;
        bench.open();
        QCOMPARE(bench.faces.suggestions(""), QStringList({"Anna", "Bert", "Tom"}));
        bench.faces.choose(0);
        bench.faces.name("Anna");
        bench.rest();
        CARE_TRY_COMPARE(bench.faces.suggestions(""), QStringList({"Bert", "Tom", "Anna"}));
        QCOMPARE(bench.faces.suggestions("to"), QStringList{"Tom"});
    }

    void a_sidecar_that_cannot_be_read_is_told_and_nothing_is_named() {
        Bench bench;
        bench.album.folder.write("album/a.jpg.xmp", "not XMP at all");
        bench.open();
        bench.faces.choose(0);
        bench.faces.name("Anna");
        bench.rest();
        CARE_TRY_VERIFY(bench.album.last_said().contains("a.jpg.xmp"));
        QCOMPARE(bench.faces.chosen(), 0); // still to be named
    }

    void another_photograph_has_nothing_of_the_one_before() {
        Bench bench;
        bench.open();
        bench.faces.choose(0);
        bench.found.extraction.faces.clear();
        bench.open("b.jpg");
        QCOMPARE(bench.faces.count(), 0);
        QCOMPARE(bench.faces.chosen(), -1);
        QCOMPARE(bench.faces.summary(), QString("No face was found on this photograph."));
        bench.faces.name("Anna"); // nothing is chosen
        QVERIFY(!bench.steps.busy());
    }
};

} // namespace face_care_test

TP_TEST(face_care_test, FaceCareTest, window)
#include "face_care_test.moc"
