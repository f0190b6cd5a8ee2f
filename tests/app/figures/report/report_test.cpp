// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/continuity_cost.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/loop_work.hpp"
#include "app/figures/report/plot.hpp"
#include "app/figures/report/released_handle.hpp"
#include "app/figures/report/stability_plots.hpp"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

class ReportTest : public QObject {
    Q_OBJECT
private slots:
    void loops_show_the_published_law_working_and_the_exact_one_not() {
        const std::vector<LoopWork> rows = measure_loop_work({1.0, 10.0}, {40'000, 100, 1885});
        QCOMPARE(rows.size(), std::size_t(4));
        for (const LoopWork& row : rows) {
            if (row.law == "exact") {
                QCOMPARE(row.wrong_fraction, 0.0);
                QVERIFY(row.max_loop_work_mj < 1e-4); // what is left is the error of the quadrature
            } else {
                QVERIFY(row.max_loop_work_mj > 0.01);
            }
            QVERIFY(row.p99_loop_work_mj <= row.max_loop_work_mj);
            QVERIFY(row.max_force_step_n > 0.5);
            QVERIFY(row.wrong_of_pulled >= row.wrong_fraction && row.wrong_of_pulled < 0.5);
        }
        const LoopWork& dense = rows[1];
        const LoopWork& coarse = rows[3];
        QVERIFY(coarse.max_loop_work_mj > 10.0 * dense.max_loop_work_mj);
        // Measured with another transcription of the listing: 0.07 and 3.5 % of the places.
        QVERIFY2(std::abs(dense.wrong_fraction - 0.0007) < 0.0005,
                 qPrintable(QString::number(dense.wrong_fraction)));
        QVERIFY2(std::abs(coarse.wrong_fraction - 0.035) < 0.005,
                 qPrintable(QString::number(coarse.wrong_fraction)));
    }

    void handles_settle_with_the_remedies_and_swing_without() {
        HandleCase handle;
        handle.delay = 2;
        handle.damping = 0.05;
        QVERIFY(release_handle(handle, 4.0).settled);
        handle.observer = false;
        handle.line_damping = false;
        const HandleResult bare = release_handle(handle, 4.0);
        QVERIFY(!bare.settled);
        QVERIFY(bare.amplitude_mm > 0.5);
        QVERIFY(std::abs(handle.bound() - 0.5) < 1e-12); // DEVICES.md: K = 0.2 N/mm, T = 1 ms, n = 2
    }

    void softening_a_switch_buys_smoothness_for_accuracy() {
        const std::vector<ContinuityCost> rows = measure_continuity({40'000, 100, 2.0});
        const auto of = [&](const std::string& manner, double width) {
            for (const ContinuityCost& row : rows)
                if (row.manner == manner && row.width_mm == width)
                    return row;
            qFatal("no row of %s", manner.c_str());
        };
        const ContinuityCost exact = of("exact", 0.0);
        QCOMPARE(exact.max_error_n, 0.0);
        QVERIFY(exact.largest_step_n > 1.0 && exact.tremor_clicks_per_s > 100.0);
        for (const ContinuityCost& row : rows)
            QVERIFY(row.work_given_mj < 0.02); // what is left is the error of the quadrature
        QVERIFY(of("hold", 0.5).tremor_clicks_per_s < 1.0);
        QVERIFY(of("hold", 0.5).mean_error_n > of("hold", 0.3).mean_error_n);
        QVERIFY(of("hold", 0.3).mean_error_n > 0.0);
        QVERIFY(of("blend", 0.3).largest_step_n < 0.5 * exact.largest_step_n);
        QVERIFY(of("blend", 1.0).largest_step_n < of("blend", 0.5).largest_step_n);
        QVERIFY(of("blend", 1.0).mean_error_n > of("blend", 0.5).mean_error_n);
        QVERIFY(of("corner_cue", 2.0).max_error_n > 0.1 && of("corner_cue", 2.0).mean_error_n < 0.005);
    }

    void the_grid_covers_what_the_report_promises() {
        for (const bool quick : {true, false}) {
            std::size_t required = 0;
            for (const HandleCase& handle : handle_grid(quick))
                if (handle.observer && handle.line_damping && handle.period == 0.001 &&
                    handle.damping >= 0.05 && handle.delay <= 2 &&
                    (handle.stiffness == 0.2 || handle.stiffness == 0.5) &&
                    (handle.mass == 0.05 || handle.mass == 0.2))
                    ++required;
            QVERIFY(required >= 2 * 3 * 2 * 4);
        }
    }

    void tables_and_plots_are_written() {
        const QTemporaryDir folder;
        const std::filesystem::path out = folder.path().toStdString();
        CsvTable table({"name", "value"});
        table.add({"a, \"b\"", cell(0.1)});
        QVERIFY(table.write(out / "table.csv").ok());
        QFile file(folder.filePath("table.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("name,value\n\"a, \"\"b\"\"\",0.1\n"));
        QVERIFY(!table.write(out / "no" / "folder.csv").ok());

        QVERIFY(plot_loop_work(out, measure_loop_work({1.0, 10.0}, {100, 2, 200})).ok());
        QVERIFY(plot_released_handle(out, {{HandleCase{}, HandleResult{}}}).ok());
        for (const char* name : {"loop_work", "released_handle"}) {
            const QImage image(folder.filePath(QStringLiteral("%1.png").arg(name)));
            QCOMPARE(image.size(), QSize(1240, 480));
            QFile svg(folder.filePath(QStringLiteral("%1.svg").arg(name)));
            QVERIFY(svg.open(QIODevice::ReadOnly));
            QVERIFY(svg.readAll().contains("<svg"));
        }
    }
};

QTEST_MAIN(ReportTest)
#include "report_test.moc"
