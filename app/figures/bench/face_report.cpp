// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/face_bench.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/plot.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

Result<std::filesystem::path> write_face_table(const std::filesystem::path& folder,
                                               const std::vector<FaceBenchRow>& rows) {
    CsvTable table({"contender", "longest_px", "photos", "failures", "decode_ms", "detect_ms", "landmarks_ms",
                    "edges_ms", "contours_ms", "eyes_percent", "outer_lip_percent", "inner_lip_percent",
                    "outline_percent", "worst_percent"});
    for (const FaceBenchRow& row : rows)
        table.add({row.contender, std::to_string(row.longest_px), std::to_string(row.photos),
                   std::to_string(row.failures), cell(row.decode_ms), cell(row.detect_ms),
                   cell(row.landmarks_ms), cell(row.edges_ms), cell(row.contours_ms),
                   cell(row.error_percent[0]), cell(row.error_percent[1]), cell(row.error_percent[2]),
                   cell(row.error_percent[3]), cell(row.worst_percent)});
    return table.write(folder / "faces.csv");
}

Result<std::filesystem::path> write_harder_table(const std::filesystem::path& folder,
                                                 const std::vector<HarderRow>& rows) {
    CsvTable table({"how", "contender", "photos", "found", "failures", "said", "eyes_percent",
                    "outer_lip_percent", "inner_lip_percent", "outline_percent"});
    for (const HarderRow& row : rows)
        table.add({row.how, row.contender, std::to_string(row.photos), std::to_string(row.found),
                   std::to_string(row.failures), std::to_string(row.said), cell(row.error_percent[0]),
                   cell(row.error_percent[1]), cell(row.error_percent[2]), cell(row.error_percent[3])});
    return table.write(folder / "harder.csv");
}

Result<std::filesystem::path> plot_faces(const std::filesystem::path& folder,
                                         const std::vector<FaceBenchRow>& rows) {
    const QColor colours[] = {QColor(20, 120, 200), QColor(120, 120, 130), QColor(30, 150, 70),
                              QColor(214, 60, 40),  QColor(230, 150, 20),  QColor(130, 70, 170),
                              QColor(0, 150, 160),  QColor(150, 100, 50),  QColor(90, 90, 20),
                              QColor(200, 80, 140)};
    PlotPanel panel;
    panel.title = QStringLiteral("Faces: lower left is better");
    panel.x = {QStringLiteral("time per photograph without decoding, ms"), 3.0, 300.0, true};
    panel.y = {QStringLiteral("mean error of all features, % of the eyes' distance"), 0.0, 3.0, false};
    for (const FaceBenchRow& row : rows) {
        const QString name = QString::fromStdString(row.contender);
        if (panel.lines.empty() || panel.lines.back().name != name) // rows come contender by contender
            panel.lines.push_back({name, colours[panel.lines.size() % std::size(colours)], {}, false});
        if (!std::isfinite(row.mean_error_percent())) // no face was found
            continue;
        PlotPanel::Line& line = panel.lines.back();
        const Vec2 place(std::clamp(row.without_decoding_ms(), panel.x.low, panel.x.high),
                         std::min(row.mean_error_percent(), panel.y.high));
        line.points.push_back(place);
        panel.dots.push_back({place, line.colour, row.longest_px > 0});
    }
    panel.dot_names = {{QStringLiteral("the pictures as they are; hollow: scaled down"), QColor(30, 30, 36)}};
    return write_plot(folder / "faces", {panel});
}

} // namespace tp
