// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_session.hpp"

#include <QPainter>
#include <QPointer>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The part of the photograph that is seen, and over it, where that is wanted, the force field.
class MendPictureItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(tp::MendSession* session READ session WRITE setSession NOTIFY changed)
public:
    using QQuickPaintedItem::QQuickPaintedItem;

    MendSession* session() const { return session_; }
    void setSession(MendSession* session);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QPointer<MendSession> session_;
};

} // namespace tp
