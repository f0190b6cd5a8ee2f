// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/accuracy_bench.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/plot.hpp"

#include <algorithm>

namespace tp {

namespace {

struct Method {
    const char* law;
    const char* index;
    const char* name;
    QColor colour;
    bool dashed;
};

const std::vector<Method>& methods() {
    static const std::vector<Method> all{
        {"exact", "ours", "exact law, our index", QColor(20, 120, 200), false},
        {"exact", "boost_rtree", "exact law, Boost R-tree", QColor(30, 150, 70), false},
        {"exact", "plain_loop", "exact law, every segment", QColor(120, 120, 130), false},
        {"blended", "ours", "exact law blended over 0.4 mm", QColor(20, 120, 200), true},
        {"nearest_vertex", "nanoflann", "nearest vertex, nanoflann", QColor(230, 150, 20), false},
        {"published", "published_kdtree", "published Algorithm 1, k-d tree", QColor(214, 60, 40), false},
        {"published", "published_scan", "published Algorithm 1 as listed", QColor(214, 60, 40), true},
    };
    return all;
}

QString title_of(const std::string& scene) {
    if (scene == "face")
        return QStringLiteral("A face");
    if (scene == "map")
        return QStringLiteral("A tactile map");
    return QStringLiteral("A scene made to be hard");
}

PlotPanel panel_of(const std::string& scene, const std::vector<AccuracyRow>& rows) {
    PlotPanel panel;
    panel.title = title_of(scene) + QStringLiteral(": lower left is better");
    panel.x = {QStringLiteral("time per force, ns"), 5.0, 5e5, true};
    panel.y = {QStringLiteral("mean force error, N"), 1e-7, 1.0, true};
    panel.legend_at_bottom = true;
    for (const Method& method : methods()) {
        PlotPanel::Line line{QString::fromUtf8(method.name), method.colour, {}, method.dashed};
        for (const AccuracyRow& row : rows) {
            if (row.scene != scene || row.law != method.law || row.index != method.index)
                continue;
            const Vec2 place(row.ns_median, std::max(row.mean_error_n, panel.y.low));
            const bool usual = row.facet_degrees < 90.0;
            panel.dots.push_back({place, method.colour, !usual});
            if (!usual)
                line.points.push_back(place);
            else
                panel.lines.push_back(
                    {QString(), method.colour, {place, Vec2(place.x, std::max(row.p99_error_n, place.y))}});
        }
        if (!line.points.empty())
            panel.lines.push_back(std::move(line));
    }
    const QColor dark(30, 30, 36);
    panel.lines.push_back({QStringLiteral("upright: from the mean up to the 99th percentile"), dark, {}});
    panel.dot_names = {{QStringLiteral("the usual tolerance: 0.01 mm and 2°"), dark}};
    return panel;
}

} // namespace

Result<std::filesystem::path> write_accuracy_table(const std::filesystem::path& folder,
                                                   const std::vector<AccuracyRow>& rows) {
    CsvTable table({"scene", "law", "index", "tolerance_mm", "facet_degrees", "segments", "ns_median",
                    "mean_error_n", "p99_error_n", "max_error_n", "build_ms"});
    for (const AccuracyRow& row : rows)
        table.add({row.scene, row.law, row.index, cell(row.tolerance_mm), cell(row.facet_degrees),
                   std::to_string(row.segments), cell(row.ns_median), cell(row.mean_error_n),
                   cell(row.p99_error_n), cell(row.max_error_n), cell(row.build_ms)});
    return table.write(folder / "accuracy.csv");
}

Result<std::filesystem::path> plot_accuracy(const std::filesystem::path& folder,
                                            const std::vector<AccuracyRow>& rows) {
    std::vector<std::string> scenes;
    for (const AccuracyRow& row : rows)
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end())
            scenes.push_back(row.scene);
    std::vector<PlotPanel> panels;
    for (const std::string& scene : scenes)
        panels.push_back(panel_of(scene, rows));
    return write_plot(folder / "accuracy", panels);
}

} // namespace tp
