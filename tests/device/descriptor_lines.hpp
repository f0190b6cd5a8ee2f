// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid/report_descriptor.hpp"

#include <cstdint>
#include <ios>
#include <span>
#include <sstream>
#include <string>

namespace tp::testing {

/// All that it may be, "30 31 40-4f".
inline std::string usages_of(const hid::Field& field) {
    std::ostringstream usages;
    usages << std::hex;
    for (const hid::UsageRange& range : field.usages) {
        usages << (usages.tellp() > 0 ? " " : "") << range.first;
        if (range.last > range.first)
            usages << '-' << range.last;
    }
    return usages.str();
}

/// What lies where: each collection, then each field with its kind, report, bits, usages, range, physical range and unit.
inline std::string lines_of(std::span<const std::uint8_t> descriptor) {
    hid::ReportDescriptor parsed;
    if (hid::parse_report_descriptor(descriptor, parsed) != hid::DescriptorFault::none)
        return {};
    std::ostringstream lines;
    for (const hid::Collection& one : parsed.collections)
        lines << std::hex << one.usage << std::dec << ' ' << int{one.type} << " in " << one.parent << '\n';
    for (const hid::Field& field : parsed.fields)
        lines << "iof"[static_cast<int>(field.kind)] << int{field.report_id} << " at " << field.bit_offset
              << ": " << field.count << 'x' << field.bit_size << ' '
              << (field.constant   ? "-"
                  : field.array    ? "a"
                  : field.relative ? "r"
                                   : "")
              << '[' << usages_of(field) << "] " << field.logical_min << ".." << field.logical_max << ' '
              << field.physical_min << ".." << field.physical_max << ' ' << std::hex << field.unit << std::dec
              << 'e' << field.unit_exponent << '\n';
    std::string text = lines.str();
    if (!text.empty())
        text.pop_back();
    return text;
}

} // namespace tp::testing
