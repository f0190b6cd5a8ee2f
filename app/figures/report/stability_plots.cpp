// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/stability_plots.hpp"

#include "app/figures/report/plot.hpp"

#include <algorithm>
#include <utility>

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
    panel.dot_names = {{QStringLiteral("every handle rests after 12 s"), good},
                       {QStringLiteral("some handle still moves then"), bad}};
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

Result<std::filesystem::path> plot_passivity(const std::filesystem::path& folder,
                                             const std::vector<PassivityRow>& rows) {
    struct Part {
        const char* part;
        QString name;
        QColor colour;
    };
    const std::vector<Part> parts{{"law", QStringLiteral("bare law"), bad},
                                  {"line_damping", QStringLiteral("with line damping"), QColor(230, 150, 20)},
                                  {"observer", QStringLiteral("with energy observer"), QColor(30, 150, 70)},
                                  {"all", QStringLiteral("with both"), good}};
    std::vector<PlotPanel> panels;
    for (const double delay_ms : {1.0, 4.0}) {
        PlotPanel panel;
        panel.title = QStringLiteral("Driven 1 mm about the line, delay %1 ms: below 0 the hand is damped")
                          .arg(delay_ms);
        panel.x = {QStringLiteral("frequency, Hz"), 1.0, 100.0, true};
        panel.y = {QStringLiteral("work into the hand in a cycle, mJ"), -0.8, 0.8, false};
        for (const Part& part : parts) {
            PlotPanel::Line line{part.name, part.colour, {}, false};
            for (const PassivityRow& row : rows)
                if (row.delay_ms == delay_ms && row.part == part.part)
                    line.points.emplace_back(row.frequency_hz,
                                             std::clamp(row.work_mj, panel.y.low, panel.y.high));
            panel.lines.push_back(std::move(line));
        }
        panels.push_back(std::move(panel));
    }
    return write_plot(folder / "passivity", panels);
}

Result<std::filesystem::path> plot_delivered(const std::filesystem::path& folder,
                                             const std::vector<DeliveredRow>& rows) {
    PlotPanel mean;
    mean.title = QStringLiteral("What a moving finger is given, against the exact force");
    mean.x = {QStringLiteral("speed of the finger, mm/s"), 5.0, 300.0, true};
    mean.y = {QStringLiteral("mean error of the force, mN"), 0.0, 40.0, false};
    PlotPanel p99 = mean;
    p99.title = QStringLiteral("One tick in a hundred is worse than");
    p99.y = {QStringLiteral("p99 of the error, mN"), 0.0, 120.0, false};
    const std::vector<QColor> colours{good, bad, QColor(230, 150, 20), QColor(30, 150, 70)};
    std::vector<double> dampings;
    for (const DeliveredRow& row : rows)
        if (std::find(dampings.begin(), dampings.end(), row.damping_ns_per_m) == dampings.end())
            dampings.push_back(row.damping_ns_per_m);
    PlotPanel::Line law{QStringLiteral("the law's own"), QColor(120, 120, 130), {}, true};
    PlotPanel::Line law_p99 = law;
    for (std::size_t i = 0; i < dampings.size(); ++i) {
        const QString name = dampings[i] > 0.0 ? QStringLiteral("device of %1 N·s/m").arg(dampings[i])
                                               : QStringLiteral("device that tells of no damping");
        PlotPanel::Line line{name, colours[i % colours.size()], {}, false};
        PlotPanel::Line line_p99 = line;
        for (const DeliveredRow& row : rows)
            if (row.damping_ns_per_m == dampings[i]) {
                line.points.emplace_back(row.speed_mm_s, std::min(1e3 * row.mean_n, mean.y.high));
                line_p99.points.emplace_back(row.speed_mm_s, std::min(1e3 * row.p99_n, p99.y.high));
                if (i == 0) {
                    law.points.emplace_back(row.speed_mm_s, 1e3 * row.law_mean_n);
                    law_p99.points.emplace_back(row.speed_mm_s, 1e3 * row.law_p99_n);
                }
            }
        mean.lines.push_back(std::move(line));
        p99.lines.push_back(std::move(line_p99));
    }
    mean.lines.push_back(std::move(law));
    p99.lines.push_back(std::move(law_p99));
    return write_plot(folder / "delivered", {mean, p99});
}

} // namespace tp
