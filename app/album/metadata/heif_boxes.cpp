// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/heif_boxes.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace tp {

namespace {

constexpr std::size_t most_boxes = 1'000;
constexpr std::uint64_t most_said = 1 << 20; ///< bytes of a list that is read; phones write some thousands

/// Numbers, the highest byte first; those beyond the end are 0.
class Numbers {
public:
    Numbers(const ByteSource& file, std::uint64_t begin, std::uint64_t size)
        : bytes_(static_cast<std::size_t>(
                     std::min({size, most_said, file.size() - std::min(begin, file.size())})),
                 '\0') {
        bytes_.resize(file.read(begin, bytes_));
    }
    Numbers(const ByteSource& file, const HeifBox& box) : Numbers(file, box.begin, box.size) {}

    bool at_end() const { return at_ >= bytes_.size(); }
    std::string_view bytes() const { return bytes_; }
    std::uint64_t next(int count) {
        std::uint64_t sum = 0;
        for (int i = 0; i < count; ++i, ++at_)
            sum = sum << 8 | (at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_]) : 0U);
        return sum;
    }

private:
    std::string bytes_;
    std::size_t at_ = 0;
};

/// Where a point goes, right and down: a turn by quarters, or a mirror image of one.
struct Turn {
    std::array<int, 4> at{1, 0, 0, 1}; ///< x from x, x from y; y from x, y from y
    bool operator==(const Turn&) const = default;
};

Turn then(const Turn& second, const Turn& first) {
    const auto& [a, b, c, d] = second.at;
    const auto& [e, f, g, h] = first.at;
    return {{a * e + b * g, a * f + b * h, c * e + d * g, c * f + d * h}};
}

constexpr Turn quarter_anticlockwise{{0, 1, -1, 0}};
constexpr std::array<Turn, 2> mirrored{Turn{{1, 0, 0, -1}}, Turn{{-1, 0, 0, 1}}}; ///< by imir's axis
/// From the stored picture to the upright one (EXIF 2.32, tag 0x0112): orientation 1 first. There are no others.
constexpr std::array<Turn, 8> exif_turns{Turn{{1, 0, 0, 1}},   Turn{{-1, 0, 0, 1}}, Turn{{-1, 0, 0, -1}},
                                         Turn{{1, 0, 0, -1}},  Turn{{0, 1, 1, 0}},  Turn{{0, -1, 1, 0}},
                                         Turn{{0, -1, -1, 0}}, Turn{{0, 1, -1, 0}}};

/// What a property does to a picture; nothing for most.
Turn turn_of(const ByteSource& file, const HeifBox& property) {
    if (property.type != "irot" && property.type != "imir")
        return {};
    const std::uint64_t value = Numbers(file, property.begin, 1).next(1);
    if (property.type == "imir")
        return mirrored[value & 1];
    Turn turn;
    for (std::uint64_t i = 0; i < (value & 3); ++i)
        turn = then(quarter_anticlockwise, turn);
    return turn;
}

/// All properties of an item, in their order (box ipma), as Turn.
Turn turn_of_item(const ByteSource& file, std::uint64_t item, const HeifBox& uses,
                  const std::vector<HeifBox>& properties) {
    Numbers numbers(file, uses);
    const std::uint64_t version = numbers.next(1), flags = numbers.next(3), count = numbers.next(4);
    for (std::uint64_t i = 0; i < count && !numbers.at_end(); ++i) {
        const bool meant = numbers.next(version < 1 ? 2 : 4) == item;
        Turn turn;
        for (std::uint64_t left = numbers.next(1); left > 0; --left) {
            // One bit says whether the property is essential; the rest is its number, 1 for the first.
            const std::uint64_t number = (flags & 1) != 0 ? numbers.next(2) & 0x7FFF : numbers.next(1) & 0x7F;
            if (meant && number >= 1 && number <= properties.size())
                turn = then(turn_of(file, properties[static_cast<std::size_t>(number - 1)]), turn);
        }
        if (meant)
            return turn;
    }
    return {};
}

} // namespace

std::vector<HeifBox> boxes_in(const ByteSource& file, std::uint64_t begin, std::uint64_t size) {
    std::vector<HeifBox> boxes;
    const std::uint64_t end = begin + std::min(size, file.size() - std::min(begin, file.size()));
    while (boxes.size() < most_boxes && begin + 8 <= end) {
        Numbers head(file, begin, 16);
        if (head.bytes().size() < 8) // a disk's fault
            break;
        std::uint64_t whole = head.next(4), head_size = 8;
        std::string type(head.bytes().substr(4, 4));
        head.next(4);
        if (whole == 1) {
            whole = head.next(8);
            head_size = 16;
        } else if (whole == 0) { // to the end
            whole = end - begin;
        }
        if (whole < head_size || whole > end - begin)
            break;
        boxes.push_back({std::move(type), begin + head_size, whole - head_size});
        begin += whole;
    }
    return boxes;
}

std::optional<HeifBox> box_of(std::string_view type, const std::vector<HeifBox>& boxes) {
    const auto found =
        std::find_if(boxes.begin(), boxes.end(), [&](const HeifBox& box) { return box.type == type; });
    return found == boxes.end() ? std::nullopt : std::optional(*found);
}

std::optional<int> heif_orientation(const ByteSource& file) {
    constexpr std::uint64_t version_and_flags = 4;
    const std::vector<HeifBox> top = boxes_in(file, 0, file.size());
    const auto meta = box_of("meta", top);
    if (top.empty() || top.front().type != "ftyp" || !meta || meta->size < version_and_flags)
        return std::nullopt;
    const auto inside = boxes_in(file, meta->begin + version_and_flags, meta->size - version_and_flags);
    const auto primary = box_of("pitm", inside), about = box_of("iprp", inside);
    if (!primary || !about)
        return std::nullopt;
    const auto lists = boxes_in(file, about->begin, about->size);
    const auto properties = box_of("ipco", lists), uses = box_of("ipma", lists);
    if (!properties || !uses)
        return std::nullopt;
    Numbers numbers(file, *primary);
    const std::uint64_t version = numbers.next(1);
    numbers.next(3);
    const std::uint64_t item = numbers.next(version == 0 ? 2 : 4);
    const Turn turn = turn_of_item(file, item, *uses, boxes_in(file, properties->begin, properties->size));
    return 1 + static_cast<int>(std::find(exif_turns.begin(), exif_turns.end(), turn) - exif_turns.begin());
}

} // namespace tp
