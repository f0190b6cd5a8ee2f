// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_walk.hpp"
#include "explore_parts.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QColor>
#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

namespace explore_walk_test {

using namespace tp;

namespace {

constexpr int patience_ms = 60000; ///< for a busy machine

/// An album of an empty wall, a portrait, a wall, a file that is no photograph, and another portrait.
struct Album {
    QTemporaryDir folder;
    QStringList files;

    Album() {
        wall("1_wall.png");
        portrait("2_anna.jpg", "anna_smiling.jpg");
        wall("3_wall.png");
        files << folder.filePath("4_broken.jpg");
        QFile broken(files.back());
        if (broken.open(QFile::WriteOnly))
            broken.write("no photograph");
        broken.close();
        portrait("5_ben.jpg", "ben_smiling.jpg");
    }
    void wall(const QString& name) {
        QImage image(320, 240, QImage::Format_RGB32);
        image.fill(QColor(120, 110, 100));
        files << folder.filePath(name);
        image.save(files.back());
    }
    void portrait(const QString& name, const char* sample) {
        files << folder.filePath(name);
        QFile::copy(QString(tp::test::in_source("resources/samples/")) + sample, files.back());
    }
    QString beside(const QString& file, bool forward) const {
        const qsizetype at = files.indexOf(file);
        const qsizetype next = forward ? at + 1 : (at < 0 ? files.size() : at) - 1;
        return next < 0 || next >= files.size() ? QString() : files[next];
    }
};

struct WalkBench {
    Album album;
    bool empty = false; ///< the album does not know its photographs yet
    ExploreParts parts{0};
    ExploreSettings settings;
    std::unique_ptr<ExploreWalk> walk;

    WalkBench() {
        settings.beside = [this](const QString& file, bool forward) {
            return empty ? QString() : album.beside(file, forward);
        };
        walk = std::make_unique<ExploreWalk>(settings, parts.view, parts.words);
    }
    ExploreView& view() { return parts.view; }
    bool stands_at(const char* name) { return view().ready() && view().photoName() == name; }
};

} // namespace

class ExploreWalkTest : public QObject {
    Q_OBJECT
private slots:
    void from_face_to_face_and_what_has_none_is_passed_over() {
        WalkBench bench;
        QSignalSpy out(bench.walk.get(), &ExploreWalk::setting_out);
        bench.walk->next(); // from nowhere: the oldest
        QCOMPARE(out.size(), 1);
        QCOMPARE(bench.view().state(), ExploreView::State::Looking);
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("2_anna.jpg"), patience_ms);
        QVERIFY2(
            bench.parts.said().startsWith("Skipped 1 photograph(s) without a face. 2_anna.jpg. One face."),
            qPrintable(bench.parts.said()));
        bench.walk->next();
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("5_ben.jpg"), patience_ms);
        QVERIFY(
            bench.parts.said().startsWith("Skipped 2 photograph(s) without a face. 5_ben.jpg. One face."));
        bench.walk->previous();
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("2_anna.jpg"), patience_ms);
        QCOMPARE(bench.view().file(), bench.album.files[1]);
        QVERIFY(bench.view().featureCount() > 0);
    }

    void at_the_ends_what_was_open_stays_open() {
        WalkBench bench;
        bench.walk->newest();
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("5_ben.jpg"), patience_ms);
        QVERIFY(bench.parts.said().startsWith("Your newest photograph with a face. 5_ben.jpg. One face."));
        bench.parts.sounds.hears(Earcon::ready); // longer than what is listened to
        QSignalSpy out(bench.walk.get(), &ExploreWalk::setting_out);
        bench.walk->next(); // nothing comes at all
        QCOMPARE(out.size(), 0);
        QVERIFY(bench.stands_at("5_ben.jpg"));
        QCOMPARE(bench.parts.said(), QString("No photograph with a face comes after this one."));
        QVERIFY(bench.parts.sounds.hears(Earcon::list_end));
        bench.walk->previous();
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("2_anna.jpg"), patience_ms);
        bench.walk->previous(); // only a wall comes
        QTRY_COMPARE_WITH_TIMEOUT(bench.parts.said(),
                                  QString("No photograph with a face comes before this one."), patience_ms);
        QVERIFY(bench.stands_at("2_anna.jpg"));
        QVERIFY(bench.view().featureCount() > 0);
    }

    void an_album_without_a_face_says_so() {
        WalkBench bench;
        bench.album.files = {bench.album.files[0], bench.album.files[2], bench.album.files[3]};
        bench.walk->newest();
        QTRY_COMPARE_WITH_TIMEOUT(bench.parts.said(),
                                  QString("There is no face on any photograph in the album."), patience_ms);
        QCOMPARE(bench.view().state(), ExploreView::State::Empty);
    }

    void an_empty_album_is_waited_for() {
        WalkBench bench;
        bench.empty = true;
        bench.walk->newest();
        QVERIFY(bench.parts.said().startsWith("There is no photograph yet."));
        bench.walk->album_changed();
        QCOMPARE(bench.view().state(), ExploreView::State::Empty);
        bench.empty = false;
        bench.walk->album_changed();
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("5_ben.jpg"), patience_ms);
        bench.view().load(bench.album.files[0]);
        QTRY_COMPARE_WITH_TIMEOUT(bench.view().state(), ExploreView::State::Problem, patience_ms);
        bench.walk->album_changed(); // nobody waits any more
        QCOMPARE(bench.view().state(), ExploreView::State::Problem);
    }

    void who_gives_up_or_opens_another_goes_no_further() {
        WalkBench bench;
        bench.walk->next();
        QVERIFY(bench.view().looking_into());
        QCOMPARE(bench.view().give_up(), QString("Search stopped. Press O to open a photograph."));
        QVERIFY(!bench.view().looking_into());
        QCOMPARE(bench.view().state(), ExploreView::State::Empty);
        bench.walk->album_changed();
        QCOMPARE(bench.view().state(), ExploreView::State::Empty);

        bench.walk->next();
        bench.view().load(bench.album.files[4]);
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("5_ben.jpg"), patience_ms);
        QVERIFY(bench.parts.said().startsWith("One face."));
    }

    void who_turns_round_goes_from_where_one_was() {
        WalkBench bench;
        bench.view().load(bench.album.files[1]);
        QTRY_VERIFY_WITH_TIMEOUT(bench.stands_at("2_anna.jpg"), patience_ms);
        bench.walk->next();
        bench.walk->next(); // it is on its way
        QVERIFY(bench.view().looking_into());
        bench.walk->previous();
        QTRY_COMPARE_WITH_TIMEOUT(bench.parts.said(),
                                  QString("No photograph with a face comes before this one."), patience_ms);
        QVERIFY(bench.stands_at("2_anna.jpg"));
    }

    void a_photograph_that_goes_meanwhile_leads_nobody_in_a_circle() {
        WalkBench bench;
        bench.album.files = {bench.album.files[0], bench.album.files[2]};
        const QStringList whole = bench.album.files;
        bench.settings.beside = [&](const QString& file, bool) {
            return file == whole[0] ? whole[1] : whole[0]; // the second one is not known any more
        };
        ExploreWalk walk(bench.settings, bench.view(), bench.parts.words);
        bench.walk.reset();
        walk.next();
        QTRY_COMPARE_WITH_TIMEOUT(bench.parts.said(),
                                  QString("There is no face on any photograph in the album."), patience_ms);
        QCOMPARE(bench.view().state(), ExploreView::State::Empty);
    }

    void without_an_album_there_is_nowhere_to_go() {
        ExploreParts parts;
        ExploreWalk walk(parts.settings, parts.view, parts.words);
        walk.next();
        QCOMPARE(parts.said(), QString("No photograph with a face comes after this one."));
        QVERIFY(parts.view.ready());
    }
};

} // namespace explore_walk_test

TP_TEST(explore_walk_test, ExploreWalkTest, event_loop)
#include "explore_walk_test.moc"
