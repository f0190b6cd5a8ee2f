// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording.hpp"
#include "test_program.hpp"

#include <QTest>

namespace recording_test {

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

} // namespace recording_test

TP_TEST(recording_test, RecordingTest, event_loop)
#include "recording_test.moc"
