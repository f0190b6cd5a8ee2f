// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording.hpp"

#include <QTest>

using namespace tp;

class RecordingTest : public QObject {
    Q_OBJECT

private slots:
    void a_kind_is_known_by_its_name() {
        for (const RecordingKind kind : {RecordingKind::memo, RecordingKind::person, RecordingKind::place,
                                         RecordingKind::story, RecordingKind::ambient})
            QVERIFY(recording_kind(name_of(kind)) == kind);
        QVERIFY(!recording_kind("Memo"));
        QVERIFY(!recording_kind(""));
    }
};

QTEST_GUILESS_MAIN(RecordingTest)
#include "recording_test.moc"
