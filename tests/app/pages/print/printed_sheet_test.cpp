// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/braille.hpp"
#include "print_bench.hpp"
#include "test_program.hpp"

#include <QLocale>
#include <QScopeGuard>
#include <QTest>

namespace printed_sheet_test {

using namespace tp;

class PrintedSheetTest : public QObject {
    Q_OBJECT
private slots:
    void paper_direction_face_and_title_change_the_sheet() {
        PrintBench bench;
        PrintedSheet& sheet = bench.sheet();
        bench.session.open_photo(PrintBench::sample("ben_and_clara.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(sheet.ready(), 60000);
        const double both = sheet.sheet()->mm_per_px;
        sheet.setLandscape(true);
        QCOMPARE(sheet.sheet()->width_mm, 297.0);
        sheet.choosePaper(2);
        QCOMPARE(sheet.sheet()->width_mm, 420.0);
        QVERIFY(bench.last_said().startsWith("A3: 420 by 297"));
        sheet.choosePaper(0);
        sheet.chooseFace(1);
        QVERIFY(sheet.sheet()->mm_per_px > 1.3 * both);
        QVERIFY(sheet.sheet()->title.empty());
        sheet.setTitled(true);
        QCOMPARE(sheet.sheet()->title, std::string("ben_and_clara"));
        for (const int index : {-1, 99}) {
            sheet.choosePaper(index);
            sheet.chooseFace(index);
        }
        QCOMPARE(sheet.paper(), 0);
        QCOMPARE(sheet.face(), 1);
    }

    void names_are_in_braille_of_the_pages_language_or_else_in_english() {
        const QLocale before;
        const auto back = qScopeGuard([&] { QLocale::setDefault(before); });
        std::vector<std::string> labels;
        for (const char* language : {"de", "fr", "C"}) {
            QLocale::setDefault(QLocale(language));
            PrintBench bench;
            PrintedPhoto photo([](const std::filesystem::path& file) {
                PrintedPhoto::Subject subject = PrintedPhoto::read_subject(file);
                subject.names = {"Jörg"};
                return subject;
            });
            PrintedSheet sheet(photo, bench.narrator);
            photo.open(PrintBench::sample("anna_smiling.jpg"));
            QTRY_VERIFY_WITH_TIMEOUT(!photo.looking(), 60000);
            sheet.make();
            QCOMPARE(sheet.sheet()->labels.size(), std::size_t{1});
            labels.push_back(as_unicode(sheet.sheet()->labels[0].lines));
        }
        QVERIFY(labels[0] != labels[1]);
        QCOMPARE(labels[1], labels[2]);
    }

    void there_is_none_until_it_is_made() {
        PrintBench bench;
        PrintedSheet& sheet = bench.sheet();
        sheet.setTitled(true);
        QVERIFY(bench.last_said().contains("name in print"));
        sheet.make(); // of no photograph
        QVERIFY(!sheet.ready() && !sheet.notes().isEmpty() && sheet.size().isEmpty());
        sheet.clear();
        QVERIFY(sheet.notes().isEmpty() && sheet.preview().isEmpty());
        QVERIFY(sheet.titled());
    }
};

} // namespace printed_sheet_test

TP_TEST(printed_sheet_test, PrintedSheetTest, window)
#include "printed_sheet_test.moc"
