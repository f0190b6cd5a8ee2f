// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

namespace tp {

/// Says a sentence through the user's screen reader without moving the focus. One implementation a route.
class Announcer : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    /// A newer sentence replaces one that was not read yet.
    virtual void announce(const QString& sentence) = 0;
};

} // namespace tp
