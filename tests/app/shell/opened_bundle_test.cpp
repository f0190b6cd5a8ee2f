// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/bundle.hpp"
#include "whole_program.hpp"

#include <QTest>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr int patience_ms = 60000; ///< for a busy machine

/// A bundle that somebody sent: one photograph that the album does not have.
QString bundle_in(const WholeProgram& whole) {
    const fs::path elsewhere = whole.file("elsewhere");
    fs::create_directory(elsewhere);
    fs::copy_file(test::in_source("resources/samples/clara_sad.jpg"), elsewhere / "holiday.jpg");
    const fs::path bundle = whole.file("sent.touchphoto");
    return write_bundle(bundle, elsewhere, {elsewhere / "holiday.jpg"}).empty()
               ? QString::fromStdString(bundle.string())
               : QString();
}

int named_holiday(const fs::path& folder) {
    int found = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        found += entry.path().filename() == "holiday.jpg" ? 1 : 0;
    return found;
}

} // namespace

/// What a file manager hands over is no photograph alone.
class OpenedBundleTest : public QObject {
    Q_OBJECT
private slots:
    void a_bundle_opened_from_outside_is_in_the_album() {
        const WholeProgram whole;
        QTRY_VERIFY_WITH_TIMEOUT(!whole.program->album().scanning(), patience_ms);
        const QString bundle = bundle_in(whole);
        QVERIFY(!bundle.isEmpty());
        whole.program->begin(bundle);
        QCOMPARE(whole.program->shell().page(), QString("care"));
        const ImportCare& importing = *whole.program->care().importing();
        QTRY_VERIFY_WITH_TIMEOUT(!importing.running() && !importing.report().isEmpty(), patience_ms);
        QVERIFY2(importing.problems().isEmpty(), qPrintable(importing.report()));
        QCOMPARE(named_holiday(whole.file("Family")), 1);
    }
};

QTEST_MAIN(OpenedBundleTest)
#include "opened_bundle_test.moc"
