// SPDX-License-Identifier: Apache-2.0
// What is weighed against time must be weighed rightly. No time is asserted.
#include "app/figures/bench/accuracy_bench.hpp"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

namespace {

AccuracyPlan small_plan() {
    AccuracyPlan plan;
    plan.tolerances_mm = {0.3, 0.03, 0.003};
    plan.truth_mm = 1e-5;
    plan.places = 1000;
    plan.rounds = 2;
    plan.batch_ms = 0.01;
    return plan;
}

const std::vector<AccuracyRow>& face_rows() {
    static const std::vector<AccuracyRow> rows =
        run_accuracy_bench(accuracy_scenes().front(), small_plan(), [](const std::string&) {});
    return rows;
}

std::vector<AccuracyRow> rows_of(const std::string& law, const std::string& index) {
    std::vector<AccuracyRow> rows;
    for (const AccuracyRow& row : face_rows())
        if (row.law == law && row.index == index)
            rows.push_back(row);
    return rows;
}

} // namespace

class AccuracyBenchTest : public QObject {
    Q_OBJECT
private slots:
    void the_exact_laws_error_is_that_of_the_flattening() {
        const auto rows = rows_of("exact", "ours");
        QCOMPARE(rows.size(), std::size_t(4)); // three tolerances, and the usual one with the facet rule
        for (std::size_t i = 0; i < 3; ++i) {
            // Beyond the band's middle the direction, too, turns by no more than the facets do.
            QVERIFY(rows[i].mean_error_n < 0.2 * rows[i].tolerance_mm + 0.02);
            QVERIFY(i == 0 || rows[i].mean_error_n < 0.5 * rows[i - 1].mean_error_n);
            QVERIFY(i == 0 || rows[i].segments > rows[i - 1].segments);
        }
        QVERIFY(rows[3].mean_error_n < 0.005 && rows[3].facet_degrees == 2.0);
    }

    void every_exact_index_has_the_same_error() {
        const auto ours = rows_of("exact", "ours");
        for (const char* index : {"boost_rtree", "plain_loop"}) {
            const auto others = rows_of("exact", index);
            QCOMPARE(others.size(), ours.size());
            for (std::size_t i = 0; i < ours.size(); ++i) {
                QVERIFY(std::abs(others[i].mean_error_n - ours[i].mean_error_n) < 1e-6);
                QVERIFY(std::abs(others[i].p99_error_n - ours[i].p99_error_n) < 1e-6);
            }
        }
    }

    void nearest_vertices_are_farther_off() {
        const auto exact = rows_of("exact", "ours");
        const auto nearest = rows_of("nearest_vertex", "nanoflann");
        for (std::size_t i = 0; i < exact.size(); ++i)
            QVERIFY(nearest[i].mean_error_n > 3.0 * exact[i].mean_error_n);
    }

    void the_published_law_is_nearly_as_good_at_dense_vertices_only() {
        const auto exact = rows_of("exact", "ours");
        for (const char* index : {"published_kdtree", "published_scan"}) {
            const auto published = rows_of("published", index);
            QCOMPARE(published.size(), exact.size());
            for (std::size_t i = 0; i < exact.size(); ++i)
                QVERIFY(published[i].mean_error_n > exact[i].mean_error_n);
            QVERIFY(published[0].mean_error_n > 2.0 * exact[0].mean_error_n);
            QVERIFY(published[0].p99_error_n > 5.0 * exact[0].p99_error_n);
            QVERIFY(published[2].mean_error_n < 2.5 * exact[2].mean_error_n);
            // At the usual tolerance vertices are unevenly spaced: rarely wrong, but then by much.
            QVERIFY(published[3].p99_error_n > 4.0 * exact[3].p99_error_n);
            QVERIFY(published[3].max_error_n > 0.5);
        }
    }

    void the_published_law_fails_at_lines_side_by_side_however_fine_the_curves() {
        AccuracyPlan plan = small_plan();
        plan.tolerances_mm = {0.001};
        const auto scenes = accuracy_scenes();
        QCOMPARE(scenes.back().name, std::string("adversarial"));
        for (const AccuracyRow& row : run_accuracy_bench(scenes.back(), plan, [](const std::string&) {}))
            if (row.law == "exact")
                QVERIFY(row.mean_error_n < 0.002);
            else if (row.law == "published")
                QVERIFY(row.mean_error_n > 0.02 && row.p99_error_n > 0.5);
    }

    void softened_laws_cost_something_but_little() {
        const AccuracyRow exact = rows_of("exact", "ours").back();
        for (const char* law : {"blended", "with_corner_cue"}) {
            const auto rows = rows_of(law, "ours");
            QVERIFY(rows.back().mean_error_n > exact.mean_error_n);
            QVERIFY(rows.back().mean_error_n < 0.02);
        }
    }

    void scenes_are_what_they_say() {
        const auto scenes = accuracy_scenes();
        QCOMPARE(scenes.size(), std::size_t(3));
        std::size_t map = 0;
        for (const Polyline& line : flatten(scenes[1].scene).lines)
            map += line.segment_count();
        QVERIFY2(map > 90'000 && map < 110'000, qPrintable(QString::number(map)));
    }

    void table_and_plot_are_written() {
        const QTemporaryDir folder;
        const std::filesystem::path out = folder.path().toStdString();
        QVERIFY(write_accuracy_table(out, face_rows()).ok());
        QVERIFY(plot_accuracy(out, face_rows()).ok());
        QFile csv(folder.filePath("accuracy.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(face_rows().size() + 1));
        QCOMPARE(lines[0], QByteArray("scene,law,index,tolerance_mm,facet_degrees,segments,ns_median,"
                                      "mean_error_n,p99_error_n,max_error_n,build_ms"));
        QVERIFY(!QImage(folder.filePath("accuracy.png")).isNull());
        QVERIFY(!plot_accuracy(out / "missing", face_rows()).error().empty());
    }
};

QTEST_MAIN(AccuracyBenchTest)
#include "accuracy_bench_test.moc"
