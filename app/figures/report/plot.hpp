// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"

#include <QColor>
#include <QRectF>
#include <QString>

#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

class QPainter;

namespace tp {

/// One axis: what it shows, with its unit, and from where to where.
struct PlotAxis {
    QString label;
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;                        ///< low > 0
    std::vector<std::pair<double, QString>> names{}; ///< in place of numbers at the ticks; empty: numbers
};

/// One panel of a plot: axes with ticks, lines and dots in data coordinates, a legend.
struct PlotPanel {
    struct Line {
        QString name; ///< in the legend; empty: not there
        QColor colour;
        std::vector<Vec2> points;
        bool dashed = false;
    };
    struct Dot {
        Vec2 place;
        QColor colour;
        bool hollow = false;
    };
    struct DotName {
        QString name;
        QColor colour;
        bool hollow = false;
    };
    struct Text {
        Vec2 place; ///< its lower middle
        QString words;
    };
    QString title;
    QString note; ///< under the title: what bars and dots mean; empty: nothing
    PlotAxis x;
    PlotAxis y;
    std::vector<Line> lines;
    std::vector<Dot> dots;
    std::vector<Text> texts;
    std::vector<DotName> dot_names; ///< legend of the dots
    bool legend_at_bottom = false;  ///< else at the top
};

/// Draws the panels side by side to FILE.png and FILE.svg (`stem` without an ending).
Result<std::filesystem::path> write_plot(const std::filesystem::path& stem,
                                         const std::vector<PlotPanel>& panels);

} // namespace tp
