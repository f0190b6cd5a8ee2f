// SPDX-License-Identifier: Apache-2.0
#include "print_bench.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QImage>
#include <QTest>

namespace print_session_test {

using namespace tp;

class PrintSessionTest : public QObject {
    Q_OBJECT
private slots:
    void a_photograph_becomes_a_sheet_that_is_told_seen_and_stored() {
        PrintBench bench;
        PrintSession& session = bench.session;
        session.open_photo(PrintBench::sample("ben_and_clara.jpg"));
        QVERIFY(bench.photo().looking() && !bench.sheet().ready());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.photo().looking(), 60000);
        QVERIFY2(bench.sheet().ready(), qPrintable(bench.last_said()));
        QVERIFY(bench.last_said().startsWith("Print ben_and_clara.jpg on 210 by 297 millimetres."));
        QCOMPARE(bench.photo().faces(), QStringList({"All faces", "Face 1", "Face 2"}));
        const QImage seen =
            QImage::fromData(QByteArray::fromBase64(bench.sheet().preview().section(',', 1).toLatin1()));
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

    void what_cannot_be_printed_costs_a_sentence() {
        PrintBench bench;
        bench.session.enter();
        QVERIFY(bench.last_said().contains("Choose a photograph"));
        bench.session.store("pdf");
        QVERIFY(bench.last_said().contains("no sheet yet"));
        bench.session.open_photo("/nowhere/face.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.photo().looking(), 60000);
        QVERIFY(!bench.sheet().ready());
        QVERIFY(bench.sheet().preview().isEmpty());
        QVERIFY(bench.last_said().size() > 10);
        bench.session.store("pdf");
        QVERIFY(!std::filesystem::exists(bench.documents() / "face.pdf"));
    }

    void a_folder_that_cannot_be_made_is_told() {
        PrintBench bench;
        QFile in_the_way(bench.folder.filePath("Documents"));
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        bench.session.open_photo(PrintBench::sample("anna_smiling.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.sheet().ready(), 60000);
        bench.session.store("svg");
        QVERIFY(bench.last_said().contains("could not be created"));
    }
};

} // namespace print_session_test

TP_TEST(print_session_test, PrintSessionTest, window)
#include "print_session_test.moc"
