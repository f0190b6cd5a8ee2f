// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/notification_announcer.hpp"

#include <QSignalSpy>
#include <QTest>

using namespace tp;

class AnnouncerTest : public QObject {
    Q_OBJECT
private slots:
    void the_name_is_there_before_the_item_appears() {
        NotificationAnnouncer announcer;
        announcer.announce("One face.");
        QCOMPARE(announcer.sentence(), QString("One face."));
        QVERIFY(!announcer.shown());
        QTRY_VERIFY(announcer.shown());
    }

    void the_same_sentence_again_appears_again() {
        NotificationAnnouncer announcer;
        announcer.announce("left eye");
        QTRY_VERIFY(announcer.shown());
        announcer.announce("left eye");
        QVERIFY(!announcer.shown());
        QTRY_VERIFY(announcer.shown());
    }

    void it_vanishes_again() {
        NotificationAnnouncer announcer;
        announcer.announce("lips");
        QTRY_VERIFY(announcer.shown());
        QTRY_VERIFY(!announcer.shown());
    }
};

QTEST_GUILESS_MAIN(AnnouncerTest)
#include "announcer_test.moc"
