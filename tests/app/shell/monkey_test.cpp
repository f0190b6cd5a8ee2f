// SPDX-License-Identifier: Apache-2.0
#include "effort.hpp"
#include "monkey.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "whole_program.hpp"

#include <QCoreApplication>
#include <QString>
#include <QTest>

using namespace tp;

namespace {

/// On each page: 3 000, in CI a third of them but for every third time; TP_DEEDS asks for others. The hours of soak_test.cpp,
/// with the same checks after each deed, come on top.
int deeds_per_page() {
    if (qEnvironmentVariableIsSet("TP_DEEDS"))
        return qEnvironmentVariableIntValue("TP_DEEDS");
    return test::is_long_run() ? 3'000 : 1'000;
}

} // namespace

class MonkeyTest : public PageTest {
    Q_OBJECT
private slots:
    void a_page_survives_and_escape_leads_home_data() {
        QTest::addColumn<QString>("page");
        for (const char* page :
             {"start", "browse", "explore", "care", "capture", "mend", "print", "lab", "study", "settings"})
            QTest::newRow(page) << page;
    }
    void a_page_survives_and_escape_leads_home() {
        QFETCH(QString, page);
        WholeProgram whole;
        QVERIFY(whole.shown());
        whole.shell().open(page);
        if (page == "explore")
            whole.program->explore().open_file(whole.folder.filePath("Family/ben_and_clara.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(whole.complete(), 60000);
        Monkey monkey(whole, 20260501);
        for (int i = 0; i < deeds_per_page(); ++i) {
            monkey.do_something();
            if (whole.shell().page() != page) // it found a way out
                whole.shell().open(page);
            if (i % 16 == 0)
                QCoreApplication::processEvents();
            const double newtons = whole.program->explore().finger()->newtons();
            QVERIFY2(newtons <= whole.program->preferences().choices().max_force_n + 1e-9, qPrintable(monkey.last()));
            QVERIFY2(whole.keeps_to_its_folder(), qPrintable(monkey.last()));
            QVERIFY2(warnings().isEmpty(), qPrintable(monkey.last() + ": " + warnings().join('\n')));
        }
        for (int i = 0; i < 5 && !whole.shell().home(); ++i) {
            QCoreApplication::processEvents(); // the keyboard leaves what was hidden just now
            QTest::keyClick(whole.window.get(), Qt::Key_Escape);
        }
        const QObject* const keyboard = whole.window->activeFocusItem();
        QVERIFY2(whole.shell().home(),
                 keyboard == nullptr ? "nobody has the keyboard" : keyboard->metaObject()->className());
    }
};

QTEST_MAIN(MonkeyTest)
#include "monkey_test.moc"
