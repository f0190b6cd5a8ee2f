// SPDX-License-Identifier: Apache-2.0
// A force pad under the Explore page through the real libusb and the registry, with a device made by umockdev and the
// pad's own firmware behind it.
#include "app/parts/controls/recording_announcer.hpp"
#include "explore_bench.hpp"
#include "mock_usb.hpp"

#include <QTest>

#include <cmath>

using namespace tp;
using mock::UsbPadBed;

namespace {

constexpr int lips = 2;

/// A face whose lips' upper edge passes above the place where the pad's knob is.
std::shared_ptr<const LoadedPhoto> face_under_the_knob() {
    auto photo = std::make_shared<LoadedPhoto>(*drawn_photo());
    Contour& lip = photo->extraction.faces[0].contours[lips];
    lip = contour_through(feature::outer_lip, {{80, 78}, {120, 78}, {120, 90}, {80, 90}}, true);
    return photo;
}

struct Bench {
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session{narrator, sounds.earcons, sounds.guide, sounds.preferences, settings()};

    static ExploreSettings settings() {
        ExploreSettings made = patient_settings();
        made.devices = DeviceAccess::of_this_computer({});
        made.devices.look_every_ms = 20;
        return made;
    }
    bool said(const QString& part) const { return !voice.said().filter(part).isEmpty(); }
};

} // namespace

class ExplorePadTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const UsbPadBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_face_is_felt_with_a_pad_that_is_unplugged_and_plugged_in_again() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Bench bench;
        bench.session.enter();
        bench.session.show(face_under_the_knob());
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.device()->name(), QString("force pad"), 60000);
        QVERIFY(bench.session.device()->engaged());
        // The knob stands 10 mm right and 2 mm above the middle; nobody holds it, and the lips draw it.
        const double before = distance_to_feature(
            bench.session, lips, bench.session.view()->frame().from_surface(Vec2(10.0, 2.0)));
        QVERIFY2(before > 1.0 && before < 7.0, qPrintable(QString::number(before)));
        QTRY_VERIFY_WITH_TIMEOUT(bed.seen().motors, 60000);
        QTRY_VERIFY_WITH_TIMEOUT(
            distance_to_feature(bench.session, lips, bench.session.finger()->place()) < 0.5, 60000);
        QTRY_VERIFY(bench.said("lips"));

        bench.voice.clear();
        bed.unplug();
        bed.forget();
        QTRY_VERIFY_WITH_TIMEOUT(bench.said("it no longer answers. Check its cable"), 60000);
        QVERIFY(!bench.session.device()->engaged());
        QTRY_COMPARE(bench.session.finger()->newtons(), 0.0);
        QVERIFY(bench.session.device()->name().isEmpty());

        bench.voice.clear();
        const long taken = bed.seen().taken;
        QVERIFY(bed.plug_in());
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.device()->name(), QString("force pad"), 60000);
        QTRY_VERIFY(bench.said("Its force is off. Press Enter to switch it on."));
        QTRY_VERIFY_WITH_TIMEOUT(bed.seen().taken > taken + 100, 60000);
        QCOMPARE(bed.seen().x_mn, std::int16_t(0));
        QCOMPARE(bed.seen().y_mn, std::int16_t(0));
        QCOMPARE(bench.session.finger()->newtons(), 0.0);
        bench.session.device()->engage();
        QTRY_VERIFY_WITH_TIMEOUT(bed.seen().motors, 60000);

        bench.session.leave(); // the way out leaves no force, and the interface to others
        QTRY_VERIFY_WITH_TIMEOUT(bed.seen().released == bed.seen().claimed, 60000);
        QVERIFY(!bed.seen().motors);
        QCOMPARE(bed.seen().x_mn, std::int16_t(0));
        QCOMPARE(bed.seen().y_mn, std::int16_t(0));
    }

    void a_pad_that_another_program_holds_is_told() {
        UsbPadBed bed;
        UsbPadBed::Behaviour busy;
        busy.busy = true;
        bed.behave(busy);
        QVERIFY(bed.plug_in());
        Bench bench;
        bench.session.enter();
        bench.session.show(face_under_the_knob());
        QTRY_VERIFY_WITH_TIMEOUT(bench.said("Another program uses the force pad. Close that program and try again."), 60000);
        QVERIFY(bench.session.device()->name().isEmpty());
        bed.behave({});
        bench.session.device()->engage();
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.device()->name(), QString("force pad"), 60000);
        QVERIFY(bench.session.device()->engaged());
    }
};

QTEST_GUILESS_MAIN(ExplorePadTest)
#include "explore_pad_test.moc"
