// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_news.hpp"
#include "app/album/index/album_queries.hpp"
#include "app/album/index/seen_photos.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>

namespace album_news_test {

using namespace tp;
using namespace tp::testing;

namespace {

struct Bench {
    TestAlbum album;
    AlbumIndex index = std::move(AlbumIndex::in_memory()).value();

    void add(const std::string& name) {
        album.add(name, name);
        if (!album.scan(index))
            qFatal("no scan");
    }
    void look(const std::string& name, std::size_t faces) {
        AlbumQueries queries(index);
        SeenPhoto seen;
        seen.faces.resize(faces);
        const auto entry = queries.find(fs::canonical(album.root()) / name);
        QCOMPARE(SeenPhotos(index, 1).put(queries.summary(entry.value()->id).value()->sha256, {seen, {}}),
                 std::string());
    }
    News news() { return AlbumNews(index).news().value(); }
    void tell() { QCOMPARE(AlbumNews(index).told(), std::string()); }
};

} // namespace

class AlbumNewsTest : public QObject {
    Q_OBJECT
private slots:
    void an_album_that_is_read_for_the_first_time_is_no_news() {
        Bench bench;
        bench.add("a.jpg");
        QVERIFY(bench.news() == News());
        bench.tell();
        QVERIFY(bench.news() == News());
    }

    void what_came_since_is_news_until_it_is_told() {
        Bench bench;
        bench.add("a.jpg");
        bench.tell();
        bench.add("b.jpg");
        bench.add("c.jpg");
        bench.add("d.jpg");
        QVERIFY((bench.news() == News{3, 0, 3}));
        bench.look("b.jpg", 2);
        bench.look("c.jpg", 0);
        QVERIFY((bench.news() == News{3, 1, 1}));
        bench.tell();
        QVERIFY(bench.news() == News());
    }

    void what_is_gone_again_is_no_news() {
        Bench bench;
        bench.add("a.jpg");
        bench.tell();
        bench.add("b.jpg");
        fs::remove(bench.album.root() / "b.jpg");
        QVERIFY(bench.album.scan(bench.index));
        QVERIFY(bench.news() == News());
    }
};

} // namespace album_news_test

TP_TEST(album_news_test, AlbumNewsTest, event_loop)
#include "album_news_test.moc"
