// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid/report_descriptor.hpp"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <span>

namespace tp::testing {

/// All that it may be, "30 31 40-4f".
inline QString usages_of(const hid::Field& field) {
    QStringList usages;
    for (const hid::UsageRange& range : field.usages)
        usages << QString::number(range.first, 16) +
                      (range.last > range.first ? "-" + QString::number(range.last, 16) : QString());
    return usages.join(' ');
}

/// What lies where: each collection, then each field with its kind, report, bits, usages, range, physical range and unit.
inline QStringList lines_of(std::span<const std::uint8_t> descriptor) {
    hid::ReportDescriptor parsed;
    if (hid::parse_report_descriptor(descriptor, parsed) != hid::DescriptorFault::none)
        return {};
    QStringList lines;
    for (const hid::Collection& one : parsed.collections)
        lines << QString("%1 %2 in %3").arg(one.usage, 0, 16).arg(one.type).arg(one.parent);
    for (const hid::Field& field : parsed.fields)
        lines << QString("%1%2 at %3: %4x%5 %6[%7] %8..%9")
                         .arg("iof"[static_cast<int>(field.kind)])
                         .arg(field.report_id)
                         .arg(field.bit_offset)
                         .arg(field.count)
                         .arg(field.bit_size)
                         .arg(field.constant   ? "-"
                              : field.array    ? "a"
                              : field.relative ? "r"
                                               : "")
                         .arg(usages_of(field))
                         .arg(field.logical_min)
                         .arg(field.logical_max) +
                     QString(" %1..%2 %3e%4")
                         .arg(field.physical_min)
                         .arg(field.physical_max)
                         .arg(field.unit, 0, 16)
                         .arg(field.unit_exponent);
    return lines;
}

} // namespace tp::testing
