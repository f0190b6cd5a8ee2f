// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: a Falcon's model on the kernel's own USB, its firmware loaded and a face touched
// with it through the real libusb.
#include "touch_bench.hpp"

#include <QDir>
#include <QFile>
#include <QTest>

#include <cstddef>
#include <cstdint>

using namespace tp;
using namespace tp::vm;

class FalconVmTest : public QObject {
    Q_OBJECT

    static constexpr const char* falcon = "falcon:FTFALCON";

    /// A person's data folder with a firmware in it, made up and of the size of a real one.
    struct Data {
        QTemporaryDir folder;
        QString firmware = folder.filePath("touchphoto/falcon/firmware.bin");
        Data() {
            QByteArray image(7914, '\0');
            for (int i = 0; i < image.size(); ++i)
                image[i] = static_cast<char>((i * 131) ^ (i >> 5));
            QDir(folder.path()).mkpath("touchphoto/falcon");
            QFile file(firmware);
            if (!file.open(QIODevice::WriteOnly) || file.write(image) != image.size())
                qFatal("no firmware");
            qputenv("XDG_DATA_HOME", folder.path().toUtf8());
        }
    };
    struct Bench : Data, TouchBench {
        Bench() : TouchBench("vm_virtual_falcon", {firmware}, falcon) { begin_to_touch(); }
    };

private slots:
    /// As a person begins with it: the firmware is loaded, the grip pulled out and pushed in while its light
    /// is blue.
    void the_lab_lists_homes_and_reads_it() {
        const Data data;
        const TouchBench bench("vm_virtual_falcon", {data.firmware}, falcon);
        QVERIFY(comes_true([] { return run_lab({"devices"}).printed.contains(falcon); }, 10.0));
        const LabRun homed = run_lab({"devices", "home", falcon});
        QVERIFY2(homed.status == 0, qPrintable(homed.printed + homed.complaints));
        QCOMPARE(what_the_lab_misses(falcon), QString());
    }

    /// From a Falcon that has just got its power: the firmware is loaded, the grip homed, and every part of
    /// the face draws the hand. Nothing is late.
    void a_face_is_felt_and_no_tick_is_late() {
        const double plugged_in = now();
        Bench bench;
        QVERIFY(bench.pulls());
        say("from the cable to the first pull", 1e3 * (now() - plugged_in));
        const double begun = now();
        pass(round_the_face);
        const double ended = now();
        QVERIFY(bench.end_touching());
        QCOMPARE(bench.sessions.size(), std::size_t(1));
        const TouchSession session = bench.sessions[0];
        say("latest tick", 1e3 * session.latest_s);
        QCOMPARE(session.missed, std::uint64_t(0));
        QVERIFY(session.latest_s < 0.5 * tick);
        QCOMPARE(told_faults(bench.snapshots, begun, ended), QString());
        QCOMPARE(contours_felt(bench.snapshots, begun, ended).size(), contours_of_the_face());
    }

    void unplugged_in_mid_touch_and_felt_again() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double pulled_out = now();
        bench.tell('u');
        QVERIFY(comes_true([&] { return bench.sessions.size() == 1; }, 10.0));
        QVERIFY(bench.sessions[0].lost);
        const Fall fall = fall_after(bench.snapshots, pulled_out, now(), Fault::device_lost);
        QVERIFY(fall.noticed > 0.0);
        say("known to be lost after", 1e3 * (fall.noticed - pulled_out));
        QVERIFY(fall.last_force <= fall.noticed + ramp_down);
        bench.tell('p');
        QVERIFY(bench.pulls()); // its firmware runs and it is homed still
        QVERIFY(bench.end_touching());
        QVERIFY(!bench.sessions[1].lost);
    }

    void silent_in_mid_touch() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double fell_silent = now();
        bench.tell('s');
        pass(0.2);
        const double spoke = now();
        const Fall fall = fall_after(bench.snapshots, fell_silent, spoke, Fault::stale_input);
        say("the silence is noticed after", 1e3 * (fall.noticed - fell_silent));
        QVERIFY(fall.noticed > 0.0);
        QVERIFY(fall.noticed <= fell_silent + stale_after + tick + on_the_way);
        QVERIFY(fall.last_force <= fall.noticed + ramp_down);
        const double felt = last_pull(bench.device_log, fall.noticed, spoke) - fall.noticed;
        say("nor felt after", 1e3 * felt);
        QVERIFY(felt <= ramp_down + on_the_way);
        bench.tell('t');
        QVERIFY(bench.pulls());
        QVERIFY(bench.end_touching());
    }
};

QTEST_GUILESS_MAIN(FalconVmTest)
#include "falcon_test.moc"
