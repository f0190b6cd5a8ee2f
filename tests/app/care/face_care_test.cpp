// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"
#include "app/care/face_care.hpp"
#include "care_bench.hpp"

#include <QSignalSpy>

#include <cmath>

using namespace tp;
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
    FaceCare faces{photo, finder, teller, [](const QString& typed) {
                       QStringList all{"Anna", "Bert", "Tom"};
                       return all.filter(typed, Qt::CaseInsensitive);
                   }};

    void open(const std::string& name = "a.jpg") {
        const fs::path place = album.photo(name);
        photo.open({place, &album.album->keeper_for(place)});
        rest();
    }
    void rest() { CARE_TRY_VERIFY(!steps.busy() && !faces.looking()); }
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

QTEST_MAIN(FaceCareTest)
#include "face_care_test.moc"
