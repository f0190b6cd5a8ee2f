// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/braille.hpp"
#include "print_bench.hpp"

#include <QFile>
#include <QImage>
#include <QLocale>
#include <QScopeGuard>
#include <QTest>

using namespace tp;

class PrintSessionTest : public QObject {
    Q_OBJECT
private slots:
    void a_photograph_becomes_a_sheet_that_is_told_seen_and_stored() {
        PrintBench bench;
        PrintSession& session = bench.session;
        session.open_photo(PrintBench::sample("ben_and_clara.jpg"));
        QVERIFY(session.looking() && !session.ready());
        QTRY_VERIFY_WITH_TIMEOUT(!session.looking(), 60000);
        QVERIFY2(session.ready(), qPrintable(bench.last_said()));
        QVERIFY(bench.last_said().startsWith("Print ben_and_clara.jpg on 210 by 297 millimetres."));
        QCOMPARE(session.faces(), QStringList({"All faces", "Face 1", "Face 2"}));
        const QImage seen = QImage::fromData(QByteArray::fromBase64(session.preview().section(',', 1).toLatin1()));
        QCOMPARE(seen.size(), QSize(840, 1188));
        int black = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x)
                black += seen.pixelColor(x, y).lightness() < 64;
        QVERIFY(black > 2000);
        session.store("pdf");
        session.store("pdf");
        session.store("svg");
        for (const char* name : {"ben_and_clara.pdf", "ben_and_clara 2.pdf", "ben_and_clara.svg"})
            QVERIFY2(std::filesystem::file_size(bench.documents() / name) > 1000, name);
        QVERIFY(bench.last_said().contains("ben_and_clara.svg") && bench.last_said().contains("unscaled"));
    }

    void paper_direction_face_and_title_change_the_sheet() {
        PrintBench bench;
        PrintSession& session = bench.session;
        session.open_photo(PrintBench::sample("ben_and_clara.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(session.ready(), 60000);
        const double both = session.sheet()->mm_per_px;
        session.setLandscape(true);
        QCOMPARE(session.sheet()->width_mm, 297.0);
        session.choosePaper(2);
        QCOMPARE(session.sheet()->width_mm, 420.0);
        QVERIFY(bench.last_said().startsWith("A3: 420 by 297"));
        session.choosePaper(0);
        session.chooseFace(1);
        QVERIFY(session.sheet()->mm_per_px > 1.3 * both);
        QVERIFY(session.sheet()->title.empty());
        session.setTitled(true);
        QCOMPARE(session.sheet()->title, std::string("ben_and_clara"));
        for (const int index : {-1, 99}) {
            session.choosePaper(index);
            session.chooseFace(index);
        }
        QCOMPARE(session.paper(), 0);
        QCOMPARE(session.face(), 1);
    }

    void what_cannot_be_printed_costs_a_sentence() {
        PrintBench bench;
        bench.session.enter();
        QVERIFY(bench.last_said().contains("Choose a photograph"));
        bench.session.store("pdf");
        QVERIFY(bench.last_said().contains("no sheet yet"));
        bench.session.open_photo("/nowhere/face.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.session.looking(), 60000);
        QVERIFY(!bench.session.ready());
        QVERIFY(bench.session.preview().isEmpty());
        QVERIFY(bench.last_said().size() > 10);
        bench.session.store("pdf");
        QVERIFY(!std::filesystem::exists(bench.documents() / "face.pdf"));
    }

    void a_folder_that_cannot_be_made_is_told() {
        PrintBench bench;
        QFile in_the_way(bench.folder.filePath("Documents"));
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        bench.session.open_photo(PrintBench::sample("anna_smiling.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.ready(), 60000);
        bench.session.store("svg");
        QVERIFY(bench.last_said().contains("could not be made"));
    }

    void names_are_in_braille_of_the_pages_language_or_else_in_english() {
        const QLocale before;
        const auto back = qScopeGuard([&] { QLocale::setDefault(before); });
        std::vector<std::string> labels;
        for (const char* language : {"de", "fr", "C"}) {
            QLocale::setDefault(QLocale(language));
            PrintBench bench;
            PrintSession session(bench.narrator, bench.earcons, bench.preferences, bench.documents(),
                                 [](const std::filesystem::path& photo) {
                                     PrintSession::Subject subject = PrintSession::read_subject(photo);
                                     subject.names = {"Jörg"};
                                     return subject;
                                 });
            session.open_photo(PrintBench::sample("anna_smiling.jpg"));
            QTRY_VERIFY_WITH_TIMEOUT(session.ready(), 60000);
            QCOMPARE(session.sheet()->labels.size(), std::size_t{1});
            labels.push_back(as_unicode(session.sheet()->labels[0].lines));
        }
        QVERIFY(labels[0] != labels[1]);
        QCOMPARE(labels[1], labels[2]);
    }

    void the_newest_photograph_wins() {
        PrintBench bench;
        bench.session.open_photo(PrintBench::sample("ben_and_clara.jpg"));
        bench.session.open_photo(PrintBench::sample("anna_smiling.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.ready(), 60000);
        QCOMPARE(bench.session.faces().size(), 1);
        QCOMPARE(bench.session.photoName(), QString("anna_smiling.jpg"));
    }
};

QTEST_MAIN(PrintSessionTest)
#include "print_session_test.moc"
