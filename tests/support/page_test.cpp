// SPDX-License-Identifier: Apache-2.0
#include "page_test.hpp"

#include <QAccessible>
#include <QString>
#include <QTest>

namespace {

QStringList& heard() {
    static QStringList warnings;
    return warnings;
}

void hear(QtMsgType type, const QMessageLogContext&, const QString& text) {
    // The last two are Qt's own: its timer notices that a busy machine has drawn nothing for a while; the list of its
    // file dialog (no page of ours has one of so many rows) loses its rows while it prepares the next ones.
    const bool of_the_test_machine = text.startsWith("QStandardPaths") || text.startsWith("PulseAudio") ||
                                     text.startsWith("QUnifiedTimer::stopAnimationDriver") ||
                                     text.startsWith("DelegateModel::cancel: index out range");
    if ((type == QtWarningMsg || type == QtCriticalMsg) && !of_the_test_machine)
        heard() << text;
}

} // namespace

const QStringList& PageTest::warnings() { return heard(); }

void PageTest::init() {
    QAccessible::setActive(true);
    heard().clear();
    before_ = qInstallMessageHandler(hear);
}

void PageTest::cleanup() {
    qInstallMessageHandler(before_);
    QCOMPARE(heard().join('\n'), QString());
}

#include "page_test.moc"
