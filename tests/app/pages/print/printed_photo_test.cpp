// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/printed_photo.hpp"
#include "print_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace printed_photo_test {

using namespace tp;

class PrintedPhotoTest : public QObject {
    Q_OBJECT
private slots:
    void the_newest_photograph_wins() {
        PrintedPhoto photo(PrintedPhoto::read_subject);
        QSignalSpy taken(&photo, &PrintedPhoto::taken);
        photo.open(PrintBench::sample("ben_and_clara.jpg"));
        photo.open(PrintBench::sample("anna_smiling.jpg"));
        QTRY_COMPARE_WITH_TIMEOUT(taken.count(), 1, 60000);
        QVERIFY(!photo.looking());
        QCOMPARE(photo.faces(), QStringList("The face"));
        QCOMPARE(photo.name(), QString("anna_smiling.jpg"));
    }

    void faces_have_their_names_where_somebody_knows_them() {
        PrintedPhoto photo([](const std::filesystem::path&) {
            PrintedPhoto::Subject two;
            two.extraction.faces.resize(2);
            two.names = {"Ben", ""};
            return two;
        });
        QCOMPARE(photo.faces(), QStringList("All faces"));
        photo.open("two.jpg");
        QVERIFY(photo.looking());
        QTRY_VERIFY(!photo.looking());
        QCOMPARE(photo.faces(), QStringList({"All faces", "Ben", "Face 2"}));
    }
};

} // namespace printed_photo_test

TP_TEST(printed_photo_test, PrintedPhotoTest, event_loop)
#include "printed_photo_test.moc"
