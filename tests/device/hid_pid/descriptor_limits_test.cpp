// SPDX-License-Identifier: Apache-2.0
// The largest of each that is read of a report descriptor, and one more.
#include "device/hid/report_descriptor.hpp"
#include "recorded_descriptors.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace descriptor_limits_test {

using namespace tp;
using tp::testing::bytes_of;

namespace {

hid::DescriptorFault fault_of(const std::vector<std::uint8_t>& bytes) {
    hid::ReportDescriptor found;
    return hid::parse_report_descriptor(bytes, found);
}

} // namespace

class DescriptorLimitsTest : public QObject {
    Q_OBJECT
private slots:
    void a_descriptor_may_be_as_long_as_the_system_lets_it() {
        QCOMPARE(fault_of(std::vector<std::uint8_t>(4096, 0)), hid::DescriptorFault::none);
        QCOMPARE(fault_of(std::vector<std::uint8_t>(4097, 0)), hid::DescriptorFault::too_long);
    }

    void collections_and_states_may_be_32_deep() {
        for (const std::size_t depth : {32u, 33u}) {
            std::vector<std::uint8_t> collections;
            for (std::size_t i = 0; i < depth; ++i)
                collections.insert(collections.end(), {0xA1, 0x02});
            collections.insert(collections.end(), depth, 0xC0);
            const auto wanted = depth == 32 ? hid::DescriptorFault::none : hid::DescriptorFault::too_deep;
            QCOMPARE(fault_of(collections), wanted);
            QCOMPARE(fault_of(std::vector<std::uint8_t>(depth, 0xA4)), wanted);
        }
    }

    void a_report_may_have_8_kilobytes() {
        QCOMPARE(fault_of(bytes_of("76 00 80 95 02 81 02")), hid::DescriptorFault::none);
        QCOMPARE(fault_of(bytes_of("76 00 80 95 02 81 02 75 01 95 01 81 02")),
                 hid::DescriptorFault::report_too_long);
        QCOMPARE(fault_of(bytes_of("76 00 80 95 02 81 02 75 01 95 01 91 02")),
                 hid::DescriptorFault::none); // of another
    }

    void report_ids_are_1_to_255() {
        QCOMPARE(fault_of(bytes_of("85 01")), hid::DescriptorFault::none);
        QCOMPARE(fault_of(bytes_of("85 FF")), hid::DescriptorFault::none);
    }

    void long_items_may_be_empty_and_end_the_descriptor() {
        QCOMPARE(fault_of(bytes_of("FE 00 F0")), hid::DescriptorFault::none);
        QCOMPARE(fault_of(bytes_of("FE 02 F0 01 02")), hid::DescriptorFault::none);
        QCOMPARE(fault_of(bytes_of("FE 00")), hid::DescriptorFault::cut_short);
        QCOMPARE(fault_of(bytes_of("FE 02 F0 01")), hid::DescriptorFault::cut_short);
    }

    void numbers_have_the_sign_of_their_size() {
        const auto first = [](std::string_view hex) {
            hid::ReportDescriptor found;
            hid::parse_report_descriptor(bytes_of(hex), found);
            return found.fields.at(0);
        };
        QCOMPARE(first("15 80 25 7F 75 08 95 01 81 02").logical_min, std::int64_t{-128});
        QCOMPARE(first("16 80 00 26 FF 00 75 08 95 01 81 02").logical_min, std::int64_t{128});
        QCOMPARE(first("16 00 80 26 FF 7F 75 10 95 01 81 02").logical_min, std::int64_t{-32768});
        QCOMPARE(first("35 81 45 7F 75 08 95 01 81 02").physical_min, std::int64_t{-127});
        QCOMPARE(first("35 00 45 FF 75 08 95 01 81 02").physical_max, std::int64_t{255});
        for (const auto& [nibble, exponent] :
             {std::pair{"55 07", 7}, {"55 08", -8}, {"55 0F", -1}, {"55 10", 16}})
            QCOMPARE(first(std::string(nibble) + " 75 08 95 01 81 02").unit_exponent, exponent);
    }

    void flags_of_a_field_are_told_apart() {
        const auto flags = [](const char* item) {
            hid::ReportDescriptor found;
            hid::parse_report_descriptor(bytes_of(std::string("75 08 95 01 ") + item), found);
            const hid::Field& field = found.fields.at(0);
            return std::array{field.constant, field.array, field.relative};
        };
        QVERIFY(flags("81 02") == (std::array{false, false, false}));
        QVERIFY(flags("81 03") == (std::array{true, false, false}));
        QVERIFY(flags("81 00") == (std::array{false, true, false}));
        QVERIFY(flags("81 06") == (std::array{false, false, true}));
    }

    void a_range_of_one_usage_is_one_and_one_that_runs_back_is_none() {
        const auto usages = [](const char* items) {
            hid::ReportDescriptor found;
            hid::parse_report_descriptor(bytes_of(std::string("05 09 ") + items + " 75 01 95 08 81 02"),
                                         found);
            return found.fields.at(0).usages;
        };
        QCOMPARE(usages("19 03 29 03").size(), std::size_t(1));
        QCOMPARE(usages("19 04 29 03").size(), std::size_t(0));
        QCOMPARE(usages("29 03").size(), std::size_t(0));                // without a beginning
        QCOMPARE(usages("1B 03 00 09 00 29 05").size(), std::size_t(0)); // pages of one end only
        QCOMPARE(usages("19 03 29 04 29 06").size(), std::size_t(1));
    }
};

} // namespace descriptor_limits_test

TP_TEST(descriptor_limits_test, DescriptorLimitsTest, nothing)
#include "descriptor_limits_test.moc"
