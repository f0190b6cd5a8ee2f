// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/identity_bench.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/plot.hpp"

#include <algorithm>
#include <string>

namespace tp {
namespace {

constexpr double farthest = 1.2;

/// The share of `distances` up to each, percent.
PlotPanel::Line shares(const QString& name, const QColor& colour, std::vector<double> distances,
                       bool dashed) {
    std::ranges::sort(distances);
    PlotPanel::Line line{name, colour, {}, dashed};
    for (std::size_t i = 0; i < distances.size(); ++i)
        line.points.emplace_back(std::min(distances[i], farthest),
                                 100.0 * static_cast<double>(i + 1) / static_cast<double>(distances.size()));
    return line;
}

} // namespace

Result<std::filesystem::path> write_identity_table(const std::filesystem::path& folder,
                                                   const std::vector<IdentityRow>& rows) {
    CsvTable table({"how", "portraits", "found", "unfit", "genuine_pairs", "impostor_pairs", "genuine",
                    "impostor", "equal_error_percent", "true_accepts_percent", "threshold",
                    "both_equal_error_percent"});
    for (const IdentityRow& row : rows)
        table.add({row.how, std::to_string(row.portraits), std::to_string(row.found),
                   std::to_string(row.unfit), std::to_string(row.genuine_pairs),
                   std::to_string(row.impostor_pairs), cell(row.genuine), cell(row.impostor),
                   cell(row.equal_error_percent), cell(row.true_accepts_percent), cell(row.threshold),
                   cell(row.both_equal_error_percent)});
    return table.write(folder / "identity.csv");
}

Result<std::filesystem::path> plot_identity(const std::filesystem::path& folder,
                                            const std::vector<DescribedPortrait>& portraits) {
    PlotPanel panel;
    panel.title = QStringLiteral("One person's pairs; dashed: others'");
    panel.legend_at_bottom = true;
    panel.x = {QStringLiteral("distance"), 0.0, farthest, false};
    panel.y = {QStringLiteral("pairs as near as that or nearer, %"), 0.0, 100.0, false};
    const std::pair<const char*, QColor> drawn[] = {{as_it_is, QColor(20, 120, 200)},
                                                    {"face 40 px", QColor(30, 150, 70)},
                                                    {"turned 60 % rad", QColor(230, 150, 20)},
                                                    {"half covered", QColor(214, 60, 40)}};
    for (const auto& [how, colour] : drawn) {
        std::vector<double> genuine, impostor;
        for (const DescribedPortrait& one : portraits)
            for (const DescribedPortrait& other : portraits)
                if (one.how == as_it_is && other.how == how && one.photo < other.photo && one.found &&
                    other.found)
                    (one.person == other.person ? genuine : impostor)
                        .push_back(distance(one.numbers, other.numbers));
        panel.lines.push_back(shares(QString::fromUtf8(how), colour, std::move(genuine), false));
        panel.lines.push_back(shares({}, colour, std::move(impostor), true));
    }
    return write_plot(folder / "identity", {panel});
}

} // namespace tp
