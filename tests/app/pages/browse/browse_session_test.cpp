// SPDX-License-Identifier: Apache-2.0
// What concerns several parts of the page at once. Each part has a test of its own.
#include "app/album/index/album_index.hpp"
#include "app/album/index/sql_connection.hpp"
#include "browse_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

#include <filesystem>
#include <optional>

namespace browse_session_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;
using Topic = BrowseLists::Topic;
using State = BrowseAlbum::State;
using View = BrowseTrail::View;

namespace {

/// Five photographs, and one is at the garden.
struct AtGarden : BrowseBench {
    DrawnAlbum::Five five = drawn.five();
    AtGarden() {
        start();
        go_to(five.garden);
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
        QCOMPARE(bench.session->album()->state(), State::Ready);
        QCOMPARE(bench.voice.said(), QStringList("Your photographs, 1 of 5: February 2024, Vienna; no "
                                                 "recordings yet. Swipe or use the arrow keys to move on."));
    }

    void a_screen_reader_reads_the_photograph_itself_and_is_not_told_it_too() {
        BrowseBench bench;
        bench.drawn.five();
        bench.narrator.set_by(Narrator::By::screen_reader);
        bench.start();
        QCOMPARE(bench.narrator.sentence(), QString("Your photographs."));
        bench.session->trail()->next(); // the focus stays, so nothing is read by itself
        QCOMPARE(bench.narrator.sentence(), bench.session->details()->summary());
    }

    void escape_ends_what_sounds_and_then_is_for_others() {
        AtGarden bench;
        bench.session->playback()->play();
        bench.loudspeaker.play(0.2);
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.session->playback()->playing());
        QVERIFY(!bench.voice.recording_plays());
        QVERIFY(!bench.session->stop());
        bench.voice.set_busy(true); // something is being said
        const int stops = bench.voice.stops();
        QVERIFY(bench.session->stop());
        QVERIFY(bench.voice.stops() > stops);
    }

    void who_goes_on_or_asks_is_not_talked_over() {
        AtGarden bench;
        bench.session->playback()->play();
        bench.loudspeaker.play(0.2);
        bench.session->details()->next();
        QVERIFY(!bench.session->playback()->playing());
        QVERIFY(!bench.voice.recording_plays());
        QCOMPARE(bench.said(), QString("Anna"));
        bench.session->playback()->play();
        bench.loudspeaker.play(0.1);
        bench.session->trail()->next();
        QVERIFY(!bench.session->playback()->playing());
        QVERIFY(bench.session->playback()->heard().isEmpty());
    }

    void taps_of_one_and_two_fingers() {
        AtGarden bench;
        bench.session->details()->tap();
        QCOMPARE(bench.said(), garden_words);
        bench.session->playback()->play();
        bench.loudspeaker.play(0.2);
        bench.session->details()->tap(); // the first of a double tap
        QVERIFY(bench.session->playback()->playing());
        bench.session->playback()->play();
        QVERIFY(!bench.session->playback()->playing());
        bench.session->playback()->play();
        bench.session->twoFingerTap();
        QVERIFY(!bench.session->playback()->playing());
        bench.session->twoFingerDoubleTap(); // which the first of its taps stopped
        QVERIFY(!bench.session->playback()->playing());
        bench.session->twoFingerTap();
        bench.session->twoFingerDoubleTap();
        QVERIFY(bench.session->playback()->playing());
    }

    void where_am_i() {
        AtGarden bench;
        bench.session->whereAmI();
        QCOMPARE(bench.said(), "All photographs, 4 of 5: " + garden_words);
        bench.session->playback()->play();
        bench.loudspeaker.play(0.2);
        bench.session->whereAmI();
        QVERIFY2(bench.said().endsWith("Paused: memo by Tom, at 0 second(s)."), qPrintable(bench.said()));
        bench.session->lists()->openTopic(Topic::People);
        bench.session->whereAmI();
        QVERIFY(bench.said().startsWith("People: 3"));
    }

    void a_start_returns_to_where_one_was() {
        AtGarden bench;
        bench.session->trail()->next();
        QCOMPARE(bench.drawn.preferences.choices().last_photo,
                 QString::fromStdString(bench.five.walk.string()));
        bench.session.reset();
        bench.start();
        QCOMPARE(bench.session->trail()->photo(), QString::fromStdString(bench.five.walk.string()));
        QVERIFY(bench.said().startsWith("Your photographs, 5 of 5: Anna and Ben"));
    }

    void a_start_returns_there_even_where_the_index_is_made_anew() {
        AtGarden bench;
        bench.session->trail()->next();
        bench.session.reset();
        bench.drawn.album.reset();
        const fs::path cache = bench.drawn.folder / "cache";
        fs::remove_all(cache);
        QVERIFY(AlbumIndex::open(cache).ok());
        SqlConnection index = SqlConnection::to_file(cache / "album.sqlite");
        std::optional<SqlTransaction> scan_waits(index);
        bench.drawn.album = std::make_unique<OpenAlbum>(cache, bench.drawn.preferences);
        bench.session = std::make_unique<BrowseSession>(*bench.drawn.album, bench.narrator, bench.earcons,
                                                        bench.player, bench.drawn.preferences);
        QCOMPARE(bench.session->album()->state(), State::Looking);
        bench.session->enter();
        QCOMPARE(bench.said(), QString("Looking for photographs in your folders."));
        scan_waits.reset();
        QVERIFY(bench.drawn.scanned());
        QTRY_COMPARE(bench.session->trail()->photo(), QString::fromStdString(bench.five.walk.string()));
        QCOMPARE(bench.said(), QString("Anna and Ben, June 2026; 1 recording(s)."));
        QCOMPARE(bench.drawn.preferences.choices().last_photo, bench.session->trail()->photo());
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
            QCOMPARE(bench.session->trail()->placeText(),
                     QString("1 of 5")); // what the index knows meanwhile
            if (goes_on)
                bench.session->trail()->next();
            scan_waits.reset();
            QVERIFY(bench.drawn.scanned());
            QTRY_COMPARE(bench.session->trail()->count(), 6);
            QCOMPARE(bench.session->trail()->placeText(), QString(goes_on ? "2 of 6" : "6 of 6"));
        }
    }

    void a_photograph_that_goes_is_told_and_one_is_at_the_nearest() {
        AtGarden bench;
        bench.session->playback()->play();
        bench.loudspeaker.play(0.1);
        fs::remove(bench.five.garden);
        QTRY_COMPARE(bench.session->trail()->photo(), QString::fromStdString(bench.five.walk.string()));
        QCOMPARE(
            bench.said(),
            QString("garden.jpg is no longer in this list. Now: Anna and Ben, June 2026; 1 recording(s)."));
        QVERIFY(!bench.session->playback()->playing());
        QCOMPARE(bench.session->trail()->placeText(), QString("4 of 4"));
    }

    void what_other_pages_change_is_shown_and_playing_goes_on() {
        AtGarden bench;
        bench.session->details()->next();
        bench.session->playback()->play();
        bench.loudspeaker.play(0.1);
        bench.drawn.name(bench.five.garden, "Eva", 0.5);
        bench.drawn.album->touched(bench.five.garden);
        QTRY_VERIFY(bench.session->details()->summary().startsWith("Anna, Eva and Tom") ||
                    bench.session->details()->summary().startsWith("Anna, Tom and Eva"));
        QVERIFY(bench.session->playback()->playing());
        QCOMPARE(bench.session->details()->detail(), QString("Anna"));
    }

    void what_happens_while_another_page_is_shown_is_not_told() {
        AtGarden bench;
        bench.session->playback()->play();
        bench.loudspeaker.play(0.1);
        bench.session->leave();
        QVERIFY(!bench.session->playback()->playing());
        bench.voice.clear();
        fs::remove(bench.five.garden);
        QTRY_COMPARE(bench.session->trail()->photo(), QString::fromStdString(bench.five.walk.string()));
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
        bench.session->lists()->openTopic(Topic::People);
        const QString told = bench.announcer.sentence();
        bench.session->lists()->reach(1);
        QCOMPARE(bench.announcer.sentence(), told);
        bench.session->lists()->allPhotos();
        bench.session->playback()->play();
        bench.loudspeaker.play(0.6);
        QCOMPARE(bench.announcer.sentence(), QString("Next: story by Ben."));
        QVERIFY(bench.session->playback()->playing());
        QTRY_VERIFY(bench.player.state() == Player::State::playing);
    }

    void another_language_is_spoken_when_the_page_is_entered_again() {
        AtGarden bench;
        bench.session->leave();
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        bench.session->enter();
        QCOMPARE(bench.session->details()->summary(),
                 QString("Anna und Tom, Mai 2026, Vienna; 2 recording(s)."));
    }

    void the_keys_are_told() {
        AtGarden bench;
        bench.session->tellKeys();
        for (const char* word : {"Left and right", "Enter", "Escape", "Backspace", "W: where am I"})
            QVERIFY2(bench.said().contains(word), word);
    }
};

} // namespace browse_session_test

TP_TEST(browse_session_test, BrowseSessionTest, window)
#include "browse_session_test.moc"
