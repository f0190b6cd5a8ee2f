// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_session.hpp"

#include <QColor>
#include <QPainter>
#include <QPointer>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Draws the lines that are felt, each with an edge so that it stands out on any photograph, and the one
/// under the finger brighter and wider.
class ContoursItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(tp::ExploreSession* session READ session WRITE setSession NOTIFY changed)
    Q_PROPERTY(double pixelsPerMm MEMBER pixels_per_mm_ NOTIFY changed)
    Q_PROPERTY(QColor lineColor MEMBER line_color_ NOTIFY changed)
    Q_PROPERTY(QColor edgeColor MEMBER edge_color_ NOTIFY changed)
    Q_PROPERTY(QColor highlightColor MEMBER highlight_color_ NOTIFY changed)
public:
    explicit ContoursItem(QQuickItem* parent = nullptr);

    ExploreSession* session() const { return session_; }
    void setSession(ExploreSession* session);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QPointer<ExploreSession> session_;
    double pixels_per_mm_ = 1.0;
    QColor line_color_ = Qt::white;
    QColor edge_color_ = Qt::black;
    QColor highlight_color_ = Qt::yellow;
};

} // namespace tp
