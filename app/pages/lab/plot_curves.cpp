// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/plot_curves.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

const TracePlot& trace_plot(TraceQuantity quantity) {
    using P = TracePoint;
    static const TracePlot position{"mm",
                                    {{"x", [](const P& p) { return p.x; }}, {"y", [](const P& p) { return p.y; }}},
                                    1,
                                    10.0,
                                    false};
    static const TracePlot force{"N", {{"", [](const P& p) { return p.newtons(); }}}, 2, 0.2, true};
    static const TracePlot energy{"mJ", {{"", [](const P& p) { return 1e3 * p.energy; }}}, 2, 0.5, false};
    static const TracePlot lateness{"ms", {{"", [](const P& p) { return 1e3 * p.lateness; }}}, 2, 1.0, true};
    switch (quantity) {
    case TraceQuantity::position: return position;
    case TraceQuantity::force: return force;
    case TraceQuantity::energy: return energy;
    case TraceQuantity::lateness: return lateness;
    }
    return position;
}

LabTrace::Range range_of(const LabTrace& trace, const TracePlot& plot) {
    LabTrace::Range whole = trace.range(plot.curves.front().value);
    for (const TraceCurve& curve : plot.curves) {
        const LabTrace::Range range = trace.range(curve.value);
        whole = {std::min(whole.least, range.least), std::max(whole.most, range.most)};
    }
    return whole;
}

LabTrace::Range axis_for(const LabTrace::Range& range, const TracePlot& plot) {
    LabTrace::Range wanted{plot.from_zero ? 0.0 : range.least, range.most};
    if (const double lacks = plot.least_span - (wanted.most - wanted.least); lacks > 0.0) {
        wanted.most += plot.from_zero ? lacks : 0.5 * lacks;
        wanted.least -= plot.from_zero ? 0.0 : 0.5 * lacks;
    }
    const double span = wanted.most - wanted.least;
    const double power = std::pow(10.0, std::floor(std::log10(span)));
    const double step = (span / power > 5.0 ? 1.0 : span / power > 2.0 ? 0.5 : 0.2) * power;
    return {step * std::floor(wanted.least / step), step * std::ceil(wanted.most / step)};
}

std::vector<CurveColumn> columns_of(const LabTrace& trace, const TraceCurve& curve, int columns) {
    std::vector<CurveColumn> reduced;
    if (trace.points().empty() || columns <= 0)
        return reduced;
    const double right = std::max(LabTrace::longest, trace.points().back().time);
    for (const TracePoint& point : trace.points()) {
        const double share = (point.time - (right - LabTrace::longest)) / LabTrace::longest;
        const int column = std::clamp(static_cast<int>(share * columns), 0, columns - 1);
        const double value = curve.value(point);
        if (reduced.empty() || reduced.back().column != column)
            reduced.push_back({column, value, value});
        CurveColumn& last = reduced.back();
        last.least = std::min(last.least, value);
        last.most = std::max(last.most, value);
    }
    return reduced;
}

} // namespace tp
