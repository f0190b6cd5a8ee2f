// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/sql_connection.hpp"
#include "browse_bench.hpp"

#include <QSignalSpy>
#include <QTest>

#include <filesystem>
#include <optional>

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;
using Topic = BrowseSession::Topic;
using State = BrowseSession::State;
using View = BrowseSession::View;

namespace {

const QString garden_words = "Anna and Tom, May 2026, Vienna; 2 recording(s).";

/// Five photographs, and one is at the garden.
struct AtGarden : BrowseBench {
    DrawnAlbum::Five five = drawn.five();
    AtGarden() {
        start();
        go_to(five.garden);
    }
    bool near(double tone_hz, double expected) const { return std::abs(tone_hz - expected) < 15.0; }
    QStringList row_texts() const {
        QStringList texts;
        for (const QVariant& row : session->rows())
            texts << row.toMap()["text"].toString();
        return texts;
    }
};

} // namespace

class BrowseSessionTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_where_one_is_and_what_can_be_done() {
        BrowseBench bench;
        bench.drawn.five();
        bench.start();
        QCOMPARE(bench.session->state(), State::Ready);
        QCOMPARE(bench.voice.said(),
                 QStringList("Your photographs, 1 of 5: February 2024, Vienna; no recordings yet. Swipe "
                             "or use the arrow keys to go on."));
    }

    void a_screen_reader_reads_the_photograph_itself_and_is_not_told_it_too() {
        BrowseBench bench;
        bench.drawn.five();
        bench.narrator.set_by(Narrator::By::screen_reader);
        bench.start();
        QCOMPARE(bench.narrator.sentence(), QString("Your photographs."));
        bench.session->next(); // the focus stays, so nothing is read by itself
        QCOMPARE(bench.narrator.sentence(), bench.session->summary());
    }

    void one_photograph_after_the_other_with_sounds_that_say_so() {
        AtGarden bench;
        bench.session->next();
        QCOMPARE(bench.said(), QString("Anna and Ben, June 2026; 1 recording(s)."));
        QCOMPARE(bench.earcon(), Earcon::next);
        QCOMPARE(bench.session->placeText(), QString("5 of 5"));
        bench.session->next();
        QCOMPARE(bench.said(), QString("This is the last photograph."));
        QCOMPARE(bench.earcon(), Earcon::list_end);
        bench.session->previous();
        QCOMPARE(bench.said(), garden_words);
        QCOMPARE(bench.earcon(), Earcon::previous);
        bench.session->first();
        QCOMPARE(bench.session->placeText(), QString("1 of 5"));
        bench.session->previous();
        QCOMPARE(bench.said(), QString("This is the first photograph."));
        bench.session->last();
        QCOMPARE(bench.session->placeText(), QString("5 of 5"));
    }

    void the_picture_follows() {
        AtGarden bench;
        QTRY_VERIFY(!bench.session->picture().isNull());
        QCOMPARE(bench.session->picture().size(), QSize(60, 40));
        const QImage garden = bench.session->picture();
        bench.session->next();
        QTRY_VERIFY(!bench.session->picture().isNull() && bench.session->picture() != garden);
    }

    void details_on_demand_from_the_summary_on_and_back() {
        AtGarden bench;
        QStringList told;
        for (int i = 0; i < 8; ++i) {
            bench.session->nextDetail();
            told << bench.said();
        }
        QCOMPARE(told.mid(0, 4), QStringList({"Anna", "Tom", "Recording 1 of 2: memo by Tom, 1 second(s).",
                                              "Recording 2 of 2: story by Ben, 1 second(s)."}));
        QCOMPARE(told[4], QString("Place: Vienna."));
        QCOMPARE(told[6], QString("File: garden.jpg."));
        QCOMPARE(told[7], told[6]);
        QCOMPARE(bench.earcon(), Earcon::list_end);
        for (int i = 0; i < 7; ++i)
            bench.session->previousDetail();
        QCOMPARE(bench.said(), garden_words);
        bench.earcon();
        bench.session->previousDetail();
        QCOMPARE(bench.earcon(), Earcon::list_end);
        QCOMPARE(bench.said(), garden_words);
    }

    void recordings_play_in_order_and_what_comes_next_is_told_between() {
        AtGarden bench;
        bench.session->play();
        QVERIFY(bench.session->playing());
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.near(bench.tone(0.2), 300.0));
        QVERIFY(bench.voice.recording_plays());
        QCOMPARE(bench.session->heard(), QString("memo by Tom, 0:00 of 0:01"));
        bench.voice.set_busy(true);
        bench.loudspeaker.play(0.4);
        QCOMPARE(bench.said(), QString("Next: story by Ben."));
        QVERIFY(!bench.voice.recording_plays());
        QVERIFY(bench.session->playing());
        bench.loudspeaker.play(2.0);
        QCOMPARE(bench.tone(1.5), 0.0); // nothing while it is told
        bench.voice.set_busy(false);
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
        QVERIFY(bench.session->heard().startsWith("story by Ben"));
        bench.loudspeaker.play(1.0);
        QVERIFY(!bench.session->playing());
        QVERIFY(bench.session->heard().isEmpty());
        QCOMPARE(bench.earcon(), Earcon::list_end);
    }

    void on_the_detail_of_a_recording_that_one_plays_alone() {
        AtGarden bench;
        for (int i = 0; i < 4; ++i)
            bench.session->nextDetail();
        bench.session->play();
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
        bench.loudspeaker.play(2.0);
        QVERIFY(!bench.session->playing());
        bench.session->previousDetail();
        bench.session->play();
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.near(bench.tone(0.2), 300.0));
        bench.session->play();
        QVERIFY(!bench.session->playing());
        bench.session->nextDetail(); // another one takes over
        bench.session->play();
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
    }

    void pressing_again_pauses_and_goes_on_from_there() {
        AtGarden bench;
        bench.session->play();
        bench.loudspeaker.play(0.2);
        bench.session->play();
        QVERIFY(!bench.session->playing());
        QVERIFY(bench.session->heardValue() > 0.2);
        const std::size_t runs = bench.loudspeaker.runs.size();
        bench.loudspeaker.play(1.0);
        QCOMPARE(bench.loudspeaker.runs.size(), runs);
        bench.session->play();
        bench.loudspeaker.play(0.1);
        QVERIFY(bench.session->playing());
        QVERIFY(bench.session->heardValue() > 0.4);
    }

    void pressing_while_it_is_told_what_comes_pauses_as_well() {
        AtGarden bench;
        bench.session->play();
        bench.voice.set_busy(true);
        bench.loudspeaker.play(0.9);
        QCOMPARE(bench.said(), QString("Next: story by Ben."));
        bench.session->play();
        QVERIFY(!bench.session->playing());
        bench.voice.set_busy(false);
        bench.loudspeaker.play(0.5);
        QVERIFY(!bench.session->playing());
        bench.session->play();
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
    }

    void escape_ends_what_sounds_and_then_is_for_others() {
        AtGarden bench;
        bench.session->play();
        bench.loudspeaker.play(0.2);
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.session->playing());
        QVERIFY(!bench.voice.recording_plays());
        QVERIFY(!bench.session->stop());
        bench.voice.set_busy(true); // something is being said
        const int stops = bench.voice.stops();
        QVERIFY(bench.session->stop());
        QVERIFY(bench.voice.stops() > stops);
    }

    void who_goes_on_or_asks_is_not_talked_over() {
        AtGarden bench;
        bench.session->play();
        bench.loudspeaker.play(0.2);
        bench.session->nextDetail();
        QVERIFY(!bench.session->playing());
        QVERIFY(!bench.voice.recording_plays());
        QCOMPARE(bench.said(), QString("Anna"));
        bench.session->play();
        bench.loudspeaker.play(0.1);
        bench.session->next();
        QVERIFY(!bench.session->playing());
        QVERIFY(bench.session->heard().isEmpty());
    }

    void taps_of_one_and_two_fingers() {
        AtGarden bench;
        bench.session->tap();
        QCOMPARE(bench.said(), garden_words);
        bench.session->play();
        bench.loudspeaker.play(0.2);
        bench.session->tap(); // the first of a double tap
        QVERIFY(bench.session->playing());
        bench.session->play();
        QVERIFY(!bench.session->playing());
        bench.session->play();
        bench.session->twoFingerTap();
        QVERIFY(!bench.session->playing());
        bench.session->twoFingerDoubleTap(); // which the first of its taps stopped
        QVERIFY(!bench.session->playing());
        bench.session->twoFingerTap();
        bench.session->twoFingerDoubleTap();
        QVERIFY(bench.session->playing());
    }

    void without_recordings_it_says_so() {
        AtGarden bench;
        bench.go_to(bench.five.sea);
        QVERIFY(!bench.session->hasRecordings());
        bench.session->play();
        QCOMPARE(bench.said(), QString("This photograph has no recordings yet."));
        QCOMPARE(bench.earcon(), Earcon::error);
    }

    void a_recording_that_is_gone_costs_a_sentence_and_the_next_one_plays() {
        AtGarden bench;
        fs::path tags = bench.five.garden;
        tags += ".tags";
        for (const auto& file : fs::directory_iterator(tags))
            if (file.path().string().ends_with("-memo.flac"))
                fs::resize_file(file.path(), 10);
        bench.session->play();
        QVERIFY(!bench.said().isEmpty());
        QCOMPARE(bench.session->notice(), bench.said());
        bench.loudspeaker.play(1.1);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
        bench.session->next();
        QVERIFY(bench.session->notice().isEmpty());
    }

    void the_speed_is_kept_and_heard() {
        AtGarden bench;
        bench.session->faster();
        QCOMPARE(bench.said(), QString("Speed 1.25"));
        QCOMPARE(bench.drawn.preferences.choices().playback_speed, 1.25);
        QCOMPARE(bench.player.speed(), 1.25);
        for (int i = 0; i < 9; ++i)
            bench.session->slower();
        QCOMPARE(bench.player.speed(), 0.5);
        QCOMPARE(bench.session->speedText(), QString("Speed 0.5"));
        bench.voice.clear();
        bench.session->play();
        bench.loudspeaker.play(0.2);
        bench.session->faster();
        QVERIFY(bench.session->playing());
        QVERIFY(bench.voice.said().isEmpty()); // it is heard
    }

    void people_and_the_photographs_of_one() {
        AtGarden bench;
        bench.session->openTopic(Topic::People);
        QCOMPARE(bench.session->view(), View::Names);
        QCOMPARE(bench.row_texts(), QStringList({"Anna", "Ben", "Tom"}));
        QCOMPARE(bench.said(), QString("People: 3 person(s). Choose one with the arrow keys and Return."));
        bench.session->reach(0);
        QCOMPARE(bench.said(), QString("Anna, 2 photograph(s)"));
        bench.session->next(); // arrows are for the rows here
        QCOMPARE(bench.session->view(), View::Names);
        bench.session->choose(0);
        QCOMPARE(bench.session->view(), View::Photos);
        QCOMPARE(bench.said(), "Anna, 1 of 2: " + garden_words);
        bench.session->next();
        QCOMPARE(bench.session->placeText(), QString("2 of 2"));
        bench.session->next();
        QCOMPARE(bench.said(), QString("This is the last photograph."));
        bench.session->back();
        QCOMPARE(bench.session->view(), View::Names);
        QCOMPARE(bench.session->chosenRow(), 0);
        bench.session->back();
        QCOMPARE(bench.session->title(), QString("All photographs"));
        QCOMPARE(bench.session->photo(), QString::fromStdString(bench.five.garden.string()));
        bench.earcon();
        bench.session->back();
        QCOMPARE(bench.earcon(), Earcon::list_end);
    }

    void a_row_that_is_none_is_not_chosen() {
        AtGarden bench;
        bench.session->openTopic(Topic::People);
        bench.session->choose(-1);
        QCOMPARE(bench.said(), QString("Go to a row first."));
        QCOMPARE(bench.earcon(), Earcon::error);
        bench.session->choose(99);
        QCOMPARE(bench.session->view(), View::Names);
    }

    void a_list_that_stays_as_it_is_is_not_made_anew() {
        AtGarden bench;
        bench.session->openTopic(Topic::People);
        QSignalSpy rows(bench.session.get(), &BrowseSession::rowsChanged);
        bench.drawn.photo("another.jpg", "2026-07-01T10:15:00");
        QTRY_COMPARE(bench.session->count(), 6);
        QCOMPARE(rows.count(), 0);
        bench.drawn.name(bench.five.sea, "Eva", 0.5);
        bench.drawn.album->touched(bench.five.sea);
        QTRY_COMPARE(bench.row_texts(), QStringList({"Anna", "Ben", "Eva", "Tom"}));
    }

    void years_from_the_newest_and_places() {
        AtGarden bench;
        bench.session->openTopic(Topic::Years);
        QCOMPARE(bench.row_texts(), QStringList({"2026", "2025", "2024"}));
        QCOMPARE(bench.session->rows().at(1).toMap()["detail"].toString(), QString("2 photograph(s)"));
        bench.session->choose(1);
        QCOMPARE(bench.said(), QString("2025, 1 of 2: July 2025, Trieste; no recordings yet."));
        bench.session->openTopic(Topic::Places);
        QCOMPARE(bench.row_texts(), QStringList({"Trieste", "Vienna"}));
        bench.session->choose(1);
        QCOMPARE(bench.session->placeText(), QString("1 of 2"));
        bench.session->openTopic(Topic::Keywords);
        QCOMPARE(bench.said(), QString("Keywords: there are none yet."));
        bench.session->allPhotos();
        QCOMPARE(bench.session->title(), QString("All photographs"));
        QVERIFY(bench.session->rows().isEmpty());
    }

    void a_long_list_comes_in_parts() {
        BrowseBench bench;
        const fs::path photo = bench.drawn.photo("many.jpg", "2026-05-01T10:15:00");
        SidecarChanges changes;
        changes.keywords.emplace();
        for (int i = 0; i < 130; ++i)
            changes.keywords->push_back("word " + std::to_string(1000 + i));
        QCOMPARE(write_sidecar(photo, changes), std::string());
        bench.start();
        bench.session->openTopic(Topic::Keywords);
        QCOMPARE(bench.session->rows().size(), 101);
        QCOMPARE(bench.session->found(), QString("The first 100"));
        bench.session->choose(100);
        QCOMPARE(bench.session->rows().size(), 130);
        bench.session->choose(129);
        QCOMPARE(bench.session->title(), QString("word 1129"));
    }

    void search_suggests_finds_and_counts() {
        AtGarden bench;
        bench.session->openSearch();
        QVERIFY(bench.said().startsWith("Search."));
        bench.session->type("an");
        QCOMPARE(bench.row_texts().mid(0, 1), QStringList("Anna"));
        QCOMPARE(bench.session->rows().at(0).toMap()["detail"].toString(),
                 QString("person, 2 photograph(s)"));
        QCOMPARE(bench.session->rows().size(), 3);
        bench.session->tellFound();
        QCOMPARE(bench.said(), QString("2 photograph(s), 1 suggestion(s)."));
        bench.session->type("tom gard");
        QCOMPARE(bench.row_texts(), QStringList(garden_words));
        bench.session->choose(0);
        QCOMPARE(bench.said(), "Found: tom gard, 1 of 1: " + garden_words);
        bench.session->back();
        QCOMPARE(bench.session->view(), View::Search);
        QCOMPARE(bench.session->typed(), QString("tom gard"));
        bench.session->type("nobody of that name");
        bench.session->tellFound();
        QCOMPARE(bench.said(), QString("0 photograph(s)."));
        bench.session->type("an");
        bench.session->choose(0);
        QCOMPARE(bench.said(), "Anna, 1 of 2: " + garden_words);
    }

    void a_name_is_spelt_without_a_keyboard() {
        AtGarden bench;
        bench.session->openSearch();
        const auto letter = [&](const char* one) { return static_cast<int>(bench.session->letters().indexOf(one)); };
        QVERIFY(letter("T") >= 0 && letter("V") >= 0);
        QCOMPARE(letter("Q"), -1);
        bench.session->reachLetter(letter("T"));
        QCOMPARE(bench.said(), QString("T"));
        bench.session->addLetter(letter("T"));
        QCOMPARE(bench.session->typed(), QString("T"));
        bench.session->addLetter(letter("O"));
        QCOMPARE(bench.said(), QString("To: 2 photograph(s), 1 suggestion(s).")); // Tom, and tower.jpg
        QCOMPARE(bench.session->letters(), QStringList({"M", "W"}));
        bench.session->addLetter(letter("M"));
        QCOMPARE(bench.session->letters(), QStringList());
        bench.session->addLetter(0); // there is none
        QCOMPARE(bench.session->typed(), QString("Tom"));
        bench.session->takeLetterBack();
        QCOMPARE(bench.session->typed(), QString("To"));
        bench.session->takeLetterBack();
        bench.session->takeLetterBack();
        QCOMPARE(bench.said(), QString("Nothing is typed any more."));
        bench.session->takeLetterBack();
        QCOMPARE(bench.said(), QString("There is no letter to take away."));
    }

    void what_was_found_is_gone_through() {
        AtGarden bench;
        bench.session->openSearch();
        bench.session->type("vienna");
        QCOMPARE(bench.session->rows().size(), 3); // the place, and two photographs
        bench.session->choose(2);
        QCOMPARE(bench.session->placeText(), QString("2 of 2"));
        bench.session->previous();
        QCOMPARE(bench.session->placeText(), QString("1 of 2"));
    }

    void surprise_is_another_photograph_among_all() {
        AtGarden bench;
        bench.session->openTopic(Topic::People);
        bench.session->choose(0);
        for (int i = 0; i < 5; ++i) {
            const QString before = bench.session->photo();
            bench.session->surprise();
            QVERIFY(bench.session->photo() != before);
            QCOMPARE(bench.said(), bench.session->summary());
            QCOMPARE(bench.session->count(), 5);
            QCOMPARE(bench.session->title(), QString("All photographs"));
        }
    }

    void where_am_i() {
        AtGarden bench;
        bench.session->whereAmI();
        QCOMPARE(bench.said(), "All photographs, 4 of 5: " + garden_words);
        bench.session->play();
        bench.loudspeaker.play(0.2);
        bench.session->whereAmI();
        QVERIFY2(bench.said().endsWith("Paused: memo by Tom, at 0 second(s)."), qPrintable(bench.said()));
        bench.session->openTopic(Topic::People);
        bench.session->whereAmI();
        QVERIFY(bench.said().startsWith("People: 3"));
    }

    void a_start_returns_to_where_one_was() {
        AtGarden bench;
        bench.session->next();
        QCOMPARE(bench.drawn.preferences.choices().last_photo,
                 QString::fromStdString(bench.five.walk.string()));
        bench.session.reset();
        bench.start();
        QCOMPARE(bench.session->photo(), QString::fromStdString(bench.five.walk.string()));
        QVERIFY(bench.said().startsWith("Your photographs, 5 of 5: Anna and Ben"));
    }

    void a_start_returns_there_even_where_the_index_is_made_anew() {
        AtGarden bench;
        bench.session->next();
        bench.session.reset();
        bench.drawn.album.reset();
        fs::remove_all(bench.drawn.folder / "cache");
        bench.drawn.album =
            std::make_unique<OpenAlbum>(bench.drawn.folder / "cache", bench.drawn.preferences);
        bench.session = std::make_unique<BrowseSession>(*bench.drawn.album, bench.narrator, bench.earcons,
                                                        bench.player, bench.drawn.preferences);
        QCOMPARE(bench.session->state(), State::Looking);
        bench.session->enter();
        QCOMPARE(bench.said(), QString("Looking for photographs in your folders."));
        QVERIFY(bench.drawn.scanned());
        QTRY_COMPARE(bench.session->photo(), QString::fromStdString(bench.five.walk.string()));
        QCOMPARE(bench.said(), QString("Anna and Ben, June 2026; 1 recording(s)."));
        QCOMPARE(bench.drawn.preferences.choices().last_photo, bench.session->photo());
    }

    void a_start_waits_for_where_one_was_until_the_scan_has_ended_unless_a_person_goes_on() {
        for (const bool goes_on : {false, true}) {
            AtGarden bench;
            bench.session.reset();
            bench.drawn.album.reset();
            const fs::path fresh = bench.drawn.photo("fresh.jpg", "2026-09-09T09:09:09");
            bench.drawn.preferences.change(
                [&](Choices& choices) { choices.last_photo = QString::fromStdString(fresh.string()); });
            SqlConnection index = SqlConnection::to_file(bench.drawn.folder / "cache" / "album.sqlite");
            std::optional<SqlTransaction> scan_waits(index);
            bench.drawn.album =
                std::make_unique<OpenAlbum>(bench.drawn.folder / "cache", bench.drawn.preferences);
            bench.session =
                std::make_unique<BrowseSession>(*bench.drawn.album, bench.narrator, bench.earcons,
                                                bench.player, bench.drawn.preferences);
            QCOMPARE(bench.session->placeText(), QString("1 of 5")); // what the index knows meanwhile
            if (goes_on)
                bench.session->next();
            scan_waits.reset();
            QVERIFY(bench.drawn.scanned());
            QTRY_COMPARE(bench.session->count(), 6);
            QCOMPARE(bench.session->placeText(), QString(goes_on ? "2 of 6" : "6 of 6"));
        }
    }

    void where_one_was_is_gone_one_begins_at_the_first() {
        AtGarden bench;
        bench.session.reset();
        bench.drawn.preferences.change([](Choices& choices) { choices.last_photo = "/nowhere/x.jpg"; });
        bench.start();
        QCOMPARE(bench.session->placeText(), QString("1 of 5"));
        bench.session->next();
        QCOMPARE(bench.drawn.preferences.choices().last_photo, bench.session->photo());
    }

    void a_photograph_that_goes_is_told_and_one_is_at_the_nearest() {
        AtGarden bench;
        bench.session->play();
        bench.loudspeaker.play(0.1);
        fs::remove(bench.five.garden);
        QTRY_COMPARE(bench.session->photo(), QString::fromStdString(bench.five.walk.string()));
        QCOMPARE(bench.said(),
                 QString("garden.jpg is gone from this list. Now: Anna and Ben, June 2026; 1 recording(s)."));
        QVERIFY(!bench.session->playing());
        QCOMPARE(bench.session->placeText(), QString("4 of 4"));
    }

    void a_photograph_that_is_renamed_stays_without_a_word() {
        AtGarden bench;
        const fs::path there = bench.drawn.root() / "Anna and Tom.jpg";
        fs::rename(bench.five.garden, there);
        QTRY_COMPARE(bench.session->photo(), QString::fromStdString(there.string()));
        QTRY_COMPARE(bench.session->summary(), garden_words); // what belongs to it has followed
        QVERIFY(bench.voice.said().filter("gone").isEmpty());
    }

    void what_other_pages_change_is_shown_and_playing_goes_on() {
        AtGarden bench;
        bench.session->nextDetail();
        bench.session->play();
        bench.loudspeaker.play(0.1);
        bench.drawn.name(bench.five.garden, "Eva", 0.5);
        bench.drawn.album->touched(bench.five.garden);
        QTRY_VERIFY(bench.session->summary().startsWith("Anna, Eva and Tom") ||
                    bench.session->summary().startsWith("Anna, Tom and Eva"));
        QVERIFY(bench.session->playing());
        QCOMPARE(bench.session->detail(), QString("Anna"));
    }

    void a_level_that_is_empty_is_left() {
        AtGarden bench;
        bench.session->openTopic(Topic::People);
        bench.session->choose(2);
        QCOMPARE(bench.session->title(), QString("Tom"));
        fs::remove(bench.five.garden);
        QTRY_COMPARE(bench.session->view(), View::Names);
        QCOMPARE(bench.row_texts(), QStringList({"Anna", "Ben"}));
    }

    void without_folders_it_says_what_to_do() {
        BrowseBench bench;
        bench.drawn.preferences.change([](Choices& choices) { choices.folders.clear(); });
        bench.start();
        QCOMPARE(bench.session->state(), State::NoFolders);
        QVERIFY(bench.said().contains("settings page"));
        bench.session->next();
        QCOMPARE(bench.earcon(), Earcon::error);
        bench.session->openSearch();
        QCOMPARE(bench.session->view(), View::Photos);
        const QString folder = QString::fromStdString(bench.drawn.root().string());
        bench.drawn.photo("first.jpg", "2026-05-01T10:15:00");
        bench.drawn.preferences.change([&](Choices& choices) { choices.folders << folder; });
        QTRY_COMPARE(bench.session->state(), State::Ready);
        QCOMPARE(bench.said(), QString("May 2026; no recordings yet."));
    }

    void an_empty_folder_says_so_and_the_first_photograph_is_shown_when_it_comes() {
        BrowseBench bench;
        bench.start();
        QCOMPARE(bench.session->state(), State::Empty);
        QVERIFY(bench.said().startsWith("There is no photograph in your folders yet."));
        bench.drawn.photo("first.jpg", "2026-05-01T10:15:00");
        QTRY_COMPARE(bench.session->state(), State::Ready);
        QCOMPARE(bench.said(), QString("May 2026; no recordings yet."));
    }

    void what_happens_while_another_page_is_shown_is_not_told() {
        AtGarden bench;
        bench.session->play();
        bench.loudspeaker.play(0.1);
        bench.session->leave();
        QVERIFY(!bench.session->playing());
        bench.voice.clear();
        fs::remove(bench.five.garden);
        QTRY_COMPARE(bench.session->photo(), QString::fromStdString(bench.five.walk.string()));
        QVERIFY(bench.voice.said().isEmpty());
        bench.session->enter();
        QVERIFY(bench.said().startsWith("Your photographs, 4 of 4: Anna and Ben"));
    }

    void other_pages_are_asked_for_by_photograph() {
        AtGarden bench;
        QSignalSpy explore(bench.session.get(), &BrowseSession::exploreAsked),
            care(bench.session.get(), &BrowseSession::careAsked);
        bench.session->askExplore();
        bench.session->askCare();
        QCOMPARE(explore.at(0).at(0).toString(), QString::fromStdString(bench.five.garden.string()));
        QCOMPARE(care.at(0).at(0).toString(), QString::fromStdString(bench.five.garden.string()));
    }

    void a_screen_reader_says_rows_itself_and_gets_its_time_between_recordings() {
        AtGarden bench;
        bench.narrator.set_by(Narrator::By::screen_reader);
        bench.session->openTopic(Topic::People);
        const QString told = bench.announcer.sentence();
        bench.session->reach(1);
        QCOMPARE(bench.announcer.sentence(), told);
        bench.session->allPhotos();
        bench.session->play();
        bench.loudspeaker.play(0.6);
        QCOMPARE(bench.announcer.sentence(), QString("Next: story by Ben."));
        QVERIFY(bench.session->playing());
        QTRY_VERIFY(bench.player.state() == Player::State::playing);
    }

    void another_language_is_spoken_when_the_page_is_entered_again() {
        AtGarden bench;
        bench.session->leave();
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        bench.session->enter();
        QCOMPARE(bench.session->summary(), QString("Anna und Tom, Mai 2026, Vienna; 2 recording(s)."));
    }

    void the_keys_are_told() {
        AtGarden bench;
        bench.session->tellKeys();
        for (const char* word : {"Left and right", "Return", "Escape", "Backspace", "W: where am I"})
            QVERIFY2(bench.said().contains(word), word);
    }
};

QTEST_MAIN(BrowseSessionTest)
#include "browse_session_test.moc"
