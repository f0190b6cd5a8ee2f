// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// What a HID device says of its reports (USB Device Class Definition for HID 1.11, sections 5 and 6.2.2).
namespace tp::hid {

/// Usage page in the upper 16 bits, usage id in the lower.
constexpr std::uint32_t usage_of(std::uint32_t page, std::uint32_t id) { return page << 16 | id; }

enum class ReportKind : std::uint8_t { input, output, feature };

struct UsageRange {
    std::uint32_t first = 0;
    std::uint32_t last = 0; ///< included; ≥ first
};

struct Collection {
    std::uint32_t usage = 0;
    std::uint8_t type = 0; ///< 1 application, 2 logical
    int parent = -1;       ///< an earlier collection; -1 at the top
};

/// One main item: `count` values of `bit_size` bits each, one behind the other.
struct Field {
    ReportKind kind = ReportKind::input;
    std::uint8_t report_id = 0;   ///< 0 where the device does not number its reports
    std::uint32_t bit_offset = 0; ///< from the first bit behind the report id
    std::uint32_t bit_size = 0;
    std::uint32_t count = 0;
    bool constant = false; ///< padding
    bool array = false;    ///< a value selects one of the usages, counted from logical_min
    bool relative = false;
    std::int64_t logical_min = 0;
    std::int64_t logical_max = 0;
    std::int64_t physical_min = 0;
    std::int64_t physical_max = 0; ///< both 0: the same as the logical ones
    std::uint32_t unit = 0;
    int unit_exponent = 0;
    int collection = -1; ///< the innermost one
    std::vector<UsageRange> usages;

    /// Of the value at `index`, where it is no array: the last usage also stands for all values behind it.
    std::uint32_t usage_at(std::uint32_t index) const;
    /// Which of the usages it is, counted from 0; -1 where it is none of them.
    std::int64_t index_of(std::uint32_t usage) const;
};

struct ReportDescriptor {
    std::vector<Collection> collections;
    std::vector<Field> fields;
    bool numbered = false;                                ///< every report begins with its id
    std::array<std::array<std::uint32_t, 256>, 3> bits{}; ///< of a report behind its id, by kind and id

    /// Whether the collection, or one around it, has that usage.
    bool within(int collection, std::uint32_t usage) const;
    /// Bytes of a report behind its id.
    std::size_t bytes(ReportKind kind, std::uint8_t id) const {
        return (bits[static_cast<std::size_t>(kind)][id] + 7u) / 8u;
    }
};

inline constexpr std::size_t most_descriptor_bytes =
    4096; ///< as the system's own limit (HID_MAX_DESCRIPTOR_SIZE)
inline constexpr std::uint32_t most_report_bits = 8 * 8192;

enum class DescriptorFault : std::uint8_t {
    none,
    too_long,
    cut_short,
    collections_do_not_match, ///< an end without a begin, or the other way round
    too_deep,                 ///< collections or saved states in one another
    nothing_saved,            ///< a pop without a push
    report_id_0,
    report_too_long,
};

/// Any bytes. Takes memory in proportion to them, never to the numbers in them. Nothing is in `found` after a
/// fault.
DescriptorFault parse_report_descriptor(std::span<const std::uint8_t> bytes, ReportDescriptor& found);

} // namespace tp::hid
