// SPDX-License-Identifier: Apache-2.0
// Where among a photograph's recordings one is listed, which is when it is heard among those of its kind.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "test_program.hpp"

#include <QTest>

#include <filesystem>
#include <string>
#include <vector>

namespace listed_place_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

using Files = std::vector<std::string>;

/// A photograph with three stories.
struct Stories {
    AlbumFolder album;
    fs::path photo = a_photo(album, "a.jpg", 1);
    AlbumKeeper keeper{album.path()};
    Files files;

    Stories() {
        for (const char* name : {"one.wav", "two.wav", "three.wav"})
            files.push_back(keeper
                                .add_recording(photo, a_sound(album, name, 0.5, 300.0),
                                               {RecordingKind::story, {}, {}, {}, {}, {}})
                                ->tag.file);
    }
    Files listed() const {
        Files found;
        const auto record = read_record(photo);
        for (const Tag& tag : record->tags)
            found.push_back(tag.file);
        return found;
    }
    void undo() { QCOMPARE(keeper.history().undo(), std::string()); }
    void redo() { QCOMPARE(keeper.history().redo(), std::string()); }
};

} // namespace

class ListedPlaceTest : public QObject {
    Q_OBJECT

    static void of_three() {
        QTest::addColumn<int>("which");
        QTest::newRow("first") << 0;
        QTest::newRow("in the middle") << 1;
        QTest::newRow("last") << 2;
    }

private slots:
    void a_trimmed_one_stays_where_it_was_data() { of_three(); }
    void a_trimmed_one_stays_where_it_was() {
        QFETCH(int, which);
        Stories stories;
        const auto at = static_cast<std::size_t>(which);
        const auto part = stories.keeper.trim_recording(stories.photo, stories.files[at], 0.1, 0.3);
        QVERIFY2(part.ok(), part.error().c_str());
        Files trimmed = stories.files;
        trimmed[at] = part->file;
        QCOMPARE(stories.listed(), trimmed);
        for (int again = 0; again < 2; ++again) {
            stories.undo();
            QCOMPARE(stories.listed(), stories.files);
            stories.redo();
            QCOMPARE(stories.listed(), trimmed);
        }
    }

    void a_deleted_one_comes_back_to_where_it_was_data() { of_three(); }
    void a_deleted_one_comes_back_to_where_it_was() {
        QFETCH(int, which);
        Stories stories;
        const auto at = static_cast<std::size_t>(which);
        for (int again = 0; again < 2; ++again) {
            if (again == 0)
                QCOMPARE(stories.keeper.delete_recording(stories.photo, stories.files[at]), std::string());
            else
                stories.redo();
            QCOMPARE(stories.listed().size(), stories.files.size() - 1);
            stories.undo();
            QCOMPARE(stories.listed(), stories.files);
        }
    }

    /// As a take that was recorded in place of another.
    void one_is_listed_behind_another_and_comes_back_there() {
        Stories stories;
        const fs::path folder = tags_folder(stories.photo);
        fs::copy_file(folder / stories.files[0], folder / "take.flac");
        QVERIFY(stories.keeper.list_recording(stories.photo, "take.flac", stories.files[0]).ok());
        const Files with_take{stories.files[0], "take.flac", stories.files[1], stories.files[2]};
        QCOMPARE(stories.listed(), with_take);
        stories.undo();
        stories.redo();
        QCOMPARE(stories.listed(), with_take);
    }

    void behind_one_that_is_not_there_it_is_the_last() {
        Stories stories;
        const fs::path folder = tags_folder(stories.photo);
        fs::copy_file(folder / stories.files[0], folder / "take.flac");
        QVERIFY(stories.keeper.list_recording(stories.photo, "take.flac", "gone.flac").ok());
        QCOMPARE(stories.listed().back(), std::string("take.flac"));
    }

    /// From the trash, by hand: nobody knows any more where it was.
    void out_of_the_trash_it_is_the_last() {
        Stories stories;
        QCOMPARE(stories.keeper.delete_recording(stories.photo, stories.files[0]), std::string());
        QCOMPARE(stories.keeper.restore(stories.keeper.trash().entries().at(0).id), std::string());
        QCOMPARE(stories.listed(), (Files{stories.files[1], stories.files[2], stories.files[0]}));
    }
};

} // namespace listed_place_test

TP_TEST(listed_place_test, ListedPlaceTest, event_loop)
#include "listed_place_test.moc"
