// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "places.hpp"
#include "scene_check.hpp"
#include "svg_mutants.hpp"

#include <QTest>

using namespace tp::test;

namespace {

constexpr int mutated_inputs = 2000;

std::vector<Seed> scenes() {
    std::vector<Seed> all = corpus(tp::test::in_source("tests/core/guidance/corpus"));
    const std::vector<Seed> sheets = corpus(tp::test::in_source("tests/core/svg/corpus"));
    all.insert(all.end(), sheets.begin(), sheets.end());
    return all;
}

} // namespace

class HostileScenesTest : public QObject {
    Q_OBJECT
private slots:
    void known_data() {
        QTest::addColumn<QByteArray>("text");
        for (const Seed& input : scenes())
            QTest::newRow(input.name.c_str()) << QByteArray::fromStdString(input.text);
    }
    void known() {
        QFETCH(QByteArray, text);
        QCOMPARE(complaint_about_scene(text.toStdString()), std::string());
    }

    void mutated() {
        const std::vector<Seed> seeds = scenes();
        Mutator mutator(7);
        int felt = 0;
        for (int i = 0; i < mutated_inputs; ++i) {
            const std::string text = mutator.mutant(seeds);
            const std::string complaint = complaint_about_scene(text);
            QVERIFY2(complaint.empty(), (complaint + ": " + text).c_str());
            const auto sheet = tp::sheet_from_svg(text);
            felt += sheet.ok() && !sheet->contours.empty() ? 1 : 0;
        }
        QVERIFY2(felt > mutated_inputs / 10, qPrintable(QString::number(felt)));
    }
};

QTEST_APPLESS_MAIN(HostileScenesTest)
#include "hostile_scenes_test.moc"
