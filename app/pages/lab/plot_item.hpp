// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_measurements.hpp"

#include <QColor>
#include <QPainter>
#include <QPointer>
#include <QQuickPaintedItem>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The last ten seconds of one quantity over time, with axes, their units and the least and most of it. A screen reader
/// has the sentences beside it instead.
class PlotItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(tp::LabMeasurements* measurements READ measurements WRITE setMeasurements NOTIFY changed)
    Q_PROPERTY(tp::LabMeasurements::Quantity quantity MEMBER quantity_ NOTIFY changed)
    Q_PROPERTY(QColor lineColor MEMBER line_color_ NOTIFY changed)
    Q_PROPERTY(QColor secondColor MEMBER second_color_ NOTIFY changed)
    Q_PROPERTY(QColor textColor MEMBER text_color_ NOTIFY changed)
    Q_PROPERTY(QColor gridColor MEMBER grid_color_ NOTIFY changed)
    Q_PROPERTY(double textSize MEMBER text_size_ NOTIFY changed)
public:
    explicit PlotItem(QQuickItem* parent = nullptr);

    LabMeasurements* measurements() const { return measurements_; }
    void setMeasurements(LabMeasurements* measurements);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QPointer<LabMeasurements> measurements_;
    LabMeasurements::Quantity quantity_ = LabMeasurements::Position;
    QColor line_color_ = Qt::white;
    QColor second_color_ = Qt::yellow;
    QColor text_color_ = Qt::white;
    QColor grid_color_ = Qt::gray;
    double text_size_ = 14.0;
};

} // namespace tp
