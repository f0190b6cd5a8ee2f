// SPDX-License-Identifier: Apache-2.0
#include "browse_parts.hpp"
#include "test_program.hpp"

#include <QString>
#include <QTest>

namespace browse_album_test {

using namespace tp;
using namespace tp::testing;
using State = BrowseAlbum::State;
using View = BrowseTrail::View;

class BrowseAlbumTest : public QObject {
    Q_OBJECT
private slots:
    void without_folders_it_says_what_to_do() {
        BrowseParts bench;
        bench.drawn.preferences.change([](Choices& choices) { choices.folders.clear(); });
        bench.start();
        QCOMPARE(bench.album().state(), State::NoFolders);
        QVERIFY(bench.album().emptyText().contains("settings page"));
        bench.trail().next();
        QCOMPARE(bench.earcon(), Earcon::error);
        bench.lists().openSearch();
        QCOMPARE(bench.trail().view(), View::Photos);
        const QString folder = QString::fromStdString(bench.drawn.root().string());
        bench.drawn.photo("first.jpg", "2026-05-01T10:15:00");
        bench.drawn.preferences.change([&](Choices& choices) { choices.folders << folder; });
        QTRY_COMPARE(bench.album().state(), State::Ready);
        QCOMPARE(bench.said(), QString("May 2026; no recordings yet."));
    }

    void an_empty_folder_says_so_and_the_first_photograph_is_shown_when_it_comes() {
        BrowseParts bench;
        bench.start();
        QCOMPARE(bench.album().state(), State::Empty);
        QVERIFY(bench.album().emptyText().startsWith("There are no photographs in your folders yet."));
        bench.drawn.photo("first.jpg", "2026-05-01T10:15:00");
        QTRY_COMPARE(bench.album().state(), State::Ready);
        QCOMPARE(bench.said(), QString("May 2026; no recordings yet."));
    }

    void the_state_is_what_there_is() {
        BrowseParts bench;
        bench.start();
        QVERIFY(!bench.album().look(false));
        QCOMPARE(bench.album().state(), State::Empty);
        QVERIFY(bench.album().look(true));
        QCOMPARE(bench.album().state(), State::Ready);
        QVERIFY(bench.album().ready() && bench.album().emptyText().isEmpty());
        QVERIFY(!bench.album().look(true));
        bench.drawn.preferences.change([](Choices& choices) { choices.folders.clear(); });
        QTRY_VERIFY((bench.album().look(false), bench.album().state() == State::NoFolders));
        QTRY_VERIFY(!bench.album().scanning());
        QCOMPARE(bench.album().scanText(), QString());
    }
};

} // namespace browse_album_test

TP_TEST(browse_album_test, BrowseAlbumTest, window)
#include "browse_album_test.moc"
