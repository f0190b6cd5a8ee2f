// SPDX-License-Identifier: Apache-2.0
#include "whole_program.hpp"

#include <QStringList>
#include <QTest>

using namespace tp;

namespace {

constexpr int patience_ms = 60000; ///< for a busy machine

QString file_name(const QString& path) { return path.section('/', -1); }

/// The program whose album is read.
struct WithAlbum {
    WholeProgram whole;
    explicit WithAlbum(const Choices& choices = WholeProgram::asked()) : whole(choices) {}
    ExploreView& felt() { return *whole.program->explore().view(); }
    QString last() { return file_name(whole.program->preferences().choices().last_photo); }
    bool read() { return !whole.program->album().scanning(); }
    bool feels(const char* photo) { return felt().ready() && felt().photoName() == photo; }
    QString shown() { return file_name(whole.program->browse().trail()->photo()); }
    QStringList by_time() {
        QStringList names;
        const auto photos = whole.program->album().queries().page(AllByTime{}, {}, 10);
        for (const PhotoEntry& photo : photos.value())
            names << file_name(QString::fromStdString(photo.path.string()));
        return names;
    }
};

} // namespace

/// Where one is in the album is one place for the pages on which one listens and feels.
class OnePlaceTest : public QObject {
    Q_OBJECT
private slots:
    void feel_a_face_opens_the_newest_and_goes_on_from_there() {
        WithAlbum bench;
        bench.whole.shell().open("explore"); // the album is not read yet
        QTRY_VERIFY_WITH_TIMEOUT(bench.read() && bench.felt().ready(), patience_ms);
        const QStringList names = bench.by_time();
        QCOMPARE(names.size(), 3);
        QTRY_VERIFY_WITH_TIMEOUT(bench.felt().ready(), patience_ms);
        QVERIFY(bench.whole.voice.said().join('\n').contains("Your newest photograph with a face. "));
        bench.whole.program->explore().walk()->previous();
        QTRY_VERIFY_WITH_TIMEOUT(bench.felt().ready(), patience_ms);
        const QString felt = bench.felt().photoName();
        QCOMPARE(bench.last(), felt);
        bench.whole.shell().open("browse");
        QCOMPARE(bench.shown(), felt);
    }

    void pages_follow_each_other() {
        WithAlbum bench;
        bench.whole.shell().open("browse");
        QTRY_VERIFY_WITH_TIMEOUT(bench.read() && bench.whole.program->browse().trail()->ready(), patience_ms);
        const QStringList names = bench.by_time();
        bench.whole.program->browse().trail()->first();
        bench.whole.shell().open("explore");
        QTRY_VERIFY_WITH_TIMEOUT(bench.feels(qPrintable(names[0])), patience_ms);
        bench.whole.program->explore().walk()->next();
        QTRY_VERIFY_WITH_TIMEOUT(bench.feels(qPrintable(names[1])), patience_ms);
        bench.whole.shell().open("browse");
        QCOMPARE(bench.shown(), names[1]);
        bench.whole.program->browse().trail()->last();
        bench.whole.shell().goHome();
        bench.whole.shell().open("explore");
        QTRY_VERIFY_WITH_TIMEOUT(bench.feels(qPrintable(names[2])), patience_ms);
    }

    void a_photograph_from_elsewhere_stays_open_and_moves_nothing() {
        WithAlbum bench;
        bench.whole.shell().open("browse");
        QTRY_VERIFY_WITH_TIMEOUT(bench.read() && bench.whole.program->browse().trail()->ready(), patience_ms);
        const QString at = bench.shown();
        bench.whole.shell().open("explore");
        bench.whole.program->explore().open_file(tp::test::in_source("resources/samples/clara_sad.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.feels("clara_sad.jpg"), patience_ms);
        QCOMPARE(bench.last(), at);
        bench.whole.shell().goHome();
        bench.whole.shell().open("explore");
        QVERIFY(bench.feels("clara_sad.jpg"));
        bench.whole.shell().open("browse");
        QCOMPARE(bench.shown(), at);
    }

    void a_name_that_is_no_text_is_passed_over() {
        WithAlbum bench;
        const std::filesystem::path family = bench.whole.file("Family");
        std::filesystem::copy_file(family / "anna_smiling.jpg", family / "\xff\xfe.jpg");
        bench.whole.program->album().rescan();
        QTRY_VERIFY_WITH_TIMEOUT(bench.by_time().size() == 4 && bench.read(), patience_ms);
        bench.whole.shell().open("explore");
        ExploreWalk& walk = *bench.whole.program->explore().walk();
        QStringList felt;
        for (int i = 0; i < 3; ++i) {
            QTRY_VERIFY_WITH_TIMEOUT(bench.felt().ready(), patience_ms);
            felt << bench.felt().photoName();
            walk.previous();
        }
        felt.sort();
        QCOMPARE(felt, QStringList({"anna_smiling.jpg", "ben_and_clara.jpg", "ben_smiling.jpg"}));
        QCOMPARE(bench.whole.voice.said().back(),
                 QString("No photograph with a face comes before this one."));
    }

    void where_the_last_one_is_gone_the_newest_is_opened() {
        Choices choices = WholeProgram::asked();
        choices.last_photo = "/nowhere/gone.jpg";
        WithAlbum bench(choices);
        bench.whole.shell().open("explore");
        QTRY_VERIFY_WITH_TIMEOUT(bench.felt().ready(), patience_ms);
        QCOMPARE(bench.last(), bench.felt().photoName());
    }
};

QTEST_MAIN(OnePlaceTest)
#include "one_place_test.moc"
