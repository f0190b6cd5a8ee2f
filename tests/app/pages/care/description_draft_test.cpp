// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/seen_photos.hpp"
#include "app/pages/care/description_draft.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <filesystem>
#include <string>

namespace description_draft_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

const QString square = "No faces. A square picture.";
const std::string in_vienna =
    "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
    "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
    "<rdf:Description rdf:about=\"\" xmlns:photoshop=\"http://ns.adobe.com/photoshop/1.0/\" "
    "photoshop:City=\"Vienna\"/></rdf:RDF></x:xmpmeta>";

struct Bench : CareParts {
    QString language = "en";
    DescriptionCare descriptions{cared, teller, [this] { return language; }};
    DescriptionDraft draft{*album, cared, descriptions, teller, [this] { return language; }};
    using CareParts::CareParts;

    /// The program has looked at the photograph.
    void see(const std::string& name, int width_px) {
        SeenPhoto seen;
        seen.width = width_px;
        seen.height = 100;
        const auto entry = album->queries().find(photo(name));
        const auto known = album->queries().summary(entry.value()->id);
        QCOMPARE(SeenPhotos(album->index(), 1).put(known.value()->sha256, {seen, {}}), std::string());
    }
};

} // namespace

class DescriptionDraftTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_seen_is_suggested_and_kept_only_when_it_is_taken() {
        Bench bench;
        QSignalSpy changed(&bench.draft, &DescriptionDraft::changed);
        bench.open();
        bench.draft.take();
        QVERIFY(bench.draft.text().isEmpty() && !bench.descriptions.unsaved() &&
                bench.voice.said().isEmpty());
        bench.see("a.jpg", 100);
        bench.draft.looked_at(bench.photo("a.jpg"));
        QCOMPARE(bench.draft.text(), square);
        QCOMPARE(changed.size(), 1);
        bench.draft.looked_at(bench.photo("a.jpg"));
        QCOMPARE(changed.size(), 1);
        QVERIFY(!bench.descriptions.unsaved() && bench.descriptions.altText().isEmpty());
        bench.draft.take();
        QCOMPARE(bench.last_said(), square);
        QCOMPARE(bench.descriptions.altText(), square);
        QVERIFY(bench.descriptions.unsaved() && bench.draft.text().isEmpty());
        QCOMPARE(changed.size(), 2);
        bench.descriptions.save();
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().alt_text.at("en"), square.toStdString());
        bench.history.undo();
        QVERIFY(bench.rests());
        QVERIFY(bench.record().alt_text.empty());
        QCOMPARE(bench.draft.text(), square);
    }
    void who_types_a_description_is_offered_none() {
        Bench bench;
        bench.see("a.jpg", 100);
        bench.open();
        QCOMPARE(bench.draft.text(), square);
        bench.descriptions.typeAltText("A");
        QVERIFY(bench.draft.text().isEmpty());
        bench.draft.take();
        QCOMPARE(bench.descriptions.altText(), QString("A"));
        bench.descriptions.typeAltText("");
        QCOMPARE(bench.draft.text(), square);
        bench.descriptions.typeDescription("A long one"); // that is another matter
        QCOMPARE(bench.draft.text(), square);
    }
    void it_is_of_the_photograph_that_is_open() {
        Bench bench({"a.jpg", "b.jpg", "c.jpg"});
        bench.see("a.jpg", 100);
        bench.see("b.jpg", 300);
        bench.open("a.jpg");
        QCOMPARE(bench.draft.text(), square);
        bench.open("b.jpg");
        QVERIFY2(!bench.draft.text().isEmpty() && bench.draft.text() != square,
                 qPrintable(bench.draft.text()));
        bench.open("c.jpg");
        QVERIFY(bench.draft.text().isEmpty()); // nobody has looked at it
        QSignalSpy changed(&bench.draft, &DescriptionDraft::changed);
        bench.see("c.jpg", 100);
        bench.draft.looked_at(bench.photo("a.jpg"));
        QVERIFY(bench.draft.text().isEmpty() && changed.isEmpty());
        bench.draft.looked_at(bench.photo("c.jpg"));
        QCOMPARE(bench.draft.text(), square);
        bench.cared.close();
        QVERIFY(bench.draft.text().isEmpty());
    }
    void one_that_could_not_be_read_is_not_suggested_as_a_picture_without_faces() {
        Bench bench({"a.jpg", "b.jpg"});
        for (const char* name : {"album/a.jpg.xmp", "album/b.jpg.xmp"})
            bench.folder.write(name, in_vienna);
        bench.see("a.jpg", 0);
        bench.see("b.jpg", 100);
        bench.open("a.jpg");
        QVERIFY2(bench.draft.text().isEmpty(), qPrintable(bench.draft.text()));
        bench.open("b.jpg");
        QVERIFY2(bench.draft.text().contains("Vienna"), qPrintable(bench.draft.text()));
    }
    void it_is_in_the_albums_language() {
        Bench bench;
        bench.see("a.jpg", 100);
        bench.language = "de";
        bench.open();
        const QString german = bench.draft.text();
        QVERIFY2(!german.isEmpty() && german != square, qPrintable(german));
    }
    void of_a_photograph_that_another_program_deleted_nothing_is_suggested() {
        Bench bench;
        bench.see("a.jpg", 100);
        bench.open();
        QCOMPARE(bench.draft.text(), square);
        fs::remove(bench.photo("a.jpg"));
        bench.album->rescan();
        CARE_TRY_COMPARE(bench.album->index().totals()->missing, 1U);
        bench.cared.read_again();
        QVERIFY(bench.rests());
        QVERIFY2(bench.draft.text().isEmpty(), qPrintable(bench.draft.text()));
    }
};

} // namespace description_draft_test

TP_TEST(description_draft_test, DescriptionDraftTest, window)
#include "description_draft_test.moc"
