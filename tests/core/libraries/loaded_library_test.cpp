// SPDX-License-Identifier: Apache-2.0
#include "core/libraries/loaded_library.hpp"

#include <QTest>

#include <cmath>
#include <cstdlib>

double function_of_no_library(double);

namespace {

constexpr const char* mathematics = "libm.so.6";

struct Known {
#define TP_TWO_KNOWN(each) each(cbrt) each(ldexp)
    TP_LIBRARY_FUNCTIONS(TP_TWO_KNOWN)
};

struct OneUnknown {
#define TP_ONE_UNKNOWN(each) each(cbrt) each(function_of_no_library) each(atan)
    TP_LIBRARY_FUNCTIONS(TP_ONE_UNKNOWN)
};

#define TP_SEVEN 7

} // namespace

class LoadedLibraryTest : public QObject {
    Q_OBJECT

private slots:
    void finds_all_functions() {
        const auto found = tp::load_functions<Known>(mathematics);
        QVERIFY(found);
        QCOMPARE(found->cbrt(27.0), 3.0);
        QCOMPARE(found->ldexp(1.5, 2), 6.0);
    }
    void one_that_is_missing_spoils_all() { QVERIFY(!tp::load_functions<OneUnknown>(mathematics)); }
    void a_library_that_is_missing_has_none() {
        QVERIFY(!tp::load_functions<Known>("libnobodyhas.so.1"));
        double (*function)(double) = std::cbrt;
        QVERIFY(!tp::LoadedLibrary("libnobodyhas.so.1").find(function, "cbrt"));
        QVERIFY(function == nullptr);
    }
    void names_a_file_of_a_version() {
        QCOMPARE(QString(TP_LIBRARY_FILE("libx", TP_SEVEN)), QString("libx.so.7"));
    }
};

QTEST_GUILESS_MAIN(LoadedLibraryTest)
#include "loaded_library_test.moc"
