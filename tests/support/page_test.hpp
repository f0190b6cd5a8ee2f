// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <QtGlobal>

/// A test of pages, as a screen reader finds them. Each of its functions fails where Qt warns meanwhile, of QML's faults
/// above all. It may have an initTestCase(), but no init() and no cleanup().
class PageTest : public QObject {
    Q_OBJECT
protected:
    /// What Qt has warned of since this function of the test began.
    static const QStringList& warnings();

private slots:
    void init();
    void cleanup();

private:
    QtMessageHandler before_ = nullptr; ///< Qt Test's own
};
