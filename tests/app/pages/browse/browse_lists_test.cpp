// SPDX-License-Identifier: Apache-2.0
#include "browse_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QString>
#include <QStringList>
#include <QTest>
#include <QVariantMap>

#include <filesystem>
#include <string>

namespace browse_lists_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;
using Topic = BrowseLists::Topic;
using View = BrowseTrail::View;

class BrowseListsTest : public QObject {
    Q_OBJECT
private slots:
    void people_and_the_photographs_of_one() {
        PartsAtGarden bench;
        bench.lists().openTopic(Topic::People);
        QCOMPARE(bench.trail().view(), View::Names);
        QCOMPARE(bench.row_texts(), QStringList({"Anna", "Ben", "Tom"}));
        QCOMPARE(bench.said(), QString("People: 3 person(s). Choose one with the arrow keys and Enter."));
        bench.lists().reach(0);
        QCOMPARE(bench.said(), QString("Anna, 2 photograph(s)"));
        bench.trail().next(); // arrows are for the rows here
        QCOMPARE(bench.trail().view(), View::Names);
        bench.lists().choose(0);
        QCOMPARE(bench.trail().view(), View::Photos);
        QCOMPARE(bench.said(), "Anna, 1 of 2: " + garden_words);
        bench.trail().next();
        QCOMPARE(bench.trail().placeText(), QString("2 of 2"));
        bench.trail().next();
        QCOMPARE(bench.said(), QString("This is the last photograph."));
        bench.lists().back();
        QCOMPARE(bench.trail().view(), View::Names);
        QCOMPARE(bench.lists().chosenRow(), 0);
        bench.lists().back();
        QCOMPARE(bench.trail().title(), QString("All photographs"));
        QCOMPARE(bench.trail().photo(), QString::fromStdString(bench.five.garden.string()));
        bench.earcon();
        bench.lists().back();
        QCOMPARE(bench.earcon(), Earcon::list_end);
    }

    void a_row_that_is_none_is_not_chosen() {
        PartsAtGarden bench;
        bench.lists().openTopic(Topic::People);
        bench.lists().choose(-1);
        QCOMPARE(bench.said(), QString("Go to a row first."));
        QCOMPARE(bench.earcon(), Earcon::error);
        bench.lists().choose(99);
        QCOMPARE(bench.trail().view(), View::Names);
    }

    void a_list_that_stays_as_it_is_is_not_made_anew() {
        PartsAtGarden bench;
        bench.lists().openTopic(Topic::People);
        QSignalSpy rows(&bench.lists(), &BrowseLists::rowsChanged);
        bench.drawn.photo("another.jpg", "2026-07-01T10:15:00");
        QTRY_COMPARE(bench.trail().count(), 6);
        QCOMPARE(rows.count(), 0);
        bench.drawn.name(bench.five.sea, "Eva", 0.5);
        bench.drawn.album->touched(bench.five.sea);
        QTRY_COMPARE(bench.row_texts(), QStringList({"Anna", "Ben", "Eva", "Tom"}));
    }

    void years_from_the_newest_and_places() {
        PartsAtGarden bench;
        bench.lists().openTopic(Topic::Years);
        QCOMPARE(bench.row_texts(), QStringList({"2026", "2025", "2024"}));
        QCOMPARE(bench.lists().rows().at(1).toMap()["detail"].toString(), QString("2 photograph(s)"));
        bench.lists().choose(1);
        QCOMPARE(bench.said(), QString("2025, 1 of 2: July 2025, Trieste; no recordings yet."));
        bench.lists().openTopic(Topic::Places);
        QCOMPARE(bench.row_texts(), QStringList({"Trieste", "Vienna"}));
        bench.lists().choose(1);
        QCOMPARE(bench.trail().placeText(), QString("1 of 2"));
        bench.lists().openTopic(Topic::Keywords);
        QCOMPARE(bench.said(), QString("Keywords: there are none yet."));
        bench.lists().allPhotos();
        QCOMPARE(bench.trail().title(), QString("All photographs"));
        QVERIFY(bench.lists().rows().isEmpty());
    }

    void a_long_list_comes_in_parts() {
        BrowseParts bench;
        const fs::path photo = bench.drawn.photo("many.jpg", "2026-05-01T10:15:00");
        SidecarChanges changes;
        changes.keywords.emplace();
        for (int i = 0; i < 130; ++i)
            changes.keywords->push_back("word " + std::to_string(1000 + i));
        QCOMPARE(write_sidecar(photo, changes), std::string());
        bench.start();
        bench.lists().openTopic(Topic::Keywords);
        QCOMPARE(bench.lists().rows().size(), 101);
        QCOMPARE(bench.lists().found(), QString("The first 100"));
        bench.lists().choose(100);
        QCOMPARE(bench.lists().rows().size(), 130);
        bench.lists().choose(129);
        QCOMPARE(bench.trail().title(), QString("word 1129"));
    }

    void search_suggests_finds_and_counts() {
        PartsAtGarden bench;
        bench.lists().openSearch();
        QVERIFY(bench.said().startsWith("Search."));
        bench.lists().type("an");
        QCOMPARE(bench.row_texts().mid(0, 1), QStringList("Anna"));
        QCOMPARE(bench.lists().rows().at(0).toMap()["detail"].toString(), QString("person, 2 photograph(s)"));
        QCOMPARE(bench.lists().rows().size(), 3);
        bench.lists().tellFound();
        QCOMPARE(bench.said(), QString("2 photograph(s), 1 suggestion(s)."));
        bench.lists().type("tom gard");
        QCOMPARE(bench.row_texts(), QStringList(garden_words));
        bench.lists().choose(0);
        QCOMPARE(bench.said(), "Found: tom gard, 1 of 1: " + garden_words);
        bench.lists().back();
        QCOMPARE(bench.trail().view(), View::Search);
        QCOMPARE(bench.lists().typed(), QString("tom gard"));
        bench.lists().type("nobody of that name");
        bench.lists().tellFound();
        QCOMPARE(bench.said(), QString("0 photograph(s)."));
        bench.lists().type("an");
        bench.lists().choose(0);
        QCOMPARE(bench.said(), "Anna, 1 of 2: " + garden_words);
    }

    void a_name_is_spelt_without_a_keyboard() {
        PartsAtGarden bench;
        bench.lists().openSearch();
        const auto letter = [&](const char* one) {
            return static_cast<int>(bench.lists().letters().indexOf(one));
        };
        QVERIFY(letter("T") >= 0 && letter("V") >= 0);
        QCOMPARE(letter("Q"), -1);
        bench.lists().reachLetter(letter("T"));
        QCOMPARE(bench.said(), QString("T"));
        bench.lists().addLetter(letter("T"));
        QCOMPARE(bench.lists().typed(), QString("T"));
        bench.lists().addLetter(letter("O"));
        QCOMPARE(bench.said(), QString("To: 2 photograph(s), 1 suggestion(s).")); // Tom, and tower.jpg
        QCOMPARE(bench.lists().letters(), QStringList({"M", "W"}));
        bench.lists().addLetter(letter("M"));
        QCOMPARE(bench.lists().letters(), QStringList());
        bench.lists().addLetter(0); // there is none
        QCOMPARE(bench.lists().typed(), QString("Tom"));
        bench.lists().takeLetterBack();
        QCOMPARE(bench.lists().typed(), QString("To"));
        bench.lists().takeLetterBack();
        bench.lists().takeLetterBack();
        QCOMPARE(bench.said(), QString("The search field is empty."));
        bench.lists().takeLetterBack();
        QCOMPARE(bench.said(), QString("There is no letter to delete."));
    }

    void what_was_found_is_gone_through() {
        PartsAtGarden bench;
        bench.lists().openSearch();
        bench.lists().type("vienna");
        QCOMPARE(bench.lists().rows().size(), 3); // the place, and two photographs
        bench.lists().choose(2);
        QCOMPARE(bench.trail().placeText(), QString("2 of 2"));
        bench.trail().previous();
        QCOMPARE(bench.trail().placeText(), QString("1 of 2"));
    }

    void a_level_that_is_empty_is_left() {
        PartsAtGarden bench;
        bench.lists().openTopic(Topic::People);
        bench.lists().choose(2);
        QCOMPARE(bench.trail().title(), QString("Tom"));
        fs::remove(bench.five.garden);
        QTRY_COMPARE(bench.trail().view(), View::Names);
        QCOMPARE(bench.row_texts(), QStringList({"Anna", "Ben"}));
    }
};

} // namespace browse_lists_test

TP_TEST(browse_lists_test, BrowseListsTest, window)
#include "browse_lists_test.moc"
