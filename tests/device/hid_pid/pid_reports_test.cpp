// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/pid_reports.hpp"
#include "joystick_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

namespace pid_reports_test {

using namespace tp;
using namespace tp::hid;
using tp::testing::bytes_of;

namespace {

ReportDescriptor read_whole(std::span<const std::uint8_t> bytes) {
    ReportDescriptor found;
    return parse_report_descriptor(bytes, found) == DescriptorFault::none ? found : ReportDescriptor{};
}

PidLayout layout_of(const JoystickWire& wire) {
    PidLayout layout;
    find_layout(read_whole(wire.descriptor), layout);
    return layout;
}

QByteArray hex_of(const Report& report) {
    return QByteArray(reinterpret_cast<const char*>(report.bytes.data()), static_cast<qsizetype>(report.size))
        .toHex(' ');
}

/// The descriptor of an open controller without the first place of these bytes, or with others there.
std::vector<std::uint8_t> changed(std::string_view bytes, std::string_view into) {
    const std::vector<std::uint8_t> from = bytes_of(bytes);
    const std::vector<std::uint8_t> to = bytes_of(into);
    const JoystickWire wire = open_controller();
    std::vector<std::uint8_t> descriptor(wire.descriptor.begin(), wire.descriptor.end());
    const auto at = std::search(descriptor.begin(), descriptor.end(), from.begin(), from.end());
    if (at == descriptor.end())
        return {};
    const auto behind = descriptor.erase(at, at + static_cast<std::ptrdiff_t>(from.size()));
    descriptor.insert(behind, to.begin(), to.end());
    return descriptor;
}

} // namespace

class PidReportsTest : public QObject {
    Q_OBJECT
private slots:
    void golden_reports_of_an_open_controller() {
        const PidLayout layout = layout_of(open_controller());
        QCOMPARE(hex_of(create_report(layout)), "11 01 00 00");
        QCOMPARE(hex_of(asking_for(layout.block_load.report)), "12 00 00 00 00");
        QCOMPARE(hex_of(effect_report(layout, 3, Along::x)),
                 "01 03 01 ff ff 00 00 00 00 00 00 ff 00 07 28 23 00 00 00 00 00 00");
        QCOMPARE(hex_of(effect_report(layout, 4, Along::y)),
                 "01 04 01 ff ff 00 00 00 00 00 00 ff 00 07 00 00 00 00 00 00 00 00");
        QCOMPARE(hex_of(force_report(layout, 3, full_share)), "05 03 ff 7f");
        QCOMPARE(hex_of(force_report(layout, 3, -256)), "05 03 00 ff");
        QCOMPARE(hex_of(start_report(layout, 3)), "0a 03 01 01");
        QCOMPARE(hex_of(stop_report(layout, 3)), "0a 03 03 00");
        QCOMPARE(hex_of(free_report(layout, 3)), "0b 03");
        QCOMPARE(hex_of(control_report(layout, layout.control.enable)), "0c 01");
        QCOMPARE(hex_of(control_report(layout, layout.control.reset)), "0c 04");
        QCOMPARE(hex_of(full_gain_report(layout)), "0d ff");
    }
    void golden_reports_of_a_sidewinder() {
        const PidLayout layout = layout_of(tp::testing::sidewinder());
        QCOMPARE(hex_of(create_report(layout)), "01 01 00 00");
        // 90° of a direction of 8 bits is 64 of 255; the start delay is the last field.
        QCOMPARE(hex_of(effect_report(layout, 1, Along::x)),
                 "01 01 01 ff ff 00 00 00 00 ff 00 07 40 00 00 00");
        QCOMPARE(hex_of(force_report(layout, 1, full_share)), "05 01 ff 00");
        QCOMPARE(hex_of(force_report(layout, 1, -full_share)), "05 01 01 ff");
        QCOMPARE(hex_of(start_report(layout, 2)), "0a 02 01 01");
        QCOMPARE(hex_of(control_report(layout, layout.control.disable)), "0c 02");
    }
    void golden_reports_of_commands_with_a_bit_each() {
        const PidLayout layout = layout_of(plain_controller());
        QCOMPARE(hex_of(control_report(layout, layout.control.enable)), "0c 01");
        QCOMPARE(hex_of(control_report(layout, layout.control.disable)), "0c 02");
        QCOMPARE(hex_of(control_report(layout, layout.control.stop_all)), "0c 04");
        QCOMPARE(hex_of(control_report(layout, layout.control.reset)), "0c 08");
        QCOMPARE(hex_of(effect_report(layout, 3, Along::x)),
                 "01 03 01 ff ff 00 00 00 00 ff 00 07 28 23 00 00"); // no delay
        QVERIFY(!layout.state.report.there());
    }

    void a_command_that_its_field_has_no_number_for_is_none() {
        PidLayout layout;
        QVERIFY(find_layout(read_whole(changed("09 9C 15 01 25 06", "09 9C 15 01 25 03")), layout) ==
                nullptr);
        QCOMPARE(hex_of(control_report(layout, layout.control.stop_all)), "0c 03");
        QVERIFY(!layout.control.reset.there()); // which would be 4
    }

    void block_load_is_read() {
        const PidLayout layout = layout_of(open_controller());
        const auto loaded = [&layout](std::string_view hex) { return loaded_block(layout, bytes_of(hex)); };
        QCOMPARE(loaded("12 05 01 00 10").block, std::uint8_t(5));
        QCOMPARE(loaded("12 05 01 00 10").status, LoadedBlock::Status::success);
        QCOMPARE(loaded("12 FF 01 00 10").block, std::uint8_t(255));
        PidLayout wide = layout; // of a stick that counts its effects in 16 bits
        wide.block_load.block = {16, 16, 0, 65535};
        QCOMPARE(loaded_block(wide, bytes_of("12 00 01 FF 00")).block, std::uint8_t(255));
        QCOMPARE(loaded_block(wide, bytes_of("12 00 01 2C 01")).status, LoadedBlock::Status::refused);
        QCOMPARE(loaded("12 00 02 00 00").status, LoadedBlock::Status::full);
        QCOMPARE(loaded("12 00 03 00 00").status, LoadedBlock::Status::refused);
        QCOMPARE(loaded("12 00 01 00 10").status, LoadedBlock::Status::refused); // no number
        QCOMPARE(loaded("12 05 01").status, LoadedBlock::Status::refused);       // cut short
        QCOMPARE(loaded("13 05 01 00 10").status, LoadedBlock::Status::refused); // another report
        QCOMPARE(loaded("").status, LoadedBlock::Status::refused);
    }

    void axes_buttons_and_state_are_read() {
        const PidLayout layout = layout_of(open_controller());
        JoystickNews news = joystick_news(layout, bytes_of("01 05 00 00 00 00 00 00 00 FF 7F 01 80"));
        QVERIFY(news.axes == Vec2(1.0, -1.0));
        QCOMPARE(news.buttons, 5u);
        QVERIFY(!news.motors_on);
        QVERIFY(!joystick_news(layout, bytes_of("01 05 00 00 00 00 00 00 00 FF 7F 01")).axes); // cut short
        QVERIFY(!joystick_news(layout, {}).axes);
        QCOMPARE(joystick_news(layout, bytes_of("02 0E")).motors_on, std::optional(true));
        QCOMPARE(joystick_news(layout, bytes_of("02 0F")).motors_on, std::optional(false)); // paused
        QCOMPARE(joystick_news(layout, bytes_of("02 0C")).motors_on, std::optional(false)); // actuators off
        QCOMPARE(joystick_news(layout, bytes_of("02 06")).motors_on, std::optional(false)); // no power
        news = joystick_news(layout, bytes_of("02 0A"));
        QCOMPARE(news.motors_on, std::optional(false));
        QVERIFY(news.safety_switch_off);
    }

    void of_the_recorded_ones_only_the_sidewinder_is_a_joystick() {
        for (const auto& recorded : tp::testing::recorded_descriptors) {
            const ReportDescriptor descriptor = read_whole(bytes_of(recorded.hex));
            PidLayout layout;
            const char* const why = find_layout(descriptor, layout);
            const bool stick = recorded.hex == tp::testing::sidewinder_force_feedback_2.hex;
            const bool rumbles = recorded.hex == tp::testing::saitek_rumble_pad.hex;
            QVERIFY2((why == nullptr) == stick, recorded.device);
            QVERIFY2(has_constant_force(descriptor) == (stick || rumbles), recorded.device);
            if (rumbles)
                QCOMPARE(QByteArray(why), "its force has no direction");
        }
    }

    void what_keeps_a_joystick_from_being_used_is_said_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("into");
        QTest::addColumn<QByteArray>("why");
        const auto row = [](const char* name, const char* from, const char* into, const char* why) {
            QTest::newRow(name) << QByteArray(from) << QByteArray(into) << QByteArray(why);
        };
        row("as it is", "C0", "C0", "");
        row("no start delay", "09 A7", "09 A8", "");
        row("no state", "09 92 A1 02", "09 93 A1 02", "");
        row("no gain", "09 7D A1 02", "09 7C A1 02", "");
        row("no block free", "09 90 A1 02", "09 91 A1 02", "");
        row("no direction but axes", "09 57 A1 02", "09 58 A1 02", "");
        row("one axis", "09 30 09 31 16", "09 30 09 32 16", "it does not have two axes");
        row("the other axis", "09 30 09 31 16", "09 32 09 31 16", "it does not have two axes");
        row("relative axes", "75 10 95 02 81 02", "75 10 95 02 81 06", "it does not have two axes");
        row("no magnitude", "09 70", "09 71", "it has no constant force");
        row("magnitude_from_0", "09 70 16 01 80", "09 70 16 00 00", "its force has no sign");
        row("no create", "09 AB", "09 AC", "it does not keep its effects itself");
        row("no block load", "09 89", "09 88", "it does not keep its effects itself");
        row("offset_instead_of_a_number", "85 05 09 22", "85 05 09 23", "its effects have no numbers");
        row("no start", "09 79", "09 76", "its effects have no numbers");
        row("reports_too_long", "09 58 A1 02", "96 FF 01 91 03 95 02 09 58 A1 02",
            "its reports are too long");
        row("reports_as_long_as_may_be", "85 02 09 9F", "85 02 75 08 95 3E 81 03 09 9F", "");
        row("reports_longer_than_may_be", "85 02 09 9F", "85 02 75 08 95 3F 81 03 09 9F",
            "its reports are too long");
    }
    void what_keeps_a_joystick_from_being_used_is_said() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, into);
        QFETCH(QByteArray, why);
        const std::vector<std::uint8_t> descriptor = changed(from.toStdString(), into.toStdString());
        QVERIFY(!descriptor.empty());
        PidLayout layout;
        const char* const words = find_layout(read_whole(descriptor), layout);
        QCOMPARE(QByteArray(words == nullptr ? "" : words), why);
    }

    void without_directions_an_effect_has_one_axis() {
        PidLayout layout;
        QVERIFY(find_layout(read_whole(changed("09 57 A1 02", "09 58 A1 02")), layout) == nullptr);
        QCOMPARE(hex_of(effect_report(layout, 1, Along::x)).mid(39, 2), "01");
        QCOMPARE(hex_of(effect_report(layout, 1, Along::y)).mid(39, 2), "02");
    }

    void values_of_any_place_and_size_go_in_and_out() {
        for (std::uint32_t bit = 0; bit < 24; ++bit)
            for (std::uint8_t size = 1; size <= 32; ++size)
                for (const bool negative : {false, true}) {
                    if (negative && size == 1)
                        continue;
                    const std::int64_t most = (std::int64_t{1} << (size - (negative ? 1 : 0))) - 1;
                    const Slot slot{bit, size, negative ? -most - 1 : 0, most};
                    for (const std::int64_t value :
                         {slot.least, std::int64_t{0}, std::int64_t{1}, slot.most}) {
                        std::vector<std::uint8_t> report(8, 0xA5);
                        put_value(report, slot, value);
                        QCOMPARE(value_in(report, slot), value);
                    }
                }
    }
};

} // namespace pid_reports_test

TP_TEST(pid_reports_test, PidReportsTest, nothing)
#include "pid_reports_test.moc"
