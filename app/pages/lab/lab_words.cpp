// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_words.hpp"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace tp {

namespace {

struct LabWords {
    Q_DECLARE_TR_FUNCTIONS(LabWords)
};

QString nothing_yet(TraceQuantity quantity) {
    switch (quantity) {
    case TraceQuantity::position:
        return LabWords::tr("Position: nothing measured yet.");
    case TraceQuantity::force:
        return LabWords::tr("Force |F|: nothing measured yet.");
    case TraceQuantity::energy:
        return LabWords::tr("Energy: nothing measured yet.");
    case TraceQuantity::lateness:
        break;
    }
    return LabWords::tr("Lateness: nothing measured yet.");
}

} // namespace

QString parameter_words(const QString& key, double value) {
    const QLocale locale;
    const auto number = [&](int decimals) { return locale.toString(value, 'f', decimals); };
    if (key == "stiffness" || key == "handStiffness")
        return LabWords::tr("%1 newtons per millimetre").arg(number(2));
    if (key == "maxForce")
        return LabWords::tr("%1 newtons").arg(number(1));
    if (key == "friction")
        return LabWords::tr("%1 newtons").arg(number(2));
    if (key == "damping" || key == "handDamping")
        return LabWords::tr("%1 newton seconds per metre").arg(number(1));
    if (key == "mass")
        return LabWords::tr("%1 grams").arg(locale.toString(1000.0 * value, 'f', 0));
    if (key == "delay")
        return LabWords::tr("%n tick(s)", nullptr, qRound(value));
    if (key == "drop")
        return LabWords::tr("%1 percent").arg(locale.toString(100.0 * value, 'f', 0));
    if (key == "lineDamping")
        return LabWords::tr("%1 of critical damping").arg(number(1));
    return LabWords::tr("%1 millimetres").arg(number(key == "quantum" ? 2 : 1));
}

QString middle_words(Vec2 place) {
    const QLocale locale;
    const auto mm = [&](double value) { return locale.toString(std::abs(value), 'f', 1); };
    return LabWords::tr("%1, %2 of the middle")
        .arg(place.x < 0.0 ? LabWords::tr("%1 mm left").arg(mm(place.x))
                           : LabWords::tr("%1 mm right").arg(mm(place.x)),
             place.y < 0.0 ? LabWords::tr("%1 mm below").arg(mm(place.y))
                           : LabWords::tr("%1 mm above").arg(mm(place.y)));
}

QString plot_words(const LabTrace& trace, TraceQuantity quantity) {
    if (trace.points().empty())
        return nothing_yet(quantity);
    const QLocale locale;
    const TracePlot& plot = trace_plot(quantity);
    const auto number = [&](double value) { return locale.toString(value, 'f', plot.decimals); };
    const TracePoint& last = trace.points().back();
    if (quantity == TraceQuantity::position) {
        const LabTrace::Range x = trace.range(plot.curves[0].value);
        const LabTrace::Range y = trace.range(plot.curves[1].value);
        return LabWords::tr("Position now x %1, y %2 mm; x from %3 to %4, y from %5 to %6.")
            .arg(number(last.x), number(last.y), number(x.least), number(x.most), number(y.least),
                 number(y.most));
    }
    const LabTrace::Range range = range_of(trace, plot);
    const QString now = number(plot.curves[0].value(last));
    if (quantity == TraceQuantity::force)
        return LabWords::tr("Force |F| now %1 newtons, at most %2.").arg(now, number(range.most));
    if (quantity == TraceQuantity::energy)
        return LabWords::tr("Energy given to the hand now %1 millijoules, from %2 to %3.")
            .arg(now, number(range.least), number(range.most));
    return LabWords::tr("Ticks late by now %1 milliseconds, at most %2.").arg(now, number(range.most));
}

QString replay_words(const LabReplay& replay) {
    const QString words =
        replay.setup ? LabWords::tr("Computed again, the forces differ by at most %1 newtons.")
                           .arg(QLocale().toString(replay.greatest_difference, 'g', 2))
                     : LabWords::tr("Its parameters are not beside it, so it was not computed again.");
    return replay.bytes_left > 0 ? words + ' ' + LabWords::tr("Its end was cut short and is left out.")
                                 : words;
}

} // namespace tp
