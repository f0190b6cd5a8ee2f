// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_run.hpp"

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QPointer>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What a trial puts before the finger, and the finger, for a researcher who tries an experiment out. Draws nothing in a sitting.
class ShownSceneItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(tp::StudyRun* run READ run WRITE setRun NOTIFY changed)
    Q_PROPERTY(double pixelsPerMm MEMBER pixels_per_mm_ NOTIFY changed)
    Q_PROPERTY(QColor lineColor MEMBER line_color_ NOTIFY changed)
    Q_PROPERTY(QColor fingerColor MEMBER finger_color_ NOTIFY changed)
public:
    explicit ShownSceneItem(QQuickItem* parent = nullptr);

    StudyRun* run() const { return run_; }
    void setRun(StudyRun* run);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QPointF on_item(Vec2 place) const;

    QPointer<StudyRun> run_;
    double pixels_per_mm_ = 1.0;
    QColor line_color_ = Qt::white;
    QColor finger_color_ = Qt::yellow;
};

} // namespace tp
