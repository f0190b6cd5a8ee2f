// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_teller.hpp"
#include "app/pages/lab/lab_trace.hpp"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <cstddef>

namespace tp {

/// The ticks of the last ten seconds as plots and as sentences.
class LabMeasurements final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// What each plot shows, as sentences, in the order of Quantity; twice a second.
    Q_PROPERTY(QStringList readings READ readings NOTIFY readingsChanged)
public:
    enum Quantity { Position, Force, Energy, Lateness };
    Q_ENUM(Quantity)

    /// It must outlive the measurements.
    explicit LabMeasurements(LabTeller& teller);

    QStringList readings() const { return readings_; }
    const LabTrace& trace() const { return trace_; }
    Q_INVOKABLE void readPlots();

    /// As LabTrace.
    void begin(double rate, std::size_t delay_ticks) { trace_.begin(rate, delay_ticks); }
    void add(const TickSample& tick) { trace_.add(tick); }
    /// 16 ms have passed: plots and sentences are renewed, each at its own pace.
    void poll();
    /// Both are renewed now.
    void renew();

signals:
    void readingsChanged();
    /// The trace has grown or begun anew.
    void plotted();

private:
    void read_out();

    LabTeller& teller_;
    LabTrace trace_;
    QStringList readings_;
    int polls_ = 0;
};

} // namespace tp
