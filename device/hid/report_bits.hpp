// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tp::hid {

/// Where one value lies in a report; a device may have no such value.
struct Slot {
    std::uint32_t bit = 0; ///< from the first bit behind the report id
    std::uint8_t size = 0; ///< bits, at most 32; 0: there is none
    std::int64_t least = 0;
    std::int64_t most = 0; ///< ≥ least; both fit into `size` bits

    constexpr bool there() const { return size > 0; }
    constexpr bool is_signed() const { return least < 0; }
};

/// The value in a report without its id; 0 where there is none, or where the report is too short for it.
constexpr std::int64_t value_in(std::span<const std::uint8_t> report, const Slot& slot) {
    if (!slot.there() || std::size_t{slot.bit} + slot.size > 8 * report.size())
        return 0;
    std::uint64_t bits = 0;
    for (std::uint32_t i = 0; i < slot.size; ++i) {
        const std::uint32_t at = slot.bit + i;
        bits |= static_cast<std::uint64_t>(report[at / 8] >> (at % 8) & 1u) << i;
    }
    const std::uint64_t sign = std::uint64_t{1} << (slot.size - 1u);
    if (slot.is_signed() && (bits & sign) != 0)
        bits |= ~(sign | (sign - 1));
    return static_cast<std::int64_t>(bits);
}

/// Puts the lowest bits of a value there and touches nothing else; nothing where there is no room for it.
constexpr void put_bits(std::span<std::uint8_t> report, const Slot& slot, std::uint64_t bits) {
    if (std::size_t{slot.bit} + slot.size > 8 * report.size())
        return;
    for (std::uint32_t i = 0; i < slot.size; ++i) {
        const std::uint32_t at = slot.bit + i;
        const auto mask = static_cast<std::uint8_t>(1u << (at % 8));
        report[at / 8] =
            static_cast<std::uint8_t>((bits >> i & 1u) != 0 ? report[at / 8] | mask : report[at / 8] & ~mask);
    }
}

/// The nearest value that the slot's range has.
constexpr void put_value(std::span<std::uint8_t> report, const Slot& slot, std::int64_t value) {
    const std::int64_t held = value < slot.least ? slot.least : value > slot.most ? slot.most : value;
    put_bits(report, slot, static_cast<std::uint64_t>(held));
}

} // namespace tp::hid
