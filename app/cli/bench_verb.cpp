// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/bench/accuracy_bench.hpp"
#include "app/figures/bench/nearest_bench.hpp"
#include "app/figures/report/delivered_force.hpp"
#include "app/figures/report/stability_plots.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"

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
    return {{"machine", machine()}, {"made_by", "TouchPhoto"}, {"rows", list}};
}

void show(const std::vector<BenchRow>& rows) {
    print("%-5s %8s %-10s %-5s %-18s %10s %8s %10s %10s %11s %10s\n", "scene", "segments", "queries", "query",
          "method", "ns median", "x ours", "ns p99.9", "build ms", "KiB", "error mm");
    for (const BenchRow& row : rows) {
        // Ours for the same question.
        const std::string method = row.query == "band" ? "ours" : "ours_any_distance";
        const auto ours = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& it) {
            return it.method == method && it.segments == row.segments && it.queries == row.queries;
        });
        print("%-5s %8zu %-10s %-5s %-18s %10.1f %8.2f %10.1f %10.2f %11.1f %10.2g\n", row.scene.c_str(),
              row.segments, row.queries.c_str(), row.query.c_str(), row.method.c_str(), row.ns_median,
              row.ns_median / ours->ns_median, row.ns_p999, row.build_ms,
              static_cast<double>(row.bytes) / 1024.0, row.max_error_mm);
    }
    print("\nband: is there a line within the band of the default profile (8 mm), and where; the servo asks\n"
          "this at every tick. any: the nearest line at any distance; it asks this 50 times a second where\n"
          "nothing pulls. x ours compares with ours for the same question. One core, one run; %s.\n",
          qPrintable(machine()));
}

void show(const std::vector<AccuracyRow>& rows) {
    print("%-11s %-15s %-16s %10s %6s %8s %10s %11s %11s %11s\n", "scene", "law", "index", "tolerance",
          "facet", "segments", "ns median", "mean N", "p99 N", "max N");
    for (const AccuracyRow& row : rows)
        print("%-11s %-15s %-16s %7.3f mm %5.0f° %8zu %10.1f %11.2e %11.2e %11.2e\n", row.scene.c_str(),
              row.law.c_str(), row.index.c_str(), row.tolerance_mm, row.facet_degrees, row.segments,
              row.ns_median, row.mean_error_n, row.p99_error_n, row.max_error_n);
    print("\nOne core, one run; %s.\n", qPrintable(machine()));
}

QJsonObject json_of(const std::vector<AccuracyRow>& rows, const std::vector<DeliveredRow>& delivered,
                    const std::vector<DeliveredRow>& undamped) {
    QJsonArray accuracy;
    for (const AccuracyRow& row : rows)
        accuracy.append(QJsonObject{{"scene", QString::fromStdString(row.scene)},
                                    {"law", QString::fromStdString(row.law)},
                                    {"index", QString::fromStdString(row.index)},
                                    {"tolerance_mm", row.tolerance_mm},
                                    {"facet_degrees", row.facet_degrees},
                                    {"segments", static_cast<qint64>(row.segments)},
                                    {"ns_median", row.ns_median},
                                    {"mean_error_n", row.mean_error_n},
                                    {"p99_error_n", row.p99_error_n},
                                    {"max_error_n", row.max_error_n},
                                    {"build_ms", row.build_ms}});
    const auto list = [](const std::vector<DeliveredRow>& all) {
        QJsonArray array;
        for (const DeliveredRow& row : all)
            array.append(QJsonObject{{"speed_mm_s", row.speed_mm_s},
                                     {"mean_n", row.mean_n},
                                     {"p99_n", row.p99_n},
                                     {"law_mean_n", row.law_mean_n},
                                     {"law_p99_n", row.law_p99_n},
                                     {"with_jumps_mean_n", row.with_jumps_mean_n},
                                     {"with_jumps_p99_n", row.with_jumps_p99_n},
                                     {"jump_share", row.jump_share},
                                     {"damping_ns_per_m", row.damping_ns_per_m}});
        return array;
    };
    return {{"machine", machine()},
            {"made_by", "TouchPhoto"},
            {"rows", accuracy},
            {"delivered", list(delivered)},
            {"delivered_without_damping", list(undamped)}};
}

void show(const std::vector<DeliveredRow>& rows) {
    print("\nDelivered to a moving finger on the face, mN from the exact force:\n%-14s %10s %8s %8s "
          "%8s %8s %12s %8s\n",
          "device", "speed", "mean", "p99", "law", "law p99", "with jumps", "p99");
    for (const DeliveredRow& row : rows)
        print("%5.2f N·s/m     %5.0f mm/s %8.1f %8.1f %8.1f %8.1f %12.1f %8.0f\n", row.damping_ns_per_m,
              row.speed_mm_s, 1e3 * row.mean_n, 1e3 * row.p99_n, 1e3 * row.law_mean_n, 1e3 * row.law_p99_n,
              1e3 * row.with_jumps_mean_n, 1e3 * row.with_jumps_p99_n);
}

int bench_guidance(const QStringList& words) {
    VerbLine line("bench guidance",
                  "Measures how fast the nearest contour is found on closed curves in 200 x 200 mm, along a\n"
                  "hand's path of 0.1 mm per sample and at random places, beside Boost.Geometry's R-tree,\n"
                  "nanoflann (nearest vertex), a plain loop and the published algorithm.");
    line.output("json", "Where the figures go.", "FILE")
        .option("quick", "Fewer sizes and rounds; ends within 45 s.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    const auto json = line.output_file(line.text("json"));
    if (line.has("json") && !json)
        return refused(json.error());
    const auto rows =
        run_nearest_bench(line.has("quick") ? BenchPlan::quick() : BenchPlan::whole(), say_step);
    show(rows);
    if (!line.has("json"))
        return exit_done;
    const std::string figures = QJsonDocument(json_of(rows)).toJson().toStdString();
    if (const std::string reason = replace_file(*json, figures); !reason.empty())
        return refused("The figures cannot be written: " + reason);
    return exit_done;
}

int bench_accuracy(const QStringList& words) {
    VerbLine line(
        "bench accuracy",
        "Weighs speed against accuracy: time per force and force error against the curves flattened\n"
        "to 1e-6 mm, over flattening tolerance, law and index, on a face, a tactile map and a scene\n"
        "made to be hard. Then what a finger that moves at 5 to 300 mm/s is given, against the exact\n"
        "force. Writes accuracy.csv, accuracy.png, delivered.png and the same as SVG.");
    line.option("out", "Folder for the results; created if it is missing.", "DIR")
        .output("json", "Where the figures go.", "FILE")
        .option("quick", "Fewer tolerances and places, without the map.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("out"))
        return wrong_usage("bench accuracy", "--out DIR is missing.");
    const auto json = line.output_file(line.text("json"));
    if (line.has("json") && !json)
        return refused(json.error());
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
    const double length_mm = line.has("quick") ? 600.0 : 3000.0;
    say_step("what a moving finger is given");
    const TentProfile profile;
    const double held = 1e3 * profile.stiffness * 0.0005; // N·s/m, K T/2 at 1 kHz
    const std::vector<DeliveredRow> delivered = measure_delivered(delivered_speeds(), held, length_mm);
    const std::vector<DeliveredRow> undamped = measure_delivered(delivered_speeds(), 0.0, length_mm);
    std::vector<AccuracyRow> rows;
    for (const AccuracyScene& scene : accuracy_scenes()) {
        if (line.has("quick") && scene.name == "map")
            continue;
        const std::vector<AccuracyRow> its = run_accuracy_bench(scene, plan, say_step);
        rows.insert(rows.end(), its.begin(), its.end());
    }
    const std::filesystem::path out = path_named(folder.path().toStdString());
    std::vector<DeliveredRow> both = delivered;
    both.insert(both.end(), undamped.begin(), undamped.end());
    for (const auto& written :
         {write_accuracy_table(out, rows), plot_accuracy(out, rows), plot_delivered(out, both)})
        if (!written) {
            say_problem(written.error());
            return exit_bad_input;
        }
    show(rows);
    show(both);
    if (!line.has("json"))
        return exit_done;
    const std::string figures = QJsonDocument(json_of(rows, delivered, undamped)).toJson().toStdString();
    if (const std::string reason = replace_file(*json, figures); !reason.empty())
        return refused("The figures cannot be written: " + reason);
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
                  "touchphoto-lab bench accuracy --out DIR [--json FILE] [--quick]\n"
                  "touchphoto-lab bench faces --photos DIR --truth FILE --out DIR [--people FILE]\n"
                  "touchphoto-lab bench faces --wild DIR --out DIR [--only FILE] [--labels FILE]\n"
                  "touchphoto-lab bench faces --identity DIR --out DIR\n"
                  "touchphoto-lab bench touch --out DIR [--people N] [--seed S]");
        return exit_done;
    }
    return wrong_usage("bench", "Say what to measure: guidance, accuracy, faces or touch.");
}

} // namespace tp
