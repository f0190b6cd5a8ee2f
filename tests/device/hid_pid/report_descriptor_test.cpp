// SPDX-License-Identifier: Apache-2.0
#include "../descriptor_lines.hpp"
#include "byte_mutants.hpp"
#include "descriptor_check.hpp"
#include "device/hid/report_descriptor.hpp"
#include "device/hid_pid/model_joystick.hpp"
#include "model_descriptor_lines.hpp"
#include "places.hpp"
#include "recorded_descriptors.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace report_descriptor_test {

using namespace tp;
using namespace tp::hid;
using tp::testing::bytes_of;

namespace {

ReportDescriptor parsed(std::string_view hex) {
    ReportDescriptor found;
    const DescriptorFault fault = parse_report_descriptor(bytes_of(hex), found);
    return fault == DescriptorFault::none ? found : ReportDescriptor{};
}

DescriptorFault fault_of(std::string_view hex) {
    ReportDescriptor found;
    return parse_report_descriptor(bytes_of(hex), found);
}

const Field* field_of(const ReportDescriptor& descriptor, ReportKind kind, std::uint32_t usage) {
    for (const Field& field : descriptor.fields)
        if (field.kind == kind && !field.constant && field.index_of(usage) >= 0)
            return &field;
    return nullptr;
}

/// What is known of a recorded descriptor from elsewhere: its length, and the lengths of reports that people
/// read of it.
struct KnownReport {
    const tp::testing::RecordedDescriptor& recorded;
    std::size_t bytes;
    ReportKind kind;
    std::uint8_t id;
    std::size_t report_bytes; ///< behind the id
};

} // namespace

class ReportDescriptorTest : public QObject {
    Q_OBJECT
private slots:
    // The models' own descriptors, of which nothing is read back through what they are to try
    void the_models_say_what_they_have() {
        QCOMPARE(tp::testing::lines_of(open_controller().descriptor),
                 std::string(tp::testing::open_controller_lines));
        QCOMPARE(tp::testing::lines_of(plain_controller().descriptor),
                 std::string(tp::testing::plain_controller_lines));
    }

    void recorded_ones_are_read_whole_data() {
        QTest::addColumn<int>("number");
        for (std::size_t i = 0; i < tp::testing::recorded_descriptors.size(); ++i)
            QTest::newRow(tp::testing::recorded_descriptors[i].device) << static_cast<int>(i);
    }
    void recorded_ones_are_read_whole() {
        QFETCH(int, number);
        const auto& recorded = tp::testing::recorded_descriptors[static_cast<std::size_t>(number)];
        const std::vector<std::uint8_t> bytes = bytes_of(recorded.hex);
        ReportDescriptor found;
        QCOMPARE(parse_report_descriptor(bytes, found), DescriptorFault::none);
        QVERIFY(!found.fields.empty());
        QVERIFY(!found.collections.empty());
        const std::string complaint =
            tp::test::complaint_about_descriptor({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        QVERIFY2(complaint.empty(), complaint.c_str());
        for (int kind = 0; kind < 3; ++kind) // whole bytes, as these devices send them
            for (unsigned id = 0; id < 256; ++id)
                QCOMPARE(found.bits[static_cast<std::size_t>(kind)][id] % 8, 0u);
    }

    void reports_have_their_known_lengths() {
        using namespace tp::testing;
        const KnownReport known[] = {
            {sidewinder_force_feedback_2, 1343, ReportKind::input, 1, 12},
            {sidewinder_force_feedback_2, 1343, ReportKind::output, 1, 15},
            {sidewinder_force_feedback_2, 1343, ReportKind::output, 5, 3},
            {sidewinder_force_feedback_2, 1343, ReportKind::feature, 1, 3},
            {sidewinder_force_feedback_2, 1343, ReportKind::feature, 2, 4},
            {saitek_rumble_pad, 625, ReportKind::input, 1, 6},
            {saitek_rumble_pad, 625, ReportKind::output, 0x0D, 2},
            {logitech_g29, 160, ReportKind::input, 1, 63},
            {logitech_g29, 160, ReportKind::output, 5, 31},
            {saitek_x52, 119, ReportKind::input, 0, 14},
            {sony_dualshock_3, 148, ReportKind::input, 1, 48},
            {sony_dualshock_3, 148, ReportKind::feature, 0xEF, 48},
            {logitech_unifying_receiver, 98, ReportKind::output, 0x10, 6},
            {logitech_unifying_receiver, 98, ReportKind::output, 0x11, 19},
            {dragonrise_gamepad, 50, ReportKind::input, 0, 8},
            {microsoft_transceiver, 223, ReportKind::input, 0x1A, 9},
            {logitech_g500s, 67, ReportKind::input, 0, 8},
            {kxd_gamepad, 101, ReportKind::output, 0, 7},
        };
        for (const KnownReport& one : known) {
            QCOMPARE(bytes_of(one.recorded.hex).size(), one.bytes);
            QCOMPARE(parsed(one.recorded.hex).bytes(one.kind, one.id), one.report_bytes);
        }
    }

    void fields_of_a_sidewinder() {
        const ReportDescriptor found = parsed(tp::testing::sidewinder_force_feedback_2.hex);
        QVERIFY(found.numbered);
        const Field* const x = field_of(found, ReportKind::input, usage_of(1, 0x30));
        QVERIFY(x != nullptr);
        QCOMPARE(x->bit_size, 10u);
        QCOMPARE(x->logical_min, std::int64_t{-512});
        QCOMPARE(x->logical_max, std::int64_t{511});
        QCOMPARE(x->physical_max, std::int64_t{1023});
        const Field* const y = field_of(found, ReportKind::input, usage_of(1, 0x31));
        QVERIFY(y != nullptr);
        QCOMPARE(y->bit_offset, 16u);
        const Field* const duration = field_of(found, ReportKind::output, usage_of(0x0F, 0x50));
        QVERIFY(duration != nullptr);
        QCOMPARE(duration->bit_offset, 16u);
        QCOMPARE(duration->count, 3u);
        QCOMPARE(duration->usage_at(1), usage_of(0x0F, 0x54));
        QCOMPARE(duration->unit, 0x1003u);
        QCOMPARE(duration->unit_exponent, -3); // thousandths of a second
        const Field* const type = field_of(found, ReportKind::output, usage_of(0x0F, 0x26));
        QVERIFY(type != nullptr && type->array);
        QCOMPARE(type->index_of(usage_of(0x0F, 0x28)), std::int64_t{11});
        QCOMPARE(type->logical_min, std::int64_t{1});
        QCOMPARE(type->logical_max, std::int64_t{12});
        QVERIFY(found.within(type->collection, usage_of(0x0F, 0x25)));
        QVERIFY(found.within(type->collection, usage_of(0x0F, 0x21)));
        QVERIFY(!found.within(type->collection, usage_of(0x0F, 0xAB)));
        const Field* const direction = field_of(found, ReportKind::output, usage_of(0x0A, 2));
        QVERIFY(direction != nullptr);
        QCOMPARE(direction->logical_max, std::int64_t{255});
        QCOMPARE(direction->physical_max, std::int64_t{36000});
    }

    void usages_in_a_range_and_the_last_one_for_all_the_rest() {
        const Field range = parsed("05 09 19 03 29 05 15 00 25 01 75 01 95 08 81 02").fields.at(0);
        QCOMPARE(range.usage_at(0), usage_of(9, 3));
        QCOMPARE(range.usage_at(2), usage_of(9, 5));
        QCOMPARE(range.usage_at(7), usage_of(9, 5));
        QCOMPARE(range.index_of(usage_of(9, 4)), std::int64_t{1});
        QCOMPARE(range.index_of(usage_of(9, 6)), std::int64_t{-1});
    }
    void a_usage_takes_its_page_from_the_main_item_unless_it_has_one() {
        const Field late = parsed("05 01 09 30 0B 31 00 02 00 05 09 75 01 95 02 81 02").fields.at(0);
        QCOMPARE(late.usage_at(0), usage_of(9, 0x30));
        QCOMPARE(late.usage_at(1), usage_of(2, 0x31));
    }
    void of_alternative_usages_the_first_counts() {
        const Field one = parsed("05 01 A9 01 09 30 09 31 A9 00 09 32 75 08 95 02 81 02").fields.at(0);
        QCOMPARE(one.usage_at(0), usage_of(1, 0x30));
        QCOMPARE(one.usage_at(1), usage_of(1, 0x32));
    }
    void pushed_and_popped() {
        const ReportDescriptor found =
            parsed("05 01 75 08 95 02 A4 75 10 95 01 05 09 09 01 81 02 B4 09 30 81 02");
        QCOMPARE(found.fields.at(0).bit_size, 16u);
        QCOMPARE(found.fields.at(1).bit_size, 8u);
        QCOMPARE(found.fields.at(1).bit_offset, 16u);
        QCOMPARE(found.fields.at(1).usage_at(0), usage_of(1, 0x30));
    }
    void a_maximum_has_a_sign_only_where_its_minimum_has_one() {
        QCOMPARE(parsed("15 00 25 FF 75 08 95 01 81 02").fields.at(0).logical_max, std::int64_t{255});
        QCOMPARE(parsed("15 81 25 7F 75 08 95 01 81 02").fields.at(0).logical_min, std::int64_t{-127});
        QCOMPARE(parsed("25 FF 15 00 75 08 95 01 81 02").fields.at(0).logical_max,
                 std::int64_t{255}); // either first
        QCOMPARE(parsed("17 00 00 00 80 27 FF FF FF 7F 75 20 95 01 81 02").fields.at(0).logical_min,
                 std::int64_t{-2147483648LL});
    }
    void exponents_are_nibbles_or_bytes() {
        QCOMPARE(parsed("55 0D 75 08 95 01 81 02").fields.at(0).unit_exponent, -3);
        QCOMPARE(parsed("55 FD 75 08 95 01 81 02").fields.at(0).unit_exponent, -3);
        QCOMPARE(parsed("55 03 75 08 95 01 81 02").fields.at(0).unit_exponent, 3);
    }
    void long_and_reserved_items_are_passed_over() {
        const ReportDescriptor found = parsed("FE 03 F0 01 02 03 0C 75 08 95 01 81 02");
        QCOMPARE(found.fields.size(), std::size_t(1));
    }
    void reports_of_one_id_grow_apart_by_kind() {
        const ReportDescriptor found = parsed("85 01 75 08 95 01 81 02 91 02 85 02 81 02 85 01 81 02");
        QCOMPARE(found.fields.at(0).bit_offset, 0u);
        QCOMPARE(found.fields.at(1).bit_offset, 0u); // output
        QCOMPARE(found.fields.at(2).bit_offset, 0u); // report 2
        QCOMPARE(found.fields.at(3).bit_offset, 8u);
        QCOMPARE(found.bytes(ReportKind::input, 1), std::size_t(2));
    }

    void what_cannot_be_is_refused_data() {
        QTest::addColumn<QByteArray>("hex");
        QTest::addColumn<int>("fault");
        const auto row = [](const char* name, const char* hex, DescriptorFault fault) {
            QTest::newRow(name) << QByteArray(hex) << static_cast<int>(fault);
        };
        row("item_cut_short", "05", DescriptorFault::cut_short);
        row("four_byte_item_cut_short", "27 FF FF 00", DescriptorFault::cut_short);
        row("long_item_cut_short", "FE 05 F0 01", DescriptorFault::cut_short);
        row("long_item_without_a_head", "FE", DescriptorFault::cut_short);
        row("end_without_a_collection", "C0", DescriptorFault::collections_do_not_match);
        row("collection_without_an_end", "A1 01", DescriptorFault::collections_do_not_match);
        row("pop_without_a_push", "B4", DescriptorFault::nothing_saved);
        row("report_id_0", "85 00", DescriptorFault::report_id_0);
        row("report_id_beyond_a_byte", "86 00 01", DescriptorFault::report_id_0);
        row("report_of_16_gigabyte", "77 FF FF FF FF 97 FF FF FF FF 81 02", DescriptorFault::report_too_long);
        row("reports_that_add_up", "76 00 80 95 02 81 02 81 02", DescriptorFault::report_too_long);
    }
    void what_cannot_be_is_refused() {
        QFETCH(QByteArray, hex);
        QFETCH(int, fault);
        QCOMPARE(static_cast<int>(fault_of({hex.constData(), static_cast<std::size_t>(hex.size())})), fault);
    }
    void too_much_of_it_is_refused() {
        ReportDescriptor found;
        QCOMPARE(parse_report_descriptor(std::vector<std::uint8_t>(most_descriptor_bytes + 1, 0xA1), found),
                 DescriptorFault::too_long);
        QCOMPARE(parse_report_descriptor(std::vector<std::uint8_t>(1000, 0xA4), found),
                 DescriptorFault::too_deep);
        std::vector<std::uint8_t> deep;
        for (int i = 0; i < 40; ++i)
            deep.insert(deep.end(), {0xA1, 0x02});
        QCOMPARE(parse_report_descriptor(deep, found), DescriptorFault::too_deep);
        QVERIFY(found.collections.empty());
    }

    void hostile_changes_of_real_ones_hold() {
        std::vector<tp::test::Seed> seeds =
            tp::test::corpus(tp::test::in_source("tests/device/hid_pid/corpus"));
        for (const auto& recorded : tp::testing::recorded_descriptors) {
            const std::vector<std::uint8_t> bytes = bytes_of(recorded.hex);
            seeds.push_back({recorded.device, std::string(bytes.begin(), bytes.end())});
        }
        for (const JoystickWire& wire : {open_controller(), plain_controller()})
            seeds.push_back({"model", std::string(wire.descriptor.begin(), wire.descriptor.end())});
        for (const tp::test::Seed& seed : seeds) {
            const std::string complaint = tp::test::complaint_about_descriptor(seed.text);
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
        tp::test::ByteMutator mutator(20260);
        for (int i = 0; i < 3000; ++i) {
            const std::string complaint = tp::test::complaint_about_descriptor(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), qPrintable(QString("mutant %1: %2").arg(i).arg(complaint.c_str())));
        }
    }
};

} // namespace report_descriptor_test

TP_TEST(report_descriptor_test, ReportDescriptorTest, nothing)
#include "report_descriptor_test.moc"
