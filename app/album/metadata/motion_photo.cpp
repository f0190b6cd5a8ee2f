// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/motion_photo.hpp"

#include "app/album/metadata/heif_boxes.hpp"
#include "app/album/metadata/xmp_packet.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tp {

namespace {

constexpr int most_segments = 1'000;         // before the picture; real ones: about 20
constexpr std::uint64_t most_list = 1 << 16; // bytes of Samsung's list; real ones: some hundreds

const std::string camera_uri = "http://ns.google.com/photos/1.0/camera/";
const std::string container_uri = "http://ns.google.com/photos/1.0/container/";
const std::string item_uri = "http://ns.google.com/photos/1.0/container/item/";
const XmpName micro_video_offset{camera_uri, "MicroVideoOffset"};
const XmpName directory{container_uri, "Directory"};
const XmpName container_item{container_uri, "Item"};
const XmpName item_semantic{item_uri, "Semantic"};
const XmpName item_length{item_uri, "Length"};
const XmpName item_padding{item_uri, "Padding"};

/// The bytes there; fewer where the file ends.
std::string bytes_at(const ByteSource& source, std::uint64_t at, std::uint64_t count) {
    std::string bytes(static_cast<std::size_t>(std::min(count, source.size() - std::min(at, source.size()))),
                      '\0');
    bytes.resize(source.read(at, bytes));
    return bytes;
}

/// The number in those bytes of a text that has them.
std::uint32_t number(std::string_view text, std::size_t at, std::size_t count, bool little_endian) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto byte = static_cast<unsigned char>(text[at + i]);
        sum |= std::uint32_t{byte} << (8 * (little_endian ? i : count - 1 - i));
    }
    return sum;
}

/// The XMP in the segments before a JPEG's picture; empty where there is none.
std::string xmp_of(const ByteSource& jpeg) {
    constexpr std::string_view name("http://ns.adobe.com/xap/1.0/\0", 29);
    constexpr std::size_t head = 4; // marker and size
    if (bytes_at(jpeg, 0, 2) != "\xFF\xD8")
        return {};
    std::uint64_t at = 2;
    for (int i = 0; i < most_segments; ++i) {
        const std::string start = bytes_at(jpeg, at, head);
        if (start.size() < head || start[0] != '\xFF')
            return {};
        const auto marker = static_cast<unsigned char>(start[1]);
        if (marker == 0xFF) { // a byte to fill up with
            ++at;
            continue;
        }
        const std::uint32_t size = number(start, 2, 2, false);
        if (marker == 0xDA || marker == 0xD9 || size < 2) // the picture begins
            return {};
        if (marker == 0xE1) {
            const std::string body = bytes_at(jpeg, at + head, size - 2);
            if (body.starts_with(name))
                return body.substr(name.size());
        }
        at += 2 + size;
    }
    return {};
}

/// The number that is a text; none where it is anything else.
std::optional<std::uint64_t> number_in(const XmpValue* value) {
    if (value == nullptr || value->form != XmpValue::Form::text)
        return std::nullopt;
    const std::string& text = value->text;
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The part of a file of `size` bytes that ends `behind` bytes before the file does.
std::optional<VideoPlace> part_of(std::uint64_t size, std::uint64_t length, std::uint64_t behind) {
    if (length == 0 || length >= size || behind >= size - length)
        return std::nullopt;
    return VideoPlace{size - behind - length, length};
}

/// By the list of what lies behind the picture, in its order, to the file's end.
std::optional<VideoPlace> by_directory(const XmpValue& items, std::uint64_t file_size) {
    std::uint64_t behind = 0;
    for (auto item = items.items.rbegin(); item != items.items.rend(); ++item) {
        const XmpValue* inner = item->field(container_item);
        const XmpValue& about = inner != nullptr ? *inner : *item;
        const XmpValue* semantic = about.field(item_semantic);
        const auto length = number_in(about.field(item_length));
        const std::uint64_t padding = number_in(about.field(item_padding)).value_or(0);
        if (!length || *length > file_size || padding > file_size)
            return std::nullopt;
        behind += padding;
        if (semantic != nullptr && semantic->text == "MotionPhoto")
            return part_of(file_size, *length, behind);
        behind += *length;
        if (behind > file_size)
            return std::nullopt;
    }
    return std::nullopt;
}

std::optional<VideoPlace> by_xmp(const ByteSource& photo) {
    const std::string bytes = xmp_of(photo);
    if (bytes.empty())
        return std::nullopt;
    const auto packet = XmpPacket::from(bytes);
    if (!packet)
        return std::nullopt;
    if (const auto items = packet->value(directory))
        if (const auto place = by_directory(*items, photo.size()))
            return place;
    const auto offset = packet->value(micro_video_offset);
    const auto length = number_in(offset ? &*offset : nullptr);
    return length ? part_of(photo.size(), *length, 0) : std::nullopt;
}

/// By the list that Samsung's cameras put at the end: for each block its kind, how far before the list it
/// begins, and its size; then the list's own size, and "SEFT". A block has a head of its own, with its name.
std::optional<VideoPlace> by_samsung_list(const ByteSource& photo) {
    constexpr std::uint64_t end_size = 8;
    constexpr std::size_t list_head = 12, entry_size = 12, block_head = 8;
    constexpr std::string_view name = "MotionPhoto_Data";
    const std::uint64_t end_begin = photo.size() - std::min(photo.size(), end_size);
    const std::string end = bytes_at(photo, end_begin, end_size);
    if (end.size() < end_size || !end.ends_with("SEFT"))
        return std::nullopt;
    const std::uint64_t list_size = number(end, 0, 4, true);
    if (list_size < list_head || list_size > most_list || list_size > end_begin)
        return std::nullopt;
    const std::uint64_t list_begin = end_begin - list_size;
    const std::string list = bytes_at(photo, list_begin, list_size);
    if (list.size() < list_size || !list.starts_with("SEFH"))
        return std::nullopt;
    const std::uint64_t count = number(list, 8, 4, true);
    for (std::uint64_t i = 0; i < count && list_head + (i + 1) * entry_size <= list_size; ++i) {
        const std::size_t entry = list_head + static_cast<std::size_t>(i) * entry_size;
        const std::uint64_t back = number(list, entry + 4, 4, true),
                            block_size = number(list, entry + 8, 4, true);
        const std::uint64_t skipped = block_head + name.size();
        if (back > list_begin || block_size > back || block_size <= skipped)
            continue;
        const std::string head = bytes_at(photo, list_begin - back, skipped);
        if (head.size() == skipped && number(head, 4, 4, true) == name.size() && head.ends_with(name))
            return VideoPlace{list_begin - back + skipped, block_size - skipped};
    }
    return std::nullopt;
}

/// By the box for it beside those of a HEIC picture.
std::optional<VideoPlace> in_its_box(const ByteSource& photo) {
    const auto boxes = boxes_in(photo, 0, photo.size());
    const auto box = box_of("mpvd", boxes);
    return box && boxes.front().type == "ftyp"
               ? part_of(photo.size(), box->size, photo.size() - box->begin - box->size)
               : std::nullopt;
}

/// Whether an MP4 or QuickTime file begins there: ISO/IEC 14496-12, 4.3.
bool is_video(const ByteSource& photo, const VideoPlace& place) {
    constexpr std::size_t box_head = 8;
    const std::string head = bytes_at(photo, place.begin, std::min<std::uint64_t>(place.size, box_head));
    return head.size() == box_head && head.ends_with("ftyp");
}

} // namespace

std::optional<VideoPlace> video_inside(const ByteSource& photo) {
    const bool jpeg = bytes_at(photo, 0, 2) == "\xFF\xD8";
    using Places = std::vector<std::optional<VideoPlace>>;
    for (const auto& place : jpeg ? Places{by_xmp(photo), by_samsung_list(photo)} : Places{in_its_box(photo)})
        if (place && is_video(photo, *place))
            return place;
    return std::nullopt;
}

} // namespace tp
