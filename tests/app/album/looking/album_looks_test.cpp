// SPDX-License-Identifier: Apache-2.0
#include "album_parts.hpp"
#include "app/album/looking/album_looks.hpp"
#include "app/album/metadata/write_sidecar.hpp"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

using namespace tp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// Looks that a test watches: what was looked at, in order; each waits where `gate` is shut.
struct Looks {
    std::mutex mutex;
    std::vector<std::string> names;
    QSemaphore gate;
    std::function<void(const fs::path&)> during = [](const fs::path&) {};
    std::atomic<bool> open = true, reads = true;
    std::atomic<int> stopped = 0, nets = 0;

    Look make() {
        ++nets;
        return [this](const fs::path& photo, Marks marks, const std::stop_token& stop) {
            {
                const std::scoped_lock lock(mutex);
                names.push_back(photo.filename().string());
            }
            during(photo);
            while (!open && !stop.stop_requested() && !gate.tryAcquire(1, 10)) {
            }
            stopped += stop.stop_requested() ? 1 : 0;
            Looked looked;
            SeenPhoto& seen = looked.seen;
            if (!reads)
                return looked;
            seen.width = seen.height = 100;
            seen.faces.resize(3);
            for (SeenFace& face : seen.faces) {
                face.part = {Vec2(0.1), Vec2(0.3)};
                face.mien = Mien::smiling;
            }
            if (marks == Marks::yes)
                looked.marks.assign(seen.faces.size(), {NoGuess::none, std::string(128, '1')});
            return looked;
        };
    }
    std::vector<std::string> in_order() {
        const std::scoped_lock lock(mutex);
        return names;
    }
};

struct Program {
    AlbumFolder folder;
    Preferences preferences;
    Looks looked;
    std::unique_ptr<OpenAlbum> album;
    std::unique_ptr<AlbumLooks> looks;

    fs::path photo(const std::string& name, int number) {
        a_photo(folder, "album/" + name, number);
        const fs::path path = fs::canonical(folder.path()) / "album" / name;
        fs::last_write_time(path,
                            fs::file_time_type::clock::now() - 24h + number * 1h); // the larger, the newer
        return path;
    }
    void start(bool on = true) {
        preferences.change([&](Choices& choices) {
            choices.folders = {QString::fromStdString((fs::canonical(folder.path()) / "album").string())};
        });
        album = std::make_unique<OpenAlbum>(folder / "cache", preferences, AlbumWatcher::Times{0ms, 1h});
        looks = std::make_unique<AlbumLooks>(*album, [this] { return looked.make(); });
        looks->set_on(on);
    }
    bool scanned() {
        return QTest::qWaitFor(
            [&] { return !album->scanning() && !album->queries().page(AllByTime{}, {}, 1)->empty(); },
            30'000);
    }
    bool rests_after(std::size_t count) {
        return QTest::qWaitFor(
            [&] { return looked.in_order().size() >= count && !looks->looking() && !album->scanning(); },
            30'000);
    }
    std::size_t found(const char* typed) { return album->queries().search(typed, 10)->size(); }
    bool finds(const char* typed, std::size_t count) {
        return QTest::qWaitFor([&] { return found(typed) == count; }, 30'000);
    }
};

using Names = std::vector<std::string>;

} // namespace

class AlbumLooksTest : public QObject {
    Q_OBJECT
private slots:
    void the_album_is_looked_through_from_the_newest_on() {
        Program program;
        program.photo("a.jpg", 1);
        program.photo("b.jpg", 3);
        program.photo("c.jpg", 2);
        program.start();
        QVERIFY(program.rests_after(3));
        QCOMPARE(program.looked.in_order(), (Names{"b.jpg", "c.jpg", "a.jpg"}));
        QCOMPARE(program.found("three people smiling"), std::size_t(3));
        QCOMPARE(program.looked.nets.load(), 1);
    }

    void what_was_looked_at_is_known_after_the_next_start() {
        Program program;
        program.photo("a.jpg", 1);
        program.start();
        QVERIFY(program.rests_after(1));
        program.looks.reset();
        program.album.reset();
        program.photo("b.jpg", 2);
        program.start();
        QVERIFY(program.rests_after(2));
        QCOMPARE(program.looked.in_order(), (Names{"a.jpg", "b.jpg"}));
        QCOMPARE(program.found("three people"), std::size_t(2));
    }

    void the_one_that_is_shown_comes_first() {
        Program program;
        program.looked.open = false;
        const fs::path old = program.photo("old.jpg", 1);
        program.photo("new.jpg", 3);
        program.photo("newer.jpg", 4);
        program.start();
        QTRY_COMPARE(program.looked.in_order(), Names{"newer.jpg"});
        program.looks->want(old);
        program.looked.open = true;
        QVERIFY(program.rests_after(3));
        QCOMPARE(program.looked.in_order(), (Names{"newer.jpg", "old.jpg", "new.jpg"}));
    }

    void whoever_is_told_knows_it_from_the_index() {
        Program program;
        const fs::path photo = program.photo("a.jpg", 1);
        program.start(false);
        QVERIFY(program.scanned());
        QSignalSpy told(program.looks.get(), &AlbumLooks::looked);
        bool known = false;
        connect(program.looks.get(), &AlbumLooks::looked, program.looks.get(), [&](const fs::path& one) {
            const auto entry = program.album->queries().find(one);
            known =
                one == photo && program.album->queries().summary(entry.value()->id).value()->seen.has_value();
        });
        program.looks->set_on(true);
        QTRY_COMPARE(told.count(), 1);
        QVERIFY(known);
    }

    void off_nothing_is_looked_at_and_what_goes_on_is_given_up() {
        Program program;
        program.photo("a.jpg", 1);
        program.start(false);
        QVERIFY(program.scanned());
        program.looks->want(program.photo("a.jpg", 1));
        QTest::qWait(50);
        QVERIFY(program.looked.in_order().empty());
        program.looked.open = false;
        program.looks->set_on(true);
        QTRY_COMPARE(program.looked.in_order().size(), std::size_t(1));
        program.looks->set_on(false);
        QTRY_COMPARE(program.looked.stopped.load(), 1);
        QTRY_VERIFY(!program.looks->looking());
        QCOMPARE(program.found("three people"), std::size_t(0));
        program.looked.open = true; // given up is not done
        program.looks->set_on(true);
        QVERIFY(program.rests_after(2));
        QCOMPARE(program.found("three people"), std::size_t(1));
    }

    void another_language_means_other_words_and_no_other_look() {
        Program program;
        program.photo("a.jpg", 1);
        program.start();
        QVERIFY(program.rests_after(1));
        program.looks->set_language(QLocale::German);
        QVERIFY(program.finds("drei Personen", 1));
        QCOMPARE(program.found("people"), std::size_t(0));
        QCOMPARE(program.looked.in_order().size(), std::size_t(1));
    }

    void new_photographs_and_new_names_are_followed() {
        Program program;
        const fs::path photo = program.photo("a.jpg", 1);
        program.start();
        QVERIFY(program.rests_after(1));
        const fs::path another = program.photo("b.jpg", 2);
        program.album->touched(another);
        QVERIFY(program.rests_after(2));
        SidecarChanges changes;
        changes.persons = {"Anna"};
        QCOMPARE(write_sidecar(photo, changes), std::string());
        program.album->touched(photo);
        QVERIFY(program.finds("anna three people", 1));
        QCOMPARE(program.looked.in_order().size(), std::size_t(2));
    }

    /// A photograph that ended the program twice while it was looked at does not end it again; one that was looked at when
    /// somebody ended the program is looked at again.
    void what_a_look_did_not_survive_twice_is_left_alone_data() {
        QTest::addColumn<int>("ended");
        QTest::addColumn<Names>("looked");
        QTest::newRow("once") << 1 << Names{"b.jpg", "a.jpg"};
        QTest::newRow("twice") << 2 << Names{"a.jpg"};
    }
    void what_a_look_did_not_survive_twice_is_left_alone() {
        QFETCH(int, ended);
        QFETCH(Names, looked);
        Program program;
        program.photo("a.jpg", 1);
        program.photo("b.jpg", 2);
        program.start(false);
        QVERIFY(program.scanned());
        {
            SeenPhotos seen(program.album->index(), look_version);
            const auto newest = seen.next("en", {});
            for (int i = 0; i < ended; ++i)
                QCOMPARE(seen.begin(newest.value()->summary.sha256), std::string());
        }
        program.looks->set_on(true);
        QVERIFY(program.rests_after(looked.size()));
        QCOMPARE(program.looked.in_order(), looked);
    }

    void a_look_is_noted_before_it_is_begun() {
        Program program;
        program.photo("a.jpg", 1);
        std::atomic<bool> noted = false;
        program.looked.during = [&](const fs::path& photo) {
            auto index = program.album->index().another();
            AlbumQueries queries(*index);
            const auto entry = queries.find(photo);
            const auto seen = queries.summary(entry.value()->id).value()->seen;
            noted = seen.has_value() && seen->width == 0;
        };
        program.start();
        QVERIFY(program.rests_after(1));
        QVERIFY(noted);
    }

    /// A stick that is pulled out while its photographs are looked at: they are looked at when it is there again.
    void what_was_gone_for_a_while_is_looked_at_when_it_is_there() {
        Program program;
        const fs::path photo = program.photo("a.jpg", 1), away = program.folder / "away.jpg";
        program.looked.during = [&](const fs::path& one) {
            std::error_code gone_already;
            if (!program.looked.reads)
                fs::rename(one, away, gone_already);
        };
        program.looked.reads = false;
        program.start();
        QVERIFY(program.rests_after(1));
        program.looked.reads = true;
        fs::rename(away, photo);
        program.album->rescan();
        QVERIFY(program.finds("three people", 1));
    }

    void the_end_of_the_program_waits_for_no_look() {
        Program program;
        program.looked.open = false;
        program.photo("a.jpg", 1);
        program.start();
        QTRY_COMPARE(program.looked.in_order().size(), std::size_t(1));
        program.looks.reset();
        QCOMPARE(program.looked.stopped.load(), 1);
    }
};

QTEST_GUILESS_MAIN(AlbumLooksTest)
#include "album_looks_test.moc"
