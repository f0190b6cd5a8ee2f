// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QPoint>
#include <QRect>
#include <QRgb>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace tp::testing {

/// Of an sRGB colour, 0–1 (WCAG 2.1, "relative luminance"; with the threshold of IEC 61966-2-1).
inline double relative_luminance(QRgb colour) {
    const auto linear = [](int channel) {
        const double c = channel / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

/// 1–21, whichever is the lighter (WCAG 2.1, "contrast ratio").
inline double contrast_ratio(QRgb one, QRgb other) {
    const double a = relative_luminance(one), b = relative_luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// What is drawn on what, within a part of a picture.
struct DrawnContrast {
    double ratio = 1.0;
    QRgb foreground = 0, background = 0;
};

/// The commonest colour is the background; the foreground is that of the strokes' cores, which hold the 1 % of the pixels
/// that stand out most (the rest of a stroke is blended with the background). All of it within the picture; empty: 1.
inline DrawnContrast drawn_contrast(const QImage& picture, const QRect& part) {
    const QRect inside = part & picture.rect();
    std::map<QRgb, int> colours;
    for (int y = inside.top(); y <= inside.bottom(); ++y)
        for (int x = inside.left(); x <= inside.right(); ++x)
            ++colours[picture.pixel(x, y)];
    if (colours.empty())
        return {};
    DrawnContrast drawn;
    drawn.background = std::max_element(colours.begin(), colours.end(), [](const auto& a, const auto& b) {
                           return a.second < b.second;
                       })->first;
    std::multimap<double, std::pair<QRgb, int>, std::greater<>> by_ratio;
    for (const auto& [colour, count] : colours)
        by_ratio.emplace(contrast_ratio(colour, drawn.background), std::pair(colour, count));
    int left = std::max(4, inside.width() * inside.height() / 100);
    for (const auto& [ratio, colour] : by_ratio) {
        drawn.ratio = ratio;
        drawn.foreground = colour.first;
        if ((left -= colour.second) <= 0)
            break;
    }
    return drawn;
}

/// From a frame's edge inwards, in px; below 0: outwards.
struct Depth {
    int from, to;
};

/// Along the sides of a frame, between the drawn edge, which lies somewhere in `edge` (a place that is no whole pixel is
/// drawn a little off), and what lies in `beside`: the contrast that nine of ten places of the weakest side reach. A place
/// outside of the picture counts as 1: the frame is cut off there.
inline double edge_contrast(const QImage& picture, const QRect& frame, Depth edge, Depth beside, int corner) {
    const auto at_place = [&](QPoint at, QPoint inwards) {
        double best = 1.0;
        for (int i = edge.from; i <= edge.to; ++i)
            for (int j = beside.from; j <= beside.to; ++j)
                if (const QPoint a = at + i * inwards, b = at + j * inwards; picture.rect().contains(a) && picture.rect().contains(b))
                    best = std::max(best, contrast_ratio(picture.pixel(a), picture.pixel(b)));
        return best;
    };
    const auto along = [&](QPoint from, QPoint to, QPoint step, QPoint inwards) {
        std::vector<double> ratios;
        for (QPoint at = from; at.x() <= to.x() && at.y() <= to.y(); at += step)
            ratios.push_back(at_place(at, inwards));
        if (ratios.empty())
            return 1.0;
        const auto tenth = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 10);
        std::nth_element(ratios.begin(), tenth, ratios.end());
        return *tenth;
    };
    const QPoint across(corner, 0), down(0, corner);
    return std::min({along(frame.topLeft() + across, frame.topRight() - across, {2, 0}, {0, 1}),
                     along(frame.bottomLeft() + across, frame.bottomRight() - across, {2, 0}, {0, -1}),
                     along(frame.topLeft() + down, frame.bottomLeft() - down, {0, 2}, {1, 0}),
                     along(frame.topRight() + down, frame.bottomRight() - down, {0, 2}, {-1, 0})});
}

} // namespace tp::testing
