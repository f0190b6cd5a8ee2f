// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/bench/accuracy_bench.hpp"
#include "app/figures/bench/nearest_bench.hpp"
#include "core/files/durable_file.hpp"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tp {

namespace {

QString machine() {
    QString processor = QSysInfo::currentCpuArchitecture();
    QFile about(QStringLiteral("/proc/cpuinfo"));
    if (about.open(QIODevice::ReadOnly))
        for (const QByteArray& line : about.readAll().split('\n'))
            if (line.startsWith("model name")) {
                processor = QString::fromUtf8(line.mid(line.indexOf(':') + 1)).simplified();
                break;
            }
    return processor + QStringLiteral(", ") + QSysInfo::prettyProductName();
}

QJsonValue finite(double value) { return std::isfinite(value) ? QJsonValue(value) : QJsonValue(); }

QJsonObject json_of(const std::vector<BenchRow>& rows) {
    QJsonArray list;
    for (const BenchRow& row : rows)
        list.append(QJsonObject{{"scene", QString::fromStdString(row.scene)},
                                {"segments", static_cast<qint64>(row.segments)},
                                {"queries", QString::fromStdString(row.queries)},
                                {"query", QString::fromStdString(row.query)},
                                {"method", QString::fromStdString(row.method)},
                                {"ns_median", row.ns_median},
                                {"ns_p999", row.ns_p999},
                                {"build_ms", row.build_ms},
                                {"bytes", static_cast<qint64>(row.bytes)},
                                {"max_error_mm", finite(row.max_error_mm)}});
    return {{"machine", machine()}, {"rows", list}};
}

void print(const std::vector<BenchRow>& rows) {
    std::printf("%-5s %8s %-10s %-5s %-18s %10s %8s %10s %10s %11s %10s\n", "scene", "segments", "queries",
                "query", "method", "ns median", "x ours", "ns p99.9", "build ms", "KiB", "error mm");
    for (const BenchRow& row : rows) {
        // Ours for the same question.
        const std::string method = row.query == "band" ? "ours" : "ours_any_distance";
        const auto ours = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& it) {
            return it.method == method && it.segments == row.segments && it.queries == row.queries;
        });
        std::printf("%-5s %8zu %-10s %-5s %-18s %10.1f %8.2f %10.1f %10.2f %11.1f %10.2g\n",
                    row.scene.c_str(), row.segments, row.queries.c_str(), row.query.c_str(),
                    row.method.c_str(), row.ns_median, row.ns_median / ours->ns_median, row.ns_p999,
                    row.build_ms, static_cast<double>(row.bytes) / 1024.0, row.max_error_mm);
    }
    std::printf(
        "\nband: is there a line within the band of the default profile (8 mm), and where; the servo asks\n"
        "this at every tick. any: the nearest line at any distance; it asks this 50 times a second where\n"
        "nothing pulls. x ours compares with ours for the same question. One core, one run; %s.\n",
        qPrintable(machine()));
}

void print(const std::vector<AccuracyRow>& rows) {
    std::printf("%-11s %-15s %-16s %10s %6s %8s %10s %11s %11s %11s\n", "scene", "law", "index", "tolerance",
                "facet", "segments", "ns median", "mean N", "p99 N", "max N");
    for (const AccuracyRow& row : rows)
        std::printf("%-11s %-15s %-16s %7.3f mm %5.0f° %8zu %10.1f %11.2e %11.2e %11.2e\n", row.scene.c_str(),
                    row.law.c_str(), row.index.c_str(), row.tolerance_mm, row.facet_degrees, row.segments,
                    row.ns_median, row.mean_error_n, row.p99_error_n, row.max_error_n);
    std::printf("\nOne core, one run; %s.\n", qPrintable(machine()));
}

int bench_guidance(const QStringList& words) {
    VerbLine line("bench guidance",
                  "Measures how fast the nearest contour is found on closed curves in 200 x 200 mm, along a\n"
                  "hand's path of 0.1 mm per sample and at random places, beside Boost.Geometry's R-tree,\n"
                  "nanoflann (nearest vertex), a plain loop and the published algorithm.");
    line.option("json", "Where the figures go.", "FILE")
        .option("quick", "Fewer sizes and rounds; ends within 45 s.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    const auto rows = run_nearest_bench(line.has("quick") ? BenchPlan::quick() : BenchPlan::whole(), say_step);
    print(rows);
    if (!line.has("json"))
        return exit_done;
    const std::string figures = QJsonDocument(json_of(rows)).toJson().toStdString();
    if (const std::string reason = replace_file(line.text("json").toStdString(), figures); !reason.empty())
        return refused("The figures cannot be written: " + reason);
    return exit_done;
}

int bench_accuracy(const QStringList& words) {
    VerbLine line(
        "bench accuracy",
        "Weighs speed against accuracy: time per force and force error against the curves flattened\n"
        "to 1e-6 mm, over flattening tolerance, law and index, on a face, a tactile map and a scene\n"
        "made to be hard. Writes accuracy.csv, accuracy.png and accuracy.svg.");
    line.option("out", "Folder for the results; created if it is missing.", "DIR")
        .option("quick", "Fewer tolerances and places, without the map.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("out"))
        return wrong_usage("bench accuracy", "--out DIR is missing.");
    const QDir folder(line.text("out"));
    if (const std::string problem = line.make_folder("out"); !problem.empty()) {
        say_problem(problem);
        return exit_bad_input;
    }
    AccuracyPlan plan;
    if (line.has("quick")) {
        plan.tolerances_mm = {0.3, 0.03, 0.003};
        plan.places = 3000;
    }
    std::vector<AccuracyRow> rows;
    for (const AccuracyScene& scene : accuracy_scenes()) {
        if (line.has("quick") && scene.name == "map")
            continue;
        const std::vector<AccuracyRow> its = run_accuracy_bench(scene, plan, say_step);
        rows.insert(rows.end(), its.begin(), its.end());
    }
    const std::filesystem::path out = folder.path().toStdString();
    for (const auto& written : {write_accuracy_table(out, rows), plot_accuracy(out, rows)})
        if (!written) {
            say_problem(written.error());
            return exit_bad_input;
        }
    print(rows);
    return exit_done;
}

} // namespace

int bench_verb(const QStringList& words) {
    const QString what = words.isEmpty() ? QString() : words.first();
    if (what == QLatin1String("guidance"))
        return bench_guidance(words.mid(1));
    if (what == QLatin1String("accuracy"))
        return bench_accuracy(words.mid(1));
    if (what == QLatin1String("faces"))
        return bench_faces_verb(words.mid(1));
    if (what == QLatin1String("touch"))
        return bench_touch_verb(words.mid(1));
    if (what == QLatin1String("--help") || what == QLatin1String("-h")) {
        std::puts("touchphoto-lab bench guidance [--json FILE] [--quick]\n"
                  "touchphoto-lab bench accuracy --out DIR [--quick]\n"
                  "touchphoto-lab bench faces --photos DIR --truth FILE --out DIR [--people FILE]\n"
                  "touchphoto-lab bench faces --wild DIR --out DIR [--only FILE] [--labels FILE]\n"
                  "touchphoto-lab bench faces --identity DIR --out DIR\n"
                  "touchphoto-lab bench touch --out DIR [--people N] [--seed S]");
        return exit_done;
    }
    return wrong_usage("bench", "Say what to measure: guidance, accuracy, faces or touch.");
}

} // namespace tp
