// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/photo_rows.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QAbstractItemModel>
#include <QPersistentModelIndex>
#include <QRegularExpression>
#include <QSemaphore>
#include <QSet>
#include <QSignalSpy>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace photo_rows_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// Of a.jpg to f.jpg: 0.5 % off; 3 % off; none; 0.5 % off and perhaps covered; 1 % off; 0.5 % off.
FoundFaces drawn_faces(const fs::path& photo) {
    FoundFaces found;
    found.photo = photo;
    const std::string name = photo.stem().string();
    if (name == "c")
        return found;
    Face face;
    face.contours = {Contour{feature::outline, {}, false}};
    face.quality = {{name == "b" ? 3.0 : name == "e" ? 1.0 : 0.5, {}}};
    face.problem = name == "d" ? "It may be covered." : "";
    found.extraction.faces.push_back(face);
    return found;
}

struct Bench : CareGround {
    QSemaphore looks{1'000}; ///< photographs that may be looked at
    FaceFinder finder{[this](const fs::path& photo, const std::stop_token&) {
        looks.acquire();
        return drawn_faces(photo);
    }};
    Thumbnails thumbnails;
    PhotoRows rows{*album, finder, thumbnails, [] { return QString("en"); }};
    QSignalSpy resets{&rows, &QAbstractItemModel::modelReset}, told{&rows, &QAbstractItemModel::dataChanged};

    using CareGround::CareGround;
    ~Bench() { looks.release(1'000); }

    QStringList names() const {
        QStringList names;
        for (int i = 0; i < rows.rowCount(); ++i)
            names << rows.data(rows.index(i), PhotoRows::NameRole).toString();
        return names;
    }
    QString detail(int row) const { return rows.data(rows.index(row), PhotoRows::DetailRole).toString(); }
    QImage picture(int row) const {
        return rows.data(rows.index(row), PhotoRows::PictureRole).value<QImage>();
    }
    /// As a page of the program changes it.
    void describe(const std::string& name, const std::string& text) {
        QCOMPARE(album->keeper_for(photo(name)).describe(photo(name), "en", text, ""), std::string());
        album->touched(photo(name));
    }
    bool scanned() {
        return QTest::qWaitFor([this] { return !album->scanning(); }, 60'000);
    }
    void look_at(int photos) {
        looks.acquire(looks.available());
        looks.release(photos);
    }
};

std::vector<std::string> many_names(int count) {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i)
        names.push_back(QString("p%1.jpg").arg(i, 3, 10, QChar('0')).toStdString());
    return names;
}

} // namespace

class PhotoRowsTest : public QObject {
    Q_OBJECT
private slots:
    void the_newest_photograph_comes_first_page_by_page() {
        Bench bench(many_names(120));
        QCOMPARE(bench.rows.total(), 120);
        QCOMPARE(bench.rows.rowCount(), 50);
        QCOMPARE(bench.rows.rowCount(bench.rows.index(0)), 0);
        QVERIFY(bench.rows.canFetchMore({}) && !bench.rows.canFetchMore(bench.rows.index(0)));
        QSignalSpy inserted(&bench.rows, &QAbstractItemModel::rowsInserted);
        bench.rows.fetchMore(bench.rows.index(0));
        QCOMPARE(bench.rows.rowCount(), 50);
        bench.rows.fetchMore({});
        QCOMPARE(inserted.last().mid(1), (QVariantList{50, 99}));
        bench.rows.fetchMore({});
        QCOMPARE(bench.rows.rowCount(), 120);
        QCOMPARE(inserted.last().mid(1), (QVariantList{100, 119}));
        QVERIFY(!bench.rows.canFetchMore({}));
        bench.rows.fetchMore({});
        QCOMPARE(inserted.size(), 2);
        const QStringList names = bench.names();
        QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), 120);
    }
    void a_list_that_ends_with_a_page_has_no_more_after_it() {
        Bench bench(many_names(50));
        QVERIFY(bench.rows.canFetchMore({})); // nobody knows yet
        bench.rows.fetchMore({});
        QCOMPARE(bench.rows.rowCount(), 50);
        QVERIFY(!bench.rows.canFetchMore({}));
    }
    void as_many_rows_stay_as_were_scrolled_to() {
        Bench bench(many_names(120));
        bench.rows.fetchMore({});
        QCOMPARE(bench.rows.rowCount(), 100);
        bench.rows.refresh();
        QCOMPARE(bench.rows.rowCount(), 100);
        QVERIFY(bench.rows.canFetchMore({}));
        QVERIFY(bench.resets.isEmpty());
    }
    void an_album_without_photographs_has_none() {
        Bench bench({}, false);
        QCOMPARE(bench.rows.rowCount(), 0);
        QCOMPARE(bench.rows.total(), 0);
        QVERIFY(!bench.rows.canFetchMore({}));
        bench.rows.refresh();
        QVERIFY(bench.told.isEmpty() && bench.resets.isEmpty());
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        QCOMPARE(bench.rows.rowCount(), 0);
        QVERIFY(!bench.rows.data(bench.rows.index(0), PhotoRows::NameRole).isValid());
        QSignalSpy totals(&bench.rows, &PhotoRows::totalChanged);
        bench.preferences.change([&bench](Choices& choices) {
            choices.folders << QString::fromStdString((bench.folder / "album").string());
        });
        a_photo(bench.folder, "album/a.jpg", 1);
        bench.album->rescan();
        CARE_TRY_COMPARE(bench.rows.total(), 1);
        QCOMPARE(bench.names(), QStringList{"a.jpg"});
        QVERIFY(!totals.isEmpty());
    }
    void a_row_and_its_photograph_find_each_other() {
        Bench bench({"a.jpg", "b.jpg"});
        for (int row = 0; row < 2; ++row)
            QCOMPARE(bench.rows.row_of(bench.rows.photo(row)), row);
        QVERIFY(bench.rows.photo(0) != bench.rows.photo(1));
        QVERIFY(bench.rows.photo(-1).empty() && bench.rows.photo(2).empty());
        QCOMPARE(bench.rows.row_of(bench.photo("c.jpg")), -1);
        QCOMPARE(bench.rows.roleNames().value(PhotoRows::DetailRole), QByteArray("detail"));
    }
    void a_row_tells_how_many_recordings_and_a_missing_description_without_the_list_being_made_anew() {
        Bench bench({"a.jpg", "b.jpg"});
        const int row = bench.rows.row_of(bench.photo("a.jpg"));
        QCOMPARE(bench.detail(row), QString("No description."));
        bench.add_sound("a.jpg", 0.5, 440.0);
        bench.describe("a.jpg", "A garden");
        CARE_TRY_COMPARE(bench.detail(row), QString("1 recording(s)."));
        QVERIFY(bench.resets.isEmpty());
        CARE_TRY_VERIFY(!bench.told.isEmpty());
        QCOMPARE(bench.told.last().at(0).toModelIndex().row(), 0);
        QCOMPARE(bench.told.last().at(1).toModelIndex().row(), 1);
    }
    void a_photograph_that_another_program_deletes_goes_and_is_not_counted() {
        Bench bench({"a.jpg", "b.jpg", "c.jpg"});
        QSignalSpy totals(&bench.rows, &PhotoRows::totalChanged);
        QStringList left = bench.names();
        left.removeAll("b.jpg");
        fs::remove(bench.photo("b.jpg"));
        bench.album->rescan();
        CARE_TRY_COMPARE(bench.rows.rowCount(), 2);
        QCOMPARE(bench.names(), left);
        QCOMPARE(bench.rows.total(), 2);
        QVERIFY(!totals.isEmpty());
        bench.preferences.change([](Choices& choices) { choices.folders.clear(); });
        CARE_TRY_COMPARE(bench.rows.total(), 0);
        QCOMPARE(bench.rows.rowCount(), 0);
    }
    void a_picture_comes_later_and_its_row_alone_is_told() {
        Bench bench({"a.png", "b.png"}, true, true);
        QVERIFY(bench.picture(1).isNull());
        CARE_TRY_COMPARE(bench.told.size(), 1);
        QCOMPARE(bench.told.at(0).at(0).toModelIndex().row(), 1);
        QCOMPARE(bench.told.at(0).at(2).value<QList<int>>(), QList<int>{PhotoRows::PictureRole});
        const QImage picture = bench.picture(1);
        QCOMPARE(std::max(picture.width(), picture.height()), Thumbnails::side_px);
        bench.thumbnails.picture({bench.folder / "elsewhere.png"});
        QSignalSpy came(&bench.thumbnails, &Thumbnails::came);
        CARE_TRY_COMPARE(came.size(), 1);
        QCOMPARE(bench.told.size(), 1);
    }

    // --- those first whose faces look wrong ---

    void faces_that_look_wrong_come_first_those_without_a_face_last() {
        Bench bench({"a.jpg", "b.jpg", "c.jpg", "d.jpg"});
        const QStringList by_time = bench.names();
        QSignalSpy order(&bench.rows, &PhotoRows::orderChanged),
            totals(&bench.rows, &PhotoRows::totalChanged);
        bench.rows.setOrder(PhotoRows::Order::NewestFirst);
        QVERIFY(order.isEmpty() && bench.rows.leftToJudge() == 0); // nobody asked for it
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        QCOMPARE(order.size(), 1);
        QCOMPARE(bench.rows.rowCount(), 4);
        CARE_TRY_COMPARE(bench.rows.leftToJudge(), 0);
        QVERIFY(totals.size() >= 5);
        QCOMPARE(bench.names(), QStringList({"d.jpg", "b.jpg", "a.jpg", "c.jpg"}));
        QCOMPARE(bench.detail(0), QString("Faces look wrong: 0.5 % off. No description."));
        QCOMPARE(bench.detail(1), QString("Faces about 3.0 % off. No description."));
        QCOMPARE(bench.detail(3), QString("No face found. No description."));
        bench.rows.refresh();
        QCOMPARE(bench.names(), QStringList({"d.jpg", "b.jpg", "a.jpg", "c.jpg"}));
        QVERIFY(!bench.rows.canFetchMore({}));
        bench.rows.setOrder(PhotoRows::Order::NewestFirst);
        QCOMPARE(order.size(), 2);
        QCOMPARE(bench.names(), by_time);
        QCOMPARE(bench.detail(0), QString("No description."));
    }
    void many_are_gathered_in_parts_and_until_then_the_rows_stay() {
        Bench bench(many_names(700));
        const QStringList by_time = bench.names();
        QCOMPARE(by_time.size(), 50);
        bench.look_at(0);
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        QCOMPARE(bench.names(), by_time);
        bench.rows.refresh(); // the album changes meanwhile
        QCOMPARE(bench.names(), by_time);
        CARE_TRY_COMPARE(bench.rows.rowCount(), 700);
        QVERIFY(!bench.rows.canFetchMore({}));
        QCOMPARE(bench.names().mid(0, 50), by_time);
        for (const int row : {0, 499, 500, 699})
            QCOMPARE(bench.rows.row_of(bench.rows.photo(row)), row);
        CARE_TRY_COMPARE(bench.rows.leftToJudge(), 700);
        bench.rows.setOrder(PhotoRows::Order::NewestFirst);
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        bench.rows.setOrder(PhotoRows::Order::NewestFirst); // before all were gathered
        QTest::qWait(50);
        QCOMPARE(bench.rows.rowCount(), 700);
        QVERIFY(bench.rows.leftToJudge() <= 1);
        bench.looks.release(700);
    }
    void each_goes_to_its_place_as_it_is_judged_and_who_is_on_a_row_stays_on_it() {
        Bench bench({"a.jpg", "b.jpg", "c.jpg", "d.jpg", "e.jpg", "f.jpg"});
        const QStringList by_time = bench.names();
        bench.look_at(0);
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        QCOMPARE(bench.names(), by_time);
        QCOMPARE(bench.detail(0), QString("Not checked yet. No description."));
        QCOMPARE(bench.rows.leftToJudge(), 6);
        QVERIFY(bench.resets.isEmpty());
        std::vector<QPersistentModelIndex> on;
        for (int row = 0; row < 6; ++row)
            on.emplace_back(bench.rows.index(row));
        QSignalSpy moved(&bench.rows, &QAbstractItemModel::rowsMoved);
        for (int judged = 1; judged <= 6; ++judged) {
            bench.told.clear();
            bench.looks.release();
            CARE_TRY_COMPARE(bench.rows.leftToJudge(), 6 - judged);
            QCOMPARE(bench.told.size(), 1);
            QCOMPARE(bench.told.at(0).at(2).value<QList<int>>(), QList<int>{PhotoRows::DetailRole});
            const int none = bench.rows.row_of(bench.photo("c.jpg"));
            if (bench.detail(none).startsWith("No face found."))
                QCOMPARE(none, 5); // also behind those that nobody has looked at yet
        }
        const QStringList alike = by_time.filter(QRegularExpression("^[af]")); // of those the newest first
        QCOMPARE(bench.names(), QStringList({"d.jpg", "b.jpg", "e.jpg"}) + alike + QStringList{"c.jpg"});
        QVERIFY(!moved.isEmpty() && bench.resets.isEmpty());
        for (int row = 0; row < 6; ++row)
            QCOMPARE(on[static_cast<std::size_t>(row)].data(PhotoRows::NameRole).toString(), by_time[row]);
    }
    void by_time_again_nothing_more_is_judged() {
        Bench bench({"a.jpg", "b.jpg", "c.jpg"});
        bench.look_at(0);
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        QCOMPARE(bench.rows.leftToJudge(), 3);
        QSignalSpy totals(&bench.rows, &PhotoRows::totalChanged);
        bench.rows.setOrder(PhotoRows::Order::NewestFirst);
        QVERIFY(bench.rows.leftToJudge() <= 1); // the one that is looked at now
        QVERIFY(!totals.isEmpty());
        const QStringList by_time = bench.names();
        QSignalSpy moved(&bench.rows, &QAbstractItemModel::rowsMoved);
        bench.looks.release(3);
        CARE_TRY_COMPARE(bench.rows.leftToJudge(), 0);
        QVERIFY(moved.isEmpty());
        QCOMPARE(bench.names(), by_time);
    }
    void what_goes_or_comes_while_faces_are_judged_is_taken_over() {
        Bench bench({"a.jpg", "b.jpg", "c.jpg"});
        bench.rows.setOrder(PhotoRows::Order::LooksWrong);
        CARE_TRY_COMPARE(bench.rows.leftToJudge(), 0);
        bench.look_at(0);
        fs::remove(bench.photo("b.jpg"));
        using namespace std::chrono_literals;
        fs::last_write_time(a_photo(bench.folder, "album/d.jpg", 9), fs::file_time_type::clock::now() - 48h);
        bench.album->rescan();
        CARE_TRY_VERIFY(bench.rows.row_of(bench.photo("d.jpg")) >= 0);
        QVERIFY(bench.scanned());
        QCOMPARE(bench.names(), QStringList({"a.jpg", "d.jpg", "c.jpg"})); // the oldest, and not looked at
        bench.looks.release(100);
        CARE_TRY_COMPARE(bench.rows.leftToJudge(), 0);
        QCOMPARE(bench.names(), QStringList({"d.jpg", "a.jpg", "c.jpg"}));
    }
};

} // namespace photo_rows_test

TP_TEST(photo_rows_test, PhotoRowsTest, window)
#include "photo_rows_test.moc"
