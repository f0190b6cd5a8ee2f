// SPDX-License-Identifier: Apache-2.0
#include "album_parts.hpp"
#include "app/album/grouping/album_faces.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "known_faces.hpp"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

#include <chrono>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// An album in which each photograph shows some of many people, side by side.
struct Ground {
    AlbumFolder folder;
    Preferences preferences;
    std::unique_ptr<OpenAlbum> album;
    std::unique_ptr<AlbumFaces> faces;
    std::shared_ptr<const People> people;
    std::map<std::string, std::vector<int>> shown;

    void photo(const std::string& name, const std::vector<int>& persons) {
        a_photo(folder, "album/" + name, static_cast<int>(shown.size()));
        shown[name] = persons;
    }
    fs::path path(const std::string& name) const { return fs::canonical(folder.path()) / "album" / name; }
    void start() {
        preferences.change([&](Choices& choices) {
            choices.folders = {QString::fromStdString((fs::canonical(folder.path()) / "album").string())};
        });
        album = std::make_unique<OpenAlbum>(folder / "cache", preferences, AlbumWatcher::Times{0ms, 1h});
        QVERIFY(QTest::qWaitFor([&] { return !album->scanning(); }, 30'000));
        begin();
    }
    void begin() {
        faces = std::make_unique<AlbumFaces>(*album);
        QObject::connect(faces.get(), &AlbumFaces::people, faces.get(),
                         [this](const std::shared_ptr<const People>& come) { people = come; });
    }
    void look(const std::string& name) {
        QCOMPARE(look_at(*album, path(name), shown.at(name)), std::string());
    }
    void look_at_all() {
        for (const auto& [name, _] : shown)
            look(name);
        faces->go_on();
    }
    /// Who is on the photographs, as the sidecar says it.
    void say(const std::string& name, const std::vector<std::string>& names) {
        SidecarChanges changes;
        double middle = 0.15;
        changes.faces.emplace();
        for (const std::string& person : names) {
            if (!person.empty())
                changes.faces->push_back({middle, 0.3, 0.2, 0.2, person});
            middle += 0.3;
        }
        QCOMPARE(write_sidecar(path(name), changes), std::string());
        album->touched(path(name));
    }
    /// "Anna 3(2), 2(2)": who is on how many photographs, with how many faces of which nobody has said who they are.
    QString told() {
        people.reset();
        faces->want_people(true);
        if (!QTest::qWaitFor([&] { return people != nullptr; }, 30'000))
            return "nothing came";
        QStringList all;
        for (const Person& person : people->persons)
            all << QString("%1 %2(%3)")
                       .arg(QString::fromStdString(person.name))
                       .arg(person.photos)
                       .arg(person.to_confirm)
                       .trimmed();
        return all.join(", ");
    }
    bool tells(const QString& words) {
        QString last;
        const bool so = QTest::qWaitFor(
            [&] { return !album->scanning() && !faces->grouping() && (last = told()) == words; }, 30'000);
        if (!so)
            qInfo("told instead: %s", qPrintable(last));
        return so;
    }
    QStringList offers(const std::string& name) {
        QSignalSpy offered(faces.get(), &AlbumFaces::offered);
        faces->ask(path(name));
        QStringList names;
        if (!offered.wait(30'000))
            return {"nothing came"};
        for (const FaceOffer& offer : offered[0][1].value<std::vector<FaceOffer>>())
            names << QString::fromStdString(offer.name);
        return names;
    }
    /// Says it from another thread, as the steps of a page do.
    Result<GroupsChange> word(const GroupWorker::Word& word) {
        std::future<Result<GroupsChange>> said =
            std::async(std::launch::async, [&] { return faces->say(word); });
        while (said.wait_for(1ms) != std::future_status::ready)
            QCoreApplication::processEvents();
        return said.get();
    }
    std::string undo(const GroupsChange& change) {
        std::future<std::string> done = std::async(std::launch::async, [&] { return faces->undo(change); });
        while (done.wait_for(1ms) != std::future_status::ready)
            QCoreApplication::processEvents();
        return done.get();
    }
};

/// Person 1 on four photographs, person 2 on three, person 3 on one.
void a_family(Ground& ground) {
    ground.photo("a.jpg", {1, 2});
    ground.photo("b.jpg", {1, 2});
    ground.photo("c.jpg", {1, 3});
    ground.photo("d.jpg", {2, 1});
}

} // namespace

class AlbumFacesTest : public QObject {
    Q_OBJECT
private slots:
    void faces_are_grouped_as_they_come() {
        Ground ground;
        a_family(ground);
        ground.start();
        QCOMPARE(ground.told(), QString());
        ground.look_at_all();
        QVERIFY(ground.tells("4(4), 3(3)"));
        QCOMPARE(ground.people->alone, std::size_t(1));
    }

    void one_name_in_a_sidecar_is_offered_for_all_others() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        QVERIFY(ground.tells("4(4), 3(3)"));
        QCOMPARE(ground.offers("b.jpg"), QStringList());
        ground.say("a.jpg", {"Anna", ""});
        QVERIFY(ground.tells("Anna 4(3), 3(3)"));
        QCOMPARE(ground.offers("b.jpg"), QStringList{"Anna"});
        QCOMPARE(ground.offers("a.jpg"), QStringList()); // there it is said
        ground.say("d.jpg", {"Bert", "Anna"});
        QVERIFY(ground.tells("Anna 4(2), Bert 3(2)"));
    }

    void a_name_that_is_taken_back_is_offered_no_more() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        ground.say("a.jpg", {"Anna", ""});
        QVERIFY(ground.tells("Anna 4(3), 3(3)"));
        ground.say("a.jpg", {"", ""});
        QVERIFY(ground.tells("4(4), 3(3)"));
        QCOMPARE(ground.offers("b.jpg"), QStringList());
    }

    void a_face_with_another_name_goes_to_its_own_and_back() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        ground.say("a.jpg", {"Anna", ""});
        QVERIFY(ground.tells("Anna 4(3), 3(3)")); // else either of two may be whose group it is
        ground.say("b.jpg", {"Clara", ""});       // a lookalike
        QVERIFY(ground.tells("Anna 3(2), 3(3), Clara 1(0)"));
        ground.say("b.jpg", {"Anna", ""});
        QVERIFY(ground.tells("Anna 4(2), 3(3)"));
    }

    void another_name_for_the_only_one_who_was_named_is_the_groups() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        ground.say("a.jpg", {"Ana", ""});
        QVERIFY(ground.tells("Ana 4(3), 3(3)"));
        ground.say("a.jpg", {"Anna", ""});
        QVERIFY(ground.tells("Anna 4(3), 3(3)"));
    }

    void what_a_person_says_is_kept_and_can_be_undone() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        QVERIFY(ground.tells("4(4), 3(3)"));
        const FaceId face = ground.people->persons[0].faces[0].id;
        const auto change = ground.word([&](FaceGroups& groups) { return groups.take_out(face); });
        QVERIFY(change);
        QVERIFY(ground.tells("3(3), 3(3)"));
        QCOMPARE(KnownFaces(ground.album->index()).all().value().apart.size(), std::size_t(1));
        ground.begin(); // the program anew
        QVERIFY(ground.tells("3(3), 3(3)"));
        QCOMPARE(ground.undo(*change), std::string());
        QVERIFY(ground.tells("4(4), 3(3)"));
        QVERIFY(!ground.undo(*change).empty()); // twice is once too often
        QVERIFY(!ground.word([](FaceGroups& groups) { return groups.merge(77, 78); }));
        ground.begin();
        QVERIFY(ground.tells("4(4), 3(3)"));
    }

    void a_program_that_ended_goes_on_with_the_rest() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look("a.jpg");
        ground.look("b.jpg");
        ground.faces->go_on();
        QVERIFY(ground.tells("2(2), 2(2)"));
        ground.faces.reset();
        ground.look("c.jpg");
        ground.look("d.jpg");
        ground.say("a.jpg", {"Anna", ""});
        QVERIFY(QTest::qWaitFor([&] { return !ground.album->scanning(); }, 30'000));
        ground.begin();
        ground.faces->go_on();
        QVERIFY(ground.tells("Anna 4(3), 3(3)"));
    }

    void groups_that_contradict_themselves_are_made_anew() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        QVERIFY(ground.tells("4(4), 3(3)"));
        ground.faces.reset();
        ground.album->index().connection().run_once("UPDATE known_faces SET numbers = x'00' WHERE id = 1");
        ground.begin();
        ground.faces->go_on();
        QVERIFY(ground.tells("3(3), 3(3)")); // without the spoilt one
    }

    void a_photograph_that_goes_takes_its_faces_along() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        QVERIFY(ground.tells("4(4), 3(3)"));
        fs::remove(ground.path("d.jpg"));
        ground.album->rescan();
        QVERIFY(ground.tells("3(3), 2(2)"));
        QCOMPARE(ground.album->index().forget(ground.path("d.jpg")), std::string());
        ground.faces->go_on();
        QVERIFY(ground.tells("3(3), 2(2)"));
        ground.begin();
        QVERIFY(ground.tells("3(3), 2(2)"));
    }

    void who_has_a_name_is_told_as_it_changes_and_nobody_when_off() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        QVERIFY(ground.tells("4(4), 3(3)"));
        QString named = "not told";
        connect(ground.faces.get(), &AlbumFaces::named, this, [&](const std::vector<NamedFaces>& people) {
            named.clear();
            for (const NamedFaces& person : people)
                named += QString("%1 %2 ").arg(QString::fromStdString(person.name)).arg(person.newest.size());
        });
        ground.faces->want_named();
        QTRY_COMPARE_WITH_TIMEOUT(named, QString(), 30'000);
        ground.say("a.jpg", {"Anna", ""});
        QTRY_COMPARE_WITH_TIMEOUT(named, QString("Anna 4 "), 30'000);
        ground.say("d.jpg", {"Bert", "Anna"});
        QTRY_COMPARE_WITH_TIMEOUT(named, QString("Anna 4 Bert 3 "), 30'000);
        ground.faces->set_on(false);
        QTRY_COMPARE_WITH_TIMEOUT(named, QString(), 30'000);
    }

    void off_forgets_everything_and_what_comes_all_the_same() {
        Ground ground;
        a_family(ground);
        ground.start();
        ground.look_at_all();
        ground.say("a.jpg", {"Anna", ""});
        QVERIFY(ground.tells("Anna 4(3), 3(3)"));
        ground.faces->set_on(false);
        QVERIFY(ground.tells(""));
        ground.look("d.jpg"); // one that was under way
        ground.faces->go_on();
        QVERIFY(QTest::qWaitFor(
            [&] {
                return KnownFaces(ground.album->index()).placed().value().empty() && ground.told().isEmpty();
            },
            30'000));
        ground.faces->set_on(true);
        ground.look_at_all();
        QVERIFY(ground.tells("Anna 4(3), 3(3)"));
    }
};

QTEST_GUILESS_MAIN(AlbumFacesTest)
#include "album_faces_test.moc"
