// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_session.hpp"

#include <QColor>
#include <QPainter>
#include <QPointer>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The contours: those of other features thin, the one in hand with its points. Corners are squares, smooth
/// points discs, controls small rings on a stalk; the point in hand is filled with the highlight.
class MendLinesItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(tp::MendSession* session READ session WRITE setSession NOTIFY changed)
    Q_PROPERTY(QColor lineColor MEMBER line_color_ NOTIFY changed)
    Q_PROPERTY(QColor highlightColor MEMBER highlight_color_ NOTIFY changed)
public:
    explicit MendLinesItem(QQuickItem* parent = nullptr);

    MendSession* session() const { return session_; }
    void setSession(MendSession* session);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    void paint_line(QPainter& painter, const MendContour& contour, const QColor& colour, double width) const;
    void paint_handles(QPainter& painter, const MendContour& contour) const;

    QPointer<MendSession> session_;
    QColor line_color_ = Qt::white;
    QColor highlight_color_ = Qt::yellow;
};

} // namespace tp
