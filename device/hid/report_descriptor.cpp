// SPDX-License-Identifier: Apache-2.0
#include "device/hid/report_descriptor.hpp"

#include <algorithm>
#include <utility>

namespace tp::hid {

namespace {

constexpr std::size_t most_depth = 32;
constexpr std::uint8_t long_item = 0xFE;

enum ItemType : std::uint8_t { main_item = 0, global_item = 1, local_item = 2 };

/// A short item (6.2.2.2).
struct Item {
    std::uint8_t type = 0;
    std::uint8_t tag = 0;
    std::uint8_t size = 0;  ///< bytes of data: 0, 1, 2 or 4
    std::uint32_t data = 0; ///< as an unsigned number

    std::int64_t as_signed() const {
        switch (size) {
        case 1:
            return static_cast<std::int8_t>(data);
        case 2:
            return static_cast<std::int16_t>(data);
        default:
            return static_cast<std::int32_t>(data);
        }
    }
};

/// A number whose sign only shows when the least of its range is known.
struct Bound {
    std::int64_t as_signed = 0;
    std::int64_t as_unsigned = 0;
};

struct Globals {
    std::uint32_t usage_page = 0;
    Bound logical_min, logical_max, physical_min, physical_max;
    std::uint32_t unit = 0;
    int unit_exponent = 0;
    std::uint32_t report_size = 0;
    std::uint32_t report_count = 0;
    std::uint8_t report_id = 0;
};

/// A usage as it stands in the descriptor: one without a page gets that of the main item.
struct LocalUsage {
    UsageRange range;
    bool has_page = false;
};

struct Locals {
    std::vector<LocalUsage> usages;
    std::uint32_t range_first = 0;
    bool range_begun = false;
    bool range_has_page = false;
    bool in_alternatives = false; ///< between delimiters
    bool alternative_taken = false;
};

int exponent_of(const Item& item) {
    if (item.data < 16) // a nibble with a sign (6.2.2.7)
        return item.data > 7 ? static_cast<int>(item.data) - 16 : static_cast<int>(item.data);
    return static_cast<int>(static_cast<std::int8_t>(item.data));
}

class DescriptorReader {
public:
    DescriptorReader(std::span<const std::uint8_t> bytes, ReportDescriptor& found)
        : bytes_(bytes), found_(found) {}

    DescriptorFault read() {
        if (bytes_.size() > most_descriptor_bytes)
            return DescriptorFault::too_long;
        while (!bytes_.empty()) {
            Item item;
            if (!next(item))
                return DescriptorFault::cut_short;
            if (const DescriptorFault fault = take(item); fault != DescriptorFault::none)
                return fault;
        }
        return open_.empty() ? DescriptorFault::none : DescriptorFault::collections_do_not_match;
    }

private:
    bool next(Item& item) {
        const std::uint8_t head = bytes_[0];
        if (head == long_item) { // none is defined: passed over
            if (bytes_.size() < 3 || bytes_.size() < 3u + bytes_[1])
                return false;
            bytes_ = bytes_.subspan(3u + bytes_[1]);
            item.type = 3;
            return true;
        }
        item.size = static_cast<std::uint8_t>((head & 3u) == 3u ? 4u : head & 3u);
        item.type = static_cast<std::uint8_t>(head >> 2 & 3u);
        item.tag = static_cast<std::uint8_t>(head >> 4);
        if (bytes_.size() < 1u + item.size)
            return false;
        for (std::size_t i = 0; i < item.size; ++i)
            item.data |= static_cast<std::uint32_t>(bytes_[1 + i]) << (8 * i);
        bytes_ = bytes_.subspan(1u + item.size);
        return true;
    }

    DescriptorFault take(const Item& item) {
        switch (item.type) {
        case main_item:
            return take_main(item);
        case global_item:
            return take_global(item);
        case local_item:
            take_local(item);
            return DescriptorFault::none;
        default: // reserved
            return DescriptorFault::none;
        }
    }

    DescriptorFault take_main(const Item& item) {
        DescriptorFault fault = DescriptorFault::none;
        switch (item.tag) {
        case 0x8:
            fault = add_field(ReportKind::input, item.data);
            break;
        case 0x9:
            fault = add_field(ReportKind::output, item.data);
            break;
        case 0xB:
            fault = add_field(ReportKind::feature, item.data);
            break;
        case 0xA:
            if (open_.size() >= most_depth)
                return DescriptorFault::too_deep;
            found_.collections.push_back({locals_.usages.empty() ? 0 : complete(locals_.usages.front()).first,
                                          static_cast<std::uint8_t>(item.data), innermost()});
            open_.push_back(static_cast<int>(found_.collections.size()) - 1);
            break;
        case 0xC:
            if (open_.empty())
                return DescriptorFault::collections_do_not_match;
            open_.pop_back();
            break;
        default:
            break;
        }
        locals_ = {};
        return fault;
    }

    DescriptorFault take_global(const Item& item) {
        const Bound bound{item.as_signed(), item.data};
        switch (item.tag) {
        case 0x0:
            globals_.usage_page = item.data & 0xFFFFu;
            break;
        case 0x1:
            globals_.logical_min = bound;
            break;
        case 0x2:
            globals_.logical_max = bound;
            break;
        case 0x3:
            globals_.physical_min = bound;
            break;
        case 0x4:
            globals_.physical_max = bound;
            break;
        case 0x5:
            globals_.unit_exponent = exponent_of(item);
            break;
        case 0x6:
            globals_.unit = item.data;
            break;
        case 0x7:
            globals_.report_size = item.data;
            break;
        case 0x8:
            if (item.data == 0 || item.data > 0xFF)
                return DescriptorFault::report_id_0;
            globals_.report_id = static_cast<std::uint8_t>(item.data);
            found_.numbered = true;
            break;
        case 0x9:
            globals_.report_count = item.data;
            break;
        case 0xA:
            if (saved_.size() >= most_depth)
                return DescriptorFault::too_deep;
            saved_.push_back(globals_);
            break;
        case 0xB:
            if (saved_.empty())
                return DescriptorFault::nothing_saved;
            globals_ = saved_.back();
            saved_.pop_back();
            break;
        default:
            break;
        }
        return DescriptorFault::none;
    }

    void take_local(const Item& item) {
        const bool has_page = item.size == 4;
        switch (item.tag) {
        case 0x0:
            add_usage({{item.data, item.data}, has_page});
            break;
        case 0x1:
            locals_.range_first = item.data;
            locals_.range_has_page = has_page;
            locals_.range_begun = true;
            break;
        case 0x2:
            if (locals_.range_begun && locals_.range_has_page == has_page && item.data >= locals_.range_first)
                add_usage({{locals_.range_first, item.data}, has_page});
            locals_.range_begun = false;
            break;
        case 0xA:
            locals_.in_alternatives = item.data == 1;
            locals_.alternative_taken = false;
            break;
        default: // designators and strings tell nothing that is needed here
            break;
        }
    }

    /// Of usages that stand for the same thing, the first is the preferred one (6.2.2.8).
    void add_usage(const LocalUsage& usage) {
        if (locals_.in_alternatives && std::exchange(locals_.alternative_taken, true))
            return;
        locals_.usages.push_back(usage);
    }

    UsageRange complete(const LocalUsage& usage) const {
        if (usage.has_page)
            return usage.range;
        return {usage_of(globals_.usage_page, usage.range.first),
                usage_of(globals_.usage_page, usage.range.last)};
    }

    int innermost() const { return open_.empty() ? -1 : open_.back(); }

    DescriptorFault add_field(ReportKind kind, std::uint32_t flags) {
        std::uint32_t& filled = found_.bits[static_cast<std::size_t>(kind)][globals_.report_id];
        const std::uint64_t wide = std::uint64_t{globals_.report_size} * globals_.report_count;
        if (wide + filled > most_report_bits)
            return DescriptorFault::report_too_long;
        Field field;
        field.kind = kind;
        field.report_id = globals_.report_id;
        field.bit_offset = filled;
        field.bit_size = globals_.report_size;
        field.count = globals_.report_count;
        field.constant = (flags & 1u) != 0;
        field.array = (flags & 2u) == 0;
        field.relative = (flags & 4u) != 0;
        const auto range = [](const Bound& least, const Bound& most, std::int64_t& min, std::int64_t& max) {
            min = least.as_signed;
            max = min < 0 ? most.as_signed : most.as_unsigned;
        };
        range(globals_.logical_min, globals_.logical_max, field.logical_min, field.logical_max);
        range(globals_.physical_min, globals_.physical_max, field.physical_min, field.physical_max);
        field.unit = globals_.unit;
        field.unit_exponent = globals_.unit_exponent;
        field.collection = innermost();
        for (const LocalUsage& usage : locals_.usages)
            field.usages.push_back(complete(usage));
        filled += static_cast<std::uint32_t>(wide);
        if (wide > 0)
            found_.fields.push_back(std::move(field));
        return DescriptorFault::none;
    }

    std::span<const std::uint8_t> bytes_;
    ReportDescriptor& found_;
    Globals globals_;
    Locals locals_;
    std::vector<Globals> saved_;
    std::vector<int> open_;
};

} // namespace

std::uint32_t Field::usage_at(std::uint32_t index) const {
    for (const UsageRange& range : usages) {
        const std::uint64_t several = std::uint64_t{range.last} - range.first + 1;
        if (index < several)
            return range.first + index;
        index -= static_cast<std::uint32_t>(several);
    }
    return usages.empty() ? 0 : usages.back().last;
}

std::int64_t Field::index_of(std::uint32_t usage) const {
    std::int64_t before = 0;
    for (const UsageRange& range : usages) {
        if (usage >= range.first && usage <= range.last)
            return before + (usage - range.first);
        before += std::int64_t{range.last} - range.first + 1;
    }
    return -1;
}

bool ReportDescriptor::within(int collection, std::uint32_t usage) const {
    for (; collection >= 0; collection = collections[static_cast<std::size_t>(collection)].parent)
        if (collections[static_cast<std::size_t>(collection)].usage == usage)
            return true;
    return false;
}

DescriptorFault parse_report_descriptor(std::span<const std::uint8_t> bytes, ReportDescriptor& found) {
    found = {};
    const DescriptorFault fault = DescriptorReader(bytes, found).read();
    if (fault != DescriptorFault::none)
        found = {};
    return fault;
}

} // namespace tp::hid
