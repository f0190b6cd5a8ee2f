// SPDX-License-Identifier: Apache-2.0
#include "core/servo/fault.hpp"
#include "core/servo/force_device.hpp"
#include "test_program.hpp"

#include <QTest>

namespace force_device_test {

using namespace tp;

namespace {

/// Of its own it has only what it must.
class PlainDevice final : public ForceDevice {
public:
    Result<Capabilities> open() override { return Capabilities{}; }
    std::optional<DeviceState> read(double) noexcept override { return DeviceState{}; }
    bool write(const SafeForce&) noexcept override { return true; }
    void halt() noexcept override {}
    void stop() noexcept override {}
};

} // namespace

class ForceDeviceTest : public QObject {
    Q_OBJECT
private slots:
    /// A device that is not told of otherwise is there, obeys, needs no care and knows its own strength.
    void what_a_device_does_not_say_is_taken_for_harmless() {
        PlainDevice device;
        QVERIFY(!device.lost() && !device.motors_off());
        QVERIFY(!device.home().ok() && QString::fromStdString(device.home().error()).endsWith('.'));
        QVERIFY(!device.assume(1.0, {1.0, 1.0}));
        QVERIFY(device.complaint().empty());
    }

    /// Nothing is felt of a device that tells nothing of itself.
    void what_is_not_told_is_nothing() {
        const Capabilities can = PlainDevice().open().value();
        QVERIFY(can.max_force == 0.0 && can.continuous_force == 0.0 && can.resolution == 0.0);
        QVERIFY(can.rate == 1000.0 && can.delay == 0.0 && !can.calibrated);
        QVERIFY(can.name.empty() && can.serial_number.empty() && can.workspace.empty());
        const DeviceState state = PlainDevice().read(1.0).value();
        QVERIFY(state.time == 0.0 && state.position == Vec2(0.0) && state.buttons == 0);
        QVERIFY(SafeForce().newtons() == Vec2(0.0) && SafeForce().share() == 0.0);
        QVERIFY(SafeForce().scaled(0.5).newtons() == Vec2(0.0) && SafeForce().scaled(0.5).share() == 0.0);
    }

    /// Only what a person must put right keeps the device off.
    void a_fault_of_a_moment_heals_and_a_grave_one_does_not() {
        for (const Fault light :
             {Fault::none, Fault::not_a_number, Fault::outside_workspace, Fault::over_speed,
              Fault::motors_off, Fault::stale_input, Fault::late_ticks})
            QVERIFY(!disables(light));
        QVERIFY(disables(Fault::stalled) && disables(Fault::device_lost));
    }
};

} // namespace force_device_test

TP_TEST(force_device_test, ForceDeviceTest, nothing)
#include "force_device_test.moc"
