// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/print_module.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "print_bench.hpp"
#include "test_program.hpp"

#include <QSize>

namespace print_page_test {

using namespace tp;

class PrintPageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_print(); }

    void a_sheet_is_chosen_and_stored_by_a_screen_reader_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("wide") << QSize(1280, 800);
        QTest::newRow("tall") << QSize(600, 1000);
    }
    void a_sheet_is_chosen_and_stored_by_a_screen_reader() {
        QFETCH(QSize, size);
        PrintBench bench;
        PageWindow window("Print/PrintPage.qml", &bench.session, size);
        QVERIFY(window.exposed());
        QVERIFY(window.named("No sheet yet") != nullptr);
        QVERIFY(window.named("Save as PDF, not available") != nullptr);
        bench.session.open_photo(PrintBench::sample("ben_and_clara.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.sheet().ready(), 60000);
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QCOMPARE(PageWindow::tab_order(window), PageWindow::reading_order(window));
        QVERIFY(window.press("Who: Face 2"));
        QCOMPARE(bench.sheet().face(), 2);
        QVERIFY(window.press("Paper: A3"));
        QVERIFY(window.named("The sheet, 297 by 420 millimetres") != nullptr);
        QVERIFY(window.press("Save as PDF"));
        QVERIFY(std::filesystem::exists(bench.documents() / "ben_and_clara.pdf"));
    }
};

} // namespace print_page_test

TP_TEST(print_page_test, PrintPageTest, window)
#include "print_page_test.moc"
