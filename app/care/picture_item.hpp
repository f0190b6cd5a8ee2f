// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QQuickPaintedItem>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// A picture that fills the item, its middle where it has another shape, or as much of the item as shows it `whole`;
/// nothing for a null one, or for no picture at all.
class PictureItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QVariant picture MEMBER picture_ NOTIFY changed)
    Q_PROPERTY(bool whole MEMBER whole_ NOTIFY changed)
public:
    explicit PictureItem(QQuickItem* parent = nullptr);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QVariant picture_; ///< a QImage
    bool whole_ = false;
};

} // namespace tp
