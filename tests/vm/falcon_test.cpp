// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: a Falcon's model on the kernel's own USB, its firmware loaded and a face touched
// with it through the real libusb.
#include "touch_stories.hpp"

#include <QDir>
#include <QFile>
#include <QTest>

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
        feels_the_whole_face(bench, "falcon");
    }

    /// Its firmware runs and it is homed still.
    void unplugged_in_mid_touch_and_felt_again() {
        Bench bench;
        is_lost_and_felt_again(bench);
    }

    void silent_in_mid_touch() {
        Bench bench;
        bears_a_silence(bench);
    }

    /// A Falcon has no watchdog: of a program that is told to end, or killed, the guard takes the force away.
    void ended_in_mid_touch_data() {
        QTest::addColumn<bool>("killed");
        QTest::newRow("terminated") << false;
        QTest::newRow("killed") << true;
    }
    void ended_in_mid_touch() {
        QFETCH(bool, killed);
        Bench bench;
        QVERIFY(bench.pulls());
        const double ended = now();
        killed ? bench.kill_toucher() : bench.terminate_toucher();
        pass(0.2);
        const double let_go = last_pull(bench.device_log, ended, now()) - ended;
        say("the Falcon has let go after", 1e3 * let_go);
        QVERIFY(let_go <= guarded);
        QVERIFY(bench.feels() == Vec2(0.0));
    }
};

QTEST_GUILESS_MAIN(FalconVmTest)
#include "falcon_test.moc"
