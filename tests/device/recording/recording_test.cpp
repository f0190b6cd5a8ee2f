// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "device/recording/recording_device.hpp"
#include "device/recording/replay_device.hpp"
#include "device/simulated/simulated_device.hpp"
#include "device_double.hpp"
#include "places.hpp"
#include "recording_check.hpp"
#include "troubled_stamps.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>
#include <string>

using namespace tp;
using namespace tp::testing;

Q_DECLARE_METATYPE(const StampTrouble*)

namespace {

std::unique_ptr<const HapticScene> scene() {
    auto made = make_haptic_scene(Scene{200.0,
                                        150.0,
                                        {contour_through("upper", {{-80.0, 4.0}, {80.0, 4.0}}, false),
                                         contour_through("lower", {{-80.0, -4.0}, {80.0, -4.0}}, false)}});
    return std::move(made).value();
}

std::string bytes_of(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return file.readAll().toStdString();
}

/// A finger led over two lines for two seconds, with every hundredth tick a late one.
std::string recorded_session(const QString& path) {
    SimulatedPlant plant;
    plant.quantum = 0.02;
    SimulatedDevice device(200.0, 150.0, plant);
    RecordingDevice recorder(device, path.toStdString());
    const Result<Capabilities> can = recorder.open();
    if (!can.ok())
        return can.error();
    VirtualClock clock;
    clock.sleep_until(12.3456);
    ServoLoop loop(recorder, can.value(), clock, {});
    loop.render(scene());
    loop.engage();
    for (int i = 0; i < 2000; ++i) {
        clock.sleep_until(clock.now() + (i % 100 == 99 ? 0.0025 : 0.001));
        device.move_pointer({0.01 * i, 10.0 - 0.01 * i});
        loop.tick();
        if (i % 500 == 0 && !recorder.flush())
            return "not flushed";
    }
    return recorder.flush() ? "" : "not flushed";
}

} // namespace

class RecordingTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString path(const char* name) { return folder_.filePath(QString::fromLatin1(name)); }

private slots:
    void a_replay_sends_the_same_forces_to_the_last_bit() {
        QCOMPARE(recorded_session(path("session")), std::string());
        const Result<TouchRecording> read = parse_recording(bytes_of(path("session")));
        QVERIFY(read.ok());
        const TouchRecording& recording = read.value();
        QCOMPARE(recording.ticks.size(), std::size_t(2000));
        QCOMPARE(recording.bytes_left, std::size_t(0));
        QCOMPARE(recording.device.name, std::string("simulated device"));
        QCOMPARE(recording.device.resolution, 0.02);
        double strongest = 0.0;
        for (const RecordedTick& tick : recording.ticks)
            strongest = std::max(strongest, length(tick.force));
        QVERIFY(strongest > 0.3);

        for (const double stiffer : {1.0, 1.001}) {
            ReplayDevice device(recording);
            const Result<Capabilities> can = device.open();
            VirtualClock clock;
            clock.sleep_until(12.3456);
            ServoSettings settings;
            settings.handle_mass *= stiffer;
            ServoLoop loop(device, can.value(), clock, settings);
            loop.render(scene());
            loop.engage();
            replay(recording, loop, clock);
            QCOMPARE(device.ticks(), std::size_t(2000));
            QCOMPARE(device.greatest_difference() == 0.0, stiffer == 1.0); // and another servo shows
            loop.tick();
            QCOMPARE(loop.snapshot().fault, Fault::device_lost); // the end
        }
    }

    /// Whatever its clock does: what was no newer to the servo is no newer in the replay.
    void a_device_with_a_troubled_clock_is_replayed_to_the_last_bit_data() {
        QTest::addColumn<const StampTrouble*>("trouble");
        for (const auto* troubles : {&survived_stamps(), &stale_stamps()})
            for (const StampTrouble& one : *troubles)
                QTest::newRow(one.name) << &one;
    }
    void a_device_with_a_troubled_clock_is_replayed_to_the_last_bit() {
        QFETCH(const StampTrouble*, trouble);
        const QString file = path(trouble->name);
        DeviceDouble device;
        device.place = [](double now) { return Vec2(0.0, 8.0 - 7.0 * now); };
        int count = 0;
        device.stamp = [&](double now) {
            return now < 1.0 ? now - 7.0 : trouble->stamped(now - 7.0, 1.0 - 7.0, count++);
        };
        RecordingDevice recorder(device, file.toStdString());
        const Result<Capabilities> can = recorder.open();
        QVERIFY(can.ok());
        {
            VirtualClock clock;
            ServoLoop loop(recorder, can.value(), clock, {});
            loop.render(scene());
            loop.engage();
            for (int i = 0; i < 2000; ++i) {
                clock.sleep_until(clock.now() + 0.001);
                loop.tick();
            }
            QVERIFY(recorder.flush());
            QCOMPARE(loop.snapshot().fault, trouble->stale_within > 0.0 ? Fault::stale_input : Fault::none);
        }
        const Result<TouchRecording> read = parse_recording(bytes_of(file));
        QVERIFY(read.ok());
        QCOMPARE(read->ticks.size(), std::size_t(2000));
        ReplayDevice again(read.value());
        VirtualClock clock;
        ServoLoop loop(again, again.open().value(), clock, {});
        loop.render(scene());
        loop.engage();
        replay(read.value(), loop, clock);
        QCOMPARE(again.greatest_difference(), 0.0);
    }

    void a_file_that_ends_anywhere_keeps_every_whole_tick() {
        QCOMPARE(recorded_session(path("cut")), std::string());
        const std::string whole = bytes_of(path("cut"));
        const std::size_t header = whole.size() - 2000 * tick_size;
        for (std::size_t cut = 0; cut < header; ++cut)
            QVERIFY(!parse_recording(std::string_view(whole).substr(0, cut)).ok());
        for (std::size_t cut = header; cut < header + 5 * tick_size; ++cut) {
            const Result<TouchRecording> read = parse_recording(std::string_view(whole).substr(0, cut));
            QVERIFY(read.ok());
            QCOMPARE(read.value().ticks.size(), (cut - header) / tick_size);
            QCOMPARE(read.value().bytes_left, (cut - header) % tick_size);
        }
    }

    void a_broken_tick_ends_the_recording_there() {
        QCOMPARE(recorded_session(path("broken")), std::string());
        const std::string whole = bytes_of(path("broken"));
        const std::size_t header = whole.size() - 2000 * tick_size;
        for (std::size_t byte = 0; byte < tick_size; ++byte) {
            std::string broken = whole;
            broken[header + 100 * tick_size + byte] ^= 0x10;
            const Result<TouchRecording> read = parse_recording(broken);
            QVERIFY(read.ok());
            QCOMPARE(read.value().ticks.size(), std::size_t(100));
        }
        std::string missing = whole;
        missing.erase(header + 50 * tick_size, tick_size); // whole ticks, but one is gone
        QCOMPARE(parse_recording(missing).value().ticks.size(), std::size_t(50));
    }

    void what_the_servo_could_not_write_down_in_time_ends_it() {
        SimulatedDevice device(200.0, 150.0);
        RecordingDevice recorder(device, path("overrun").toStdString());
        QVERIFY(recorder.open().ok());
        for (int i = 0; i < 20000; ++i) {
            recorder.read(0.001 * i);
            recorder.write(SafeForce{});
        }
        QVERIFY(!recorder.flush());
        const Result<TouchRecording> read = parse_recording(bytes_of(path("overrun")));
        QCOMPARE(read.value().ticks.size(), std::size_t(16384));
    }

    void an_existing_file_is_not_touched() {
        QFile file(path("mine"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("mine");
        file.close();
        SimulatedDevice device(200.0, 150.0);
        RecordingDevice recorder(device, path("mine").toStdString());
        const Result<Capabilities> can = recorder.open();
        QVERIFY(!can.ok());
        QVERIFY(can.error().find("already") != std::string::npos);
        QCOMPARE(bytes_of(path("mine")), std::string("mine"));
    }

    void names_cannot_break_out_of_the_header() {
        Capabilities device;
        device.name = "a\nserial evil\n\n";
        device.serial_number = std::string(5000, 'x');
        const Result<TouchRecording> read = parse_recording(recording_header(device));
        QVERIFY(read.ok());
        QCOMPARE(read.value().device.name, std::string("a serial evil  "));
        QCOMPARE(read.value().device.serial_number.size(), std::size_t(200));
    }

    void the_fuzzers_inputs_hold() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/device/recording/corpus"));
        QVERIFY(seeds.size() >= 4);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + tp::test::complaint_about_recording(seed.text), seed.name + ": ");
    }
};

QTEST_APPLESS_MAIN(RecordingTest)
#include "recording_test.moc"
