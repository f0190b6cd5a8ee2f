// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_watcher.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

namespace album_watcher_test {

using namespace tp;
using namespace tp::testing;
using namespace std::chrono_literals;

class AlbumWatcherTest : public QObject {
    Q_OBJECT

    using Folders = std::vector<fs::path>;

    /// A watcher that looks at unwatched folders only when told to.
    struct Watched {
        explicit Watched(std::chrono::milliseconds settle) : watcher({settle, 1h}) {
            QObject::connect(&watcher, &AlbumWatcher::changed, &watcher,
                             [this](const Folders& folders) { changed.push_back(folders); });
            QObject::connect(&watcher, &AlbumWatcher::limited, &watcher,
                             [this](const std::string& sentence) { sentences.push_back(sentence); });
        }
        std::vector<Folders> changed;
        std::vector<std::string> sentences;
        AlbumWatcher watcher;
    };

private slots:
    void changes_are_told_once_they_settle() {
        TestAlbum album;
        const fs::path a = album.add("a/1.jpg", "1");
        album.add("b/2.jpg", "2");
        Watched watched(300ms);
        watched.watcher.set_folders({album.root(), album.root() / "a", album.root() / "b"});
        for (int i = 0; i < 20; ++i)
            album.add("a/" + std::to_string(10 + i) + ".jpg", std::to_string(i));
        TestAlbum::set_people(album.root() / "b" / "2.jpg", {"Ben"});
        QTRY_COMPARE(watched.changed.size(), std::size_t(1));
        QCOMPARE(watched.changed[0], (Folders{album.root() / "a", album.root() / "b"}));
        QVERIFY(watched.sentences.empty());
    }

    void what_the_watcher_tells_is_enough_for_the_index() {
        TestAlbum album;
        const fs::path photo = album.add("a/1.jpg", "1");
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        Watched watched(0ms);
        watched.watcher.set_folders(index->folders().value());
        QObject::connect(&watched.watcher, &AlbumWatcher::changed, &watched.watcher,
                         [&](const Folders& folders) {
                             QVERIFY(rescan_folders(*index, folders, album.tools).ok());
                             watched.watcher.set_folders(index->folders().value());
                         });
        const auto knows_all = [&] { return index->dump().value() == album.fresh_dump(); };
        album.add("new/deep/3.jpg", "3", {"Carla"});
        QTRY_VERIFY(knows_all());
        album.add("new/deep/4.jpg", "4");
        QTRY_VERIFY(knows_all());
        fs::create_directory(photo.string() + ".tags");
        QTRY_VERIFY(knows_all());
        write_file(photo.string() + ".tags/1.flac", "the sea");
        QTRY_VERIFY(knows_all());
        fs::rename(album.root() / "new", album.root() / "newer");
        QTRY_VERIFY(knows_all());
        fs::remove_all(album.root() / "a");
        QTRY_VERIFY(knows_all());
    }

    void what_the_system_does_not_watch_is_looked_at() {
        TestAlbum album;
        album.add("a/1.jpg", "1");
        album.add("b/2.jpg", "2");
        QVERIFY(album.settles());
        Watched watched(0ms);
        watched.watcher.set_most_watched(1);
        const Folders folders{album.root(), album.root() / "a", album.root() / "b", album.root() / "gone"};
        watched.watcher.set_folders(folders);
        watched.watcher.set_folders(folders);
        QCOMPARE(watched.watcher.polled_count(), std::size_t(3));
        QCOMPARE(watched.sentences.size(), std::size_t(1)); // once
        album.add("b/3.jpg", "3");
        watched.watcher.poll();
        QTRY_COMPARE(watched.changed.size(), std::size_t(1));
        QCOMPARE(watched.changed[0], (Folders{album.root() / "b"}));
        fs::remove_all(album.root() / "a");
        QTRY_VERIFY(watched.changed.size() >= 2); // the root is watched
        watched.changed.clear();
        watched.watcher.poll();
        QTRY_VERIFY(!watched.changed.empty());
        watched.watcher.set_folders({album.root()});
        QCOMPARE(watched.watcher.polled_count(), std::size_t(0));
    }

    void names_that_are_no_text_are_looked_at() {
        TestAlbum album;
        const fs::path folder = album.add("f\xF6lder/1.jpg", "1").parent_path();
        QVERIFY(album.settles());
        Watched watched(0ms);
        watched.watcher.set_folders({folder});
        QCOMPARE(watched.watcher.polled_count(), std::size_t(1));
        album.add("f\xF6lder/2.jpg", "2");
        watched.watcher.poll();
        QTRY_COMPARE(watched.changed.size(), std::size_t(1));
        QCOMPARE(watched.changed[0], (Folders{folder}));
    }
};

} // namespace album_watcher_test

TP_TEST(album_watcher_test, AlbumWatcherTest, event_loop)
#include "album_watcher_test.moc"
