// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/stability_plots.hpp"

#include "app/figures/report/plot.hpp"

#include <algorithm>

namespace tp {

namespace {

const QColor good(20, 120, 200);
const QColor bad(214, 60, 40);

/// `value` times `unit` is drawn, at the axis' lower end where it is below.
PlotPanel loop_panel(const std::vector<LoopWork>& rows, const QString& title, const PlotAxis& y,
                     double LoopWork::*value, double unit = 1.0) {
    PlotPanel panel;
    panel.title = title;
    panel.x = {QStringLiteral("vertex spacing, mm"), 0.5, 10.0, true};
    panel.y = y;
    PlotPanel::Line exact{QStringLiteral("exact law"), good, {}, false};
    PlotPanel::Line published{QStringLiteral("published Algorithm 1"), bad, {}, false};
    for (const LoopWork& row : rows)
        (row.law == "exact" ? exact : published)
            .points.emplace_back(row.vertex_spacing_mm, std::max(unit * row.*value, y.low));
    panel.lines = {exact, published};
    return panel;
}

PlotPanel handle_panel(const std::vector<std::pair<HandleCase, HandleResult>>& rows, const QString& title,
                       bool remedies) {
    PlotPanel panel;
    panel.title = title;
    panel.x = {QStringLiteral("K (T/2 + nT), N·s/m"), 0.01, 10.0, true};
    panel.y = {QStringLiteral("damping of the device b, N·s/m"), 0.015, 3.0, true};
    panel.lines.push_back(
        {QStringLiteral("bound b = K (T/2 + nT)"), QColor(40, 40, 40), {{0.01, 0.01}, {10.0, 10.0}}, true});
    panel.dot_names = {{QStringLiteral("every handle is below 0.1 mm after 6 s"), good},
                       {QStringLiteral("some handle still swings then"), bad}};
    // Cases that differ in mass alone share a place; the worst one decides, and bad dots are drawn last.
    for (const bool settled : {true, false})
        for (const auto& [handle, result] : rows)
            if (handle.law == LawKind::exact && handle.observer == remedies &&
                handle.line_damping == remedies && result.settled == settled)
                panel.dots.push_back({{handle.bound(), handle.damping}, settled ? good : bad, false});
    return panel;
}

} // namespace

Result<std::filesystem::path> plot_loop_work(const std::filesystem::path& folder,
                                             const std::vector<LoopWork>& rows) {
    return write_plot(
        folder / "loop_work",
        {loop_panel(rows, QStringLiteral("Net work round a 3 mm loop"),
                    {QStringLiteral("largest net work, mJ"), 1e-6, 1e2, true}, &LoopWork::max_loop_work_mj),
         loop_panel(rows, QStringLiteral("Force off by more than a tenth of its peak"),
                    {QStringLiteral("share of the places, %"), 0.0, 5.0, false}, &LoopWork::wrong_fraction,
                    100.0)});
}

Result<std::filesystem::path>
plot_released_handle(const std::filesystem::path& folder,
                     const std::vector<std::pair<HandleCase, HandleResult>>& rows) {
    return write_plot(folder / "released_handle",
                      {handle_panel(rows, QStringLiteral("Bare sampled law"), false),
                       handle_panel(rows, QStringLiteral("With energy observer and line damping"), true)});
}

} // namespace tp
