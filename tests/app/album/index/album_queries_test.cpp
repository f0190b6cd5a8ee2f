// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_queries.hpp"
#include "app/album/index/sort_keys.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace album_queries_test {

using namespace tp;
using namespace tp::testing;

class AlbumQueriesTest : public QObject {
    Q_OBJECT

    TestAlbum album_;
    std::vector<PhotoEntry> all_; ///< by time
    std::map<PhotoId, PhotoRecord> records_;
    std::unique_ptr<AlbumIndex> index_;

    /// The ids of a list, by pages of seven from one end.
    std::vector<PhotoId> walked(const PhotoList& list, Direction direction) {
        AlbumQueries queries(*index_);
        std::vector<PhotoId> ids;
        std::optional<PlaceInList> from;
        while (true) {
            const auto page = queries.page(list, from, 7, direction);
            if (!page || page.value().empty() || ids.size() > 1000)
                return ids;
            for (const PhotoEntry& photo : page.value())
                ids.push_back(photo.id);
            from = page.value().back().place;
        }
    }

    void compare(const PhotoList& list, const std::vector<PhotoId>& expected) {
        QCOMPARE(walked(list, Direction::forward), expected);
        QCOMPARE(walked(list, Direction::backward), std::vector<PhotoId>(expected.rbegin(), expected.rend()));
        AlbumQueries queries(*index_);
        QCOMPARE(queries.count_before(list, {}).value(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(queries.count_before(list, queries.summary(expected[i]).value()->entry.place).value(), i);
    }

    template <typename Wanted>
    std::vector<PhotoId> where(Wanted wanted) const {
        std::vector<PhotoId> ids;
        for (const PhotoEntry& photo : all_)
            if (wanted(records_.at(photo.id)))
                ids.push_back(photo.id);
        return ids;
    }

private slots:
    void initTestCase() {
        SyntheticAlbum(5).write(album_.root(), 333);
        for (const char* name : {"x/IMG_1.jpg", "y/IMG_1.jpg", "z/IMG_1.jpg"}) // the same moment and name
            album_.add(name, name, {"Zita"});
        index_ = std::make_unique<AlbumIndex>(AlbumIndex::in_memory().value());
        QVERIFY(album_.scan(*index_).ok());
        AlbumQueries queries(*index_);
        all_ = queries.page(AllByTime{}, {}, 1000).value();
        QCOMPARE(all_.size(), std::size_t(336));
        for (const PhotoEntry& photo : all_)
            records_[photo.id] = queries.summary(photo.id).value()->record;
    }

    void a_record_is_what_was_read() {
        for (const PhotoEntry& photo : all_)
            QVERIFY(records_.at(photo.id) == read_synthetic(photo.path).value());
    }

    void lists_are_complete_and_in_order() {
        QVERIFY(std::is_sorted(all_.begin(), all_.end(), [](const PhotoEntry& a, const PhotoEntry& b) {
            return std::tie(a.place.moment, a.place.sort_name, a.id) <
                   std::tie(b.place.moment, b.place.sort_name, b.id);
        }));
        compare(AllByTime{}, where([](const PhotoRecord&) { return true; }));
        std::vector<PhotoEntry> by_name = all_;
        std::sort(by_name.begin(), by_name.end(), [](const PhotoEntry& a, const PhotoEntry& b) {
            return std::pair(sort_key(a.path.filename().string()), a.id) <
                   std::pair(sort_key(b.path.filename().string()), b.id);
        });
        std::vector<PhotoId> ids;
        for (const PhotoEntry& photo : by_name)
            ids.push_back(photo.id);
        compare(AllByName{}, ids);
    }

    void years_and_topics_list_what_they_have() {
        AlbumQueries queries(*index_);
        std::size_t count = 0;
        const std::vector<int> years = queries.years().value();
        for (const int year : years) {
            const auto expected = where(
                [&](const PhotoRecord& record) { return record.taken.starts_with(std::to_string(year)); });
            QVERIFY(!expected.empty());
            compare(OfYear{year}, expected);
            count += expected.size();
        }
        QCOMPARE(count, std::size_t(333));
        compare(OfYear{1800}, {});

        std::set<std::string> people;
        for (const auto& [id, record] : records_)
            people.insert(record.persons.begin(), record.persons.end());
        std::string after;
        for (const std::string& person : people) {
            const auto next = queries.topics("person", after, 1);
            const auto expected = where([&](const PhotoRecord& record) {
                return std::find(record.persons.begin(), record.persons.end(), person) !=
                       record.persons.end();
            });
            QCOMPARE(next.value(), (std::vector<TopicEntry>{{"person", person, expected.size()}}));
            compare(OfTopic{"person", person}, expected);
            after = person;
        }
        QVERIFY(queries.topics("person", after, 1).value().empty());
        const std::string place =
            records_.at(where([](const PhotoRecord& record) { return !record.place_name.empty(); }).front())
                .place_name;
        compare(OfTopic{"place", place},
                where([&](const PhotoRecord& record) { return record.place_name == place; }));
    }

    void neighbours_lie_beside() {
        AlbumQueries queries(*index_);
        for (std::size_t i = 0; i + 1 < all_.size(); ++i) {
            QCOMPARE(queries.neighbour(AllByTime{}, all_[i].place, Direction::forward).value()->id,
                     all_[i + 1].id);
            QCOMPARE(queries.neighbour(AllByTime{}, all_[i + 1].place, Direction::backward).value()->id,
                     all_[i].id);
        }
        QVERIFY(!queries.neighbour(AllByTime{}, all_.back().place, Direction::forward).value());
        QVERIFY(!queries.neighbour(AllByTime{}, all_.front().place, Direction::backward).value());
    }

    void a_photograph_is_found_by_its_path() {
        AlbumQueries queries(*index_);
        for (const PhotoEntry& photo : all_)
            QCOMPARE(queries.find(photo.path).value()->id, photo.id);
        QVERIFY(!queries.find("/nowhere/a.jpg").value());
        QVERIFY(!queries.summary(0).value());
    }

    void a_surprise_is_the_same_for_a_seed_and_any_for_many() {
        AlbumQueries queries(*index_);
        std::set<PhotoId> seen;
        for (std::uint64_t seed = 0; seed < 5000; ++seed) {
            const PhotoId id = queries.surprise(seed).value()->id;
            QCOMPARE(queries.surprise(seed).value()->id, id);
            seen.insert(id);
        }
        QCOMPARE(seen.size(), all_.size());
        auto empty = AlbumIndex::in_memory();
        QVERIFY(!AlbumQueries(*empty).surprise(1).value());
    }
};

} // namespace album_queries_test

TP_TEST(album_queries_test, AlbumQueriesTest, event_loop)
#include "album_queries_test.moc"
