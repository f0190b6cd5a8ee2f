// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/seen_photos.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "care_bench.hpp"

#include <QAbstractItemModel>
#include <QMimeData>
#include <QSet>
#include <QSignalSpy>

using namespace tp;
namespace fs = std::filesystem;

namespace {

QStringList names(const PhotoRows& rows) {
    QStringList names;
    for (int i = 0; i < rows.rowCount(); ++i)
        names << rows.data(rows.index(i), PhotoRows::NameRole).toString();
    return names;
}

QUrl url(const fs::path& file) { return QUrl::fromLocalFile(QString::fromStdString(file.string())); }

} // namespace

class CareSessionTest : public QObject {
    Q_OBJECT
private slots:
    void entering_tells_where_one_is_and_what_can_be_done() {
        CareBench empty({}, false);
        empty.session->enter();
        QCOMPARE(empty.last_said(), QString("Look after the album. It has no folder yet. Import photographs, "
                                            "and choose where to keep them."));
        CareBench two({"a.jpg", "b.jpg"});
        two.session->enter();
        QCOMPARE(two.last_said(),
                 QString("Look after the album. 2 photograph(s). Choose one, or import more."));
        two.open("a.jpg");
        two.session->enter();
        QVERIFY(two.last_said().contains("a.jpg is open"));
    }

    // --- the list ---

    void the_newest_photograph_comes_first_page_by_page() {
        std::vector<std::string> many;
        for (int i = 0; i < 120; ++i)
            many.push_back(QString("p%1.jpg").arg(i, 3, 10, QChar('0')).toStdString());
        CareBench bench(many);
        PhotoRows& rows = *bench.session->photos();
        QCOMPARE(rows.total(), 120);
        QCOMPARE(rows.rowCount(), 50);
        QVERIFY(rows.canFetchMore({}));
        rows.fetchMore({});
        rows.fetchMore({});
        QCOMPARE(rows.rowCount(), 120);
        rows.fetchMore({});
        QVERIFY(!rows.canFetchMore({}));
        QSet<QString> all;
        for (const QString& name : names(rows))
            all << name;
        QCOMPARE(all.size(), 120);
    }

    void a_row_tells_who_is_on_it_how_many_recordings_and_a_missing_description() {
        CareBench bench;
        PhotoRows& rows = *bench.session->photos();
        QCOMPARE(rows.data(rows.index(0), PhotoRows::DetailRole).toString(), QString("No description."));
        bench.open("a.jpg");
        bench.session->descriptions()->typeAltText("A garden");
        bench.session->descriptions()->save();
        QVERIFY(bench.rests());
        bench.session->recordings()->addFiles({url(a_sound(bench.folder, "x.wav", 0.5, 440.0))}, 0);
        QVERIFY(bench.rests());
        CARE_TRY_COMPARE(rows.data(rows.index(0), PhotoRows::DetailRole).toString(), QString("1 recording(s)."));
    }

    void what_a_row_says_changes_without_the_list_being_made_anew() {
        CareBench bench({"a.jpg", "b.jpg"});
        QSignalSpy resets(bench.session->photos(), &QAbstractItemModel::modelReset);
        bench.open("a.jpg");
        bench.session->descriptions()->typeAltText("A garden");
        bench.session->descriptions()->save();
        QVERIFY(bench.rests());
        QCOMPARE(resets.size(), 0);
    }

    void a_thumbnail_comes_later() {
        CareBench bench({"a.png"}, true, true);
        PhotoRows& rows = *bench.session->photos();
        QVERIFY(rows.data(rows.index(0), PhotoRows::PictureRole).value<QImage>().isNull());
        CARE_TRY_VERIFY(!rows.data(rows.index(0), PhotoRows::PictureRole).value<QImage>().isNull());
        const QImage picture = rows.data(rows.index(0), PhotoRows::PictureRole).value<QImage>();
        QCOMPARE(std::max(picture.width(), picture.height()), Thumbnails::side_px);
    }

    void faces_that_look_wrong_come_first_those_without_a_face_last() {
        const AlbumFolder folder;
        fs::create_directories(folder / "album");
        for (const char* name : {"good.png", "none.png", "bad.png", "doubtful.png"})
            a_picture(folder, fs::path("album") / name, 1);
        Preferences preferences;
        preferences.change([&](Choices& choices) { choices.folders << QString::fromStdString((folder / "album").string()); });
        OpenAlbum album(folder / "cache", preferences);
        CARE_TRY_VERIFY(!album.scanning());
        FaceFinder finder([](const fs::path& photo, const std::stop_token&) {
            FoundFaces found;
            if (photo.filename() != "none.png") {
                Face face;
                face.contours = {Contour{feature::outline, {}, false}};
                face.quality = {{photo.filename() == "bad.png" ? 3.0 : 0.5, {}}};
                face.problem = photo.filename() == "doubtful.png" ? "It may be covered." : "";
                found.extraction.faces.push_back(face);
            }
            return found;
        });
        Thumbnails thumbnails;
        PhotoRows rows(album, finder, thumbnails, [] { return QString("en"); });
        rows.setOrder(PhotoRows::Order::LooksWrong);
        QCOMPARE(rows.rowCount(), 4);
        CARE_TRY_COMPARE(rows.leftToJudge(), 0);
        QCOMPARE(names(rows), QStringList({"doubtful.png", "bad.png", "good.png", "none.png"}));
        QVERIFY(rows.data(rows.index(1), PhotoRows::DetailRole).toString().startsWith("Faces about 3.0 % off."));
        QVERIFY(rows.data(rows.index(0), PhotoRows::DetailRole).toString().startsWith("Faces look wrong: 0.5 % off."));
        QVERIFY(rows.data(rows.index(3), PhotoRows::DetailRole).toString().startsWith("No face found."));
        rows.setOrder(PhotoRows::Order::NewestFirst);
        QCOMPARE(rows.rowCount(), 4);
    }

    // --- one photograph ---

    void mending_and_printing_are_asked_for_with_the_photograph() {
        CareBench bench;
        QSignalSpy mend(bench.session.get(), &CareSession::mendAsked), print(bench.session.get(), &CareSession::printAsked);
        bench.session->mend();
        bench.session->print();
        QVERIFY(mend.isEmpty() && print.isEmpty());
        bench.session->openRow(0);
        QVERIFY(bench.session->photoOpen());
        bench.session->mend();
        bench.session->print();
        QCOMPARE(mend.at(0).at(0).toString().toStdString(), bench.photo("a.jpg").string());
        QCOMPARE(print.at(0).at(0).toString().toStdString(), bench.photo("a.jpg").string());
        QVERIFY(bench.rests());
    }

    void a_photograph_is_deleted_and_comes_back_open() {
        CareBench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        bench.session->deletePhoto();
        QVERIFY(bench.rests());
        QVERIFY(!fs::exists(bench.photo("a.jpg")));
        QVERIFY(!bench.session->photoOpen());
        CARE_TRY_COMPARE(names(*bench.session->photos()), QStringList{"b.jpg"});
        CARE_TRY_COMPARE(bench.last_said(), QString("Deleted: a.jpg. Undo brings it back."));
        QCOMPARE(bench.session->history()->undoText(), QString("a.jpg was deleted"));
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QVERIFY(fs::exists(bench.photo("a.jpg")));
        QCOMPARE(bench.session->photoName(), QString("a.jpg"));
        CARE_TRY_COMPARE(bench.session->photos()->rowCount(), 2);
        bench.session->history()->redo();
        QVERIFY(bench.rests());
        QVERIFY(!bench.session->photoOpen());
        CARE_TRY_COMPARE(bench.session->photos()->rowCount(), 1);
    }

    // --- descriptions ---

    void descriptions_are_saved_once_and_taken_back() {
        CareBench bench;
        bench.open("a.jpg");
        DescriptionCare& descriptions = *bench.session->descriptions();
        QVERIFY(!descriptions.unsaved());
        descriptions.typeAltText("A garden ");
        descriptions.typeDescription("Two people in a garden, laughing.");
        QVERIFY(descriptions.unsaved());
        descriptions.save();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("The description is saved."));
        QVERIFY(!descriptions.unsaved());
        QCOMPARE(descriptions.altText(), QString("A garden"));
        QCOMPARE(bench.record().alt_text.at("en"), std::string("A garden"));
        QCOMPARE(bench.record().description.at("en"), std::string("Two people in a garden, laughing."));
        descriptions.save();
        QVERIFY(!bench.session->busy());
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QCOMPARE(descriptions.altText(), QString());
        QVERIFY(!descriptions.unsaved());
    }

    void what_is_seen_is_suggested_and_kept_only_when_it_is_taken() {
        CareBench bench;
        SeenPhoto seen;
        seen.width = seen.height = 100;
        bench.open("a.jpg");
        DescriptionDraft& draft = *bench.session->draft();
        DescriptionCare& descriptions = *bench.session->descriptions();
        QVERIFY(draft.text().isEmpty());
        draft.take();
        QVERIFY(!descriptions.unsaved());
        const auto entry = bench.album->queries().find(bench.photo("a.jpg"));
        const auto photo = bench.album->queries().summary(entry.value()->id);
        QCOMPARE(SeenPhotos(bench.album->index(), 1).put(photo.value()->sha256, {seen, {}}), std::string());
        draft.looked_at(bench.photo("a.jpg"));
        QCOMPARE(draft.text(), QString("No faces. A square picture."));
        QVERIFY(!descriptions.unsaved() && descriptions.altText().isEmpty());
        draft.take();
        QCOMPARE(bench.last_said(), QString("No faces. A square picture."));
        QVERIFY(descriptions.unsaved() && draft.text().isEmpty());
        descriptions.save();
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().alt_text.at("en"), std::string("No faces. A square picture."));
        bench.session->history()->undo();
        QVERIFY(bench.rests());
        QVERIFY(bench.record().alt_text.empty());
        QCOMPARE(draft.text(), QString("No faces. A square picture."));
    }

    void what_another_program_wrote_for_everybody_is_changed_where_it_stands() {
        CareBench bench;
        SidecarChanges changes;
        changes.alt_text = LanguageTexts{{"x-default", "A cat"}};
        QCOMPARE(write_sidecar(bench.photo("a.jpg"), changes), std::string());
        bench.open("a.jpg");
        QCOMPARE(bench.session->descriptions()->altText(), QString("A cat"));
        bench.session->descriptions()->typeAltText("A dog");
        bench.session->descriptions()->save();
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().alt_text, (LanguageTexts{{"x-default", "A dog"}}));
    }

    void what_was_typed_is_kept_when_another_photograph_is_opened_or_the_page_is_left() {
        CareBench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        bench.session->descriptions()->typeAltText("A garden");
        bench.open("b.jpg");
        QCOMPARE(bench.session->descriptions()->altText(), QString());
        QCOMPARE(bench.record("a.jpg").alt_text.at("en"), std::string("A garden"));
        QVERIFY(bench.record("b.jpg").alt_text.empty());
        bench.session->descriptions()->typeDescription("More");
        bench.session->leave();
        QVERIFY(bench.rests());
        QCOMPARE(bench.record("b.jpg").description.at("en"), std::string("More"));
    }

    void what_was_typed_stays_where_it_could_not_be_saved() {
        CareBench bench;
        bench.open("a.jpg");
        bench.folder.write("album/a.jpg.xmp", "not XMP at all");
        bench.session->descriptions()->typeAltText("A garden");
        bench.session->descriptions()->save();
        QVERIFY(bench.rests());
        QVERIFY(bench.last_said().contains("a.jpg.xmp"));
        QCOMPARE(bench.session->descriptions()->altText(), QString("A garden"));
        QVERIFY(bench.session->descriptions()->unsaved());
    }

    // --- import ---

    void photographs_are_imported_and_told_with_what_was_there_and_what_failed() {
        CareBench bench({"a.jpg"});
        a_photo(bench.folder, "card/new.jpg", 7);
        a_photo(bench.folder, "card/again.jpg", 1); // the bytes of a.jpg
        fs::create_symlink("/nowhere/at/all", bench.folder / "card/broken.jpg");
        ImportCare& import = *bench.session->importing();
        import.import({url(bench.folder / "card")});
        QVERIFY(import.running());
        CARE_TRY_VERIFY(!import.running());
        QVERIFY2(import.report().startsWith("1 photograph(s) imported, 1 of them already in the album"),
                 qPrintable(import.report()));
        QCOMPARE(bench.last_said(), import.report());
        QVERIFY(fs::exists(bench.photo("new.jpg")));
        CARE_TRY_COMPARE(bench.session->photos()->rowCount(), 2);
    }

    void without_a_folder_one_is_asked_for_and_the_import_follows() {
        CareBench bench({}, false);
        const fs::path photo = a_photo(bench.folder, "card/new.jpg", 7);
        QSignalSpy wanted(bench.session->importing(), &ImportCare::folderWanted);
        bench.session->importing()->import({url(photo)});
        QCOMPARE(wanted.size(), 1);
        QVERIFY(!bench.session->importing()->running());
        bench.session->importing()->chooseFolder(url(bench.folder / "nowhere"));
        QCOMPARE(bench.last_said(), QString("The album needs a folder on this computer."));
        bench.session->importing()->chooseFolder(url(bench.folder / "album"));
        CARE_TRY_COMPARE(bench.session->importing()->report(), QString("1 photograph(s) imported."));
        QVERIFY(fs::exists(bench.folder / "album/new.jpg"));
        QVERIFY(bench.session->folders()->hasFolders());
        CARE_TRY_COMPARE(bench.session->photos()->rowCount(), 1);
    }

    void an_import_goes_to_the_folder_that_was_chosen() {
        CareBench bench({"a.jpg"});
        fs::create_directories(bench.folder / "second");
        bench.session->importing()->chooseFolder(url(bench.folder / "second"));
        QCOMPARE(bench.session->importing()->folders().size(), 2);
        bench.session->importing()->setFolder(1);
        bench.session->importing()->import({url(a_photo(bench.folder, "card/new.jpg", 7))});
        CARE_TRY_COMPARE(bench.session->importing()->report(), QString("1 photograph(s) imported."));
        QVERIFY(fs::exists(bench.folder / "second/new.jpg"));
    }

    void a_stopped_import_goes_on_or_is_given_up() {
        CareBench bench({}, true);
        for (int i = 0; i < 30; ++i)
            a_photo(bench.folder, "card/" + std::to_string(i) + ".jpg", 100 + i);
        ImportCare& import = *bench.session->importing();
        import.import({url(bench.folder / "card")});
        import.stop(); // before the first one, or soon after
        CARE_TRY_VERIFY(!import.running());
        QVERIFY(import.unfinished());
        QVERIFY(import.report().contains("stopped"));
        bench.start(); // as after a start of the program
        QVERIFY(bench.session->importing()->unfinished());
        bench.session->importing()->goOn();
        CARE_TRY_VERIFY(!bench.session->importing()->running());
        QVERIFY(!bench.session->importing()->unfinished());
        CARE_TRY_COMPARE(bench.session->photos()->total(), 30);

        bench.session->importing()->import({url(bench.folder / "card")});
        bench.session->importing()->stop();
        CARE_TRY_VERIFY(!bench.session->importing()->running());
        if (bench.session->importing()->unfinished())
            bench.session->importing()->giveUp();
        QVERIFY(!bench.session->importing()->unfinished());
    }

    void what_is_not_on_this_computer_is_not_imported() {
        CareBench bench;
        bench.session->importing()->import({QUrl("https://example.org/a.jpg")});
        QCOMPARE(bench.last_said(), QString("Only photographs and folders on this computer can be imported."));
        bench.session->importing()->import({url("/nowhere/at/all.jpg")});
        CARE_TRY_VERIFY(!bench.session->importing()->running());
        QVERIFY(bench.session->importing()->report().contains("/nowhere/at/all.jpg"));
    }
};

QTEST_MAIN(CareSessionTest)
#include "session_test.moc"
