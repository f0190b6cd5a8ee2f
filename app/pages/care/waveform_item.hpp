// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QList>
#include <QPainter>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The loudness of a recording from left to right; what lies outside of `from` … `to` (0–1) is drawn dimly.
class WaveformItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QList<float> peaks MEMBER peaks_ NOTIFY changed) ///< 0–1
    Q_PROPERTY(double from MEMBER from_ NOTIFY changed)
    Q_PROPERTY(double to MEMBER to_ NOTIFY changed)
    Q_PROPERTY(QColor color MEMBER color_ NOTIFY changed)
    Q_PROPERTY(QColor dimColor MEMBER dim_color_ NOTIFY changed)
public:
    explicit WaveformItem(QQuickItem* parent = nullptr);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QList<float> peaks_;
    double from_ = 0.0, to_ = 1.0;
    QColor color_ = Qt::white, dim_color_ = Qt::gray;
};

} // namespace tp
