// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/controls/announcer.hpp"

#include <QTimer>

namespace tp {

/// The route through an item: TpNotification binds to it. Qt 6.4 has no announcement event, but a screen
/// reader reads an item of the role Notification when it appears, so the name is set first and the item shown
/// in a later turn of the event loop.
class NotificationAnnouncer final : public Announcer {
    Q_OBJECT
    Q_PROPERTY(QString sentence READ sentence NOTIFY changed)
    Q_PROPERTY(bool shown READ shown NOTIFY changed)
public:
    explicit NotificationAnnouncer(QObject* parent = nullptr);

    void announce(const QString& sentence) override;
    QString sentence() const { return sentence_; }
    bool shown() const { return shown_; }

signals:
    void changed();

private:
    void show(bool shown);

    QString sentence_;
    bool shown_ = false;
    QTimer appear_;
    QTimer vanish_;
};

} // namespace tp
