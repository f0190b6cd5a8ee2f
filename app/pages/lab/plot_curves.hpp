// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_trace.hpp"

#include <vector>

namespace tp {

/// What a plot can show of a trace.
enum class TraceQuantity { position, force, energy, lateness };

/// One line of a plot: a value of each point, in the unit in which it is shown.
struct TraceCurve {
    const char* name; ///< as on the plot; empty where there is only one
    double (*value)(const TracePoint&);
};
struct TracePlot {
    const char* unit;
    std::vector<TraceCurve> curves;
    int decimals;          ///< of what is written beside it
    double least_span;     ///< the vertical axis covers at least this, so that noise is not blown up
    bool from_zero;        ///< the axis begins at zero
};
const TracePlot& trace_plot(TraceQuantity quantity);

/// Least and most over all curves of a plot.
LabTrace::Range range_of(const LabTrace& trace, const TracePlot& plot);

/// Bounds of the vertical axis: round numbers round a range.
LabTrace::Range axis_for(const LabTrace::Range& range, const TracePlot& plot);

/// A curve reduced to its least and most in each of `columns` equal stretches of the last ten seconds; what has no point
/// is left out.
struct CurveColumn {
    int column;
    double least, most;
};
std::vector<CurveColumn> columns_of(const LabTrace& trace, const TraceCurve& curve, int columns);

} // namespace tp
