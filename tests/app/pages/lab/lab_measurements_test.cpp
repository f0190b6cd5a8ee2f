// SPDX-License-Identifier: Apache-2.0
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace lab_measurements_test {

using namespace tp;

class LabMeasurementsTest : public QObject {
    Q_OBJECT
private slots:
    void the_readings_say_what_the_plots_show() {
        LabParts bench;
        LabMeasurements& measurements = bench.measurements;
        QVERIFY(measurements.readings()[LabMeasurements::Force].contains("nothing measured yet"));
        measurements.begin(1000.0, 0);
        measurements.add({0.0, {3, 4}, {0.3, 0.4}});
        measurements.add({0.001, {3, 4}, {0.0, 0.2}});
        QVERIFY(measurements.readings()[LabMeasurements::Force].contains("nothing measured yet"));
        measurements.renew();
        QVERIFY2(measurements.readings()[LabMeasurements::Force].startsWith(
                     "Force |F| now 0.20 newtons, at most 0.50"),
                 qPrintable(measurements.readings()[LabMeasurements::Force]));
        measurements.readPlots();
        QVERIFY(bench.last().contains("Position now x ") && bench.last().contains("Energy"));
    }
    void plots_are_renewed_oftener_than_sentences() {
        LabParts bench;
        QSignalSpy plotted(&bench.measurements, &LabMeasurements::plotted);
        QSignalSpy read(&bench.measurements, &LabMeasurements::readingsChanged);
        for (int ms = 0; ms < 1000; ms += 16)
            bench.measurements.poll();
        QCOMPARE(plotted.size(), 12);
        QCOMPARE(read.size(), 2);
    }
};

} // namespace lab_measurements_test

TP_TEST(lab_measurements_test, LabMeasurementsTest, window)
#include "lab_measurements_test.moc"
