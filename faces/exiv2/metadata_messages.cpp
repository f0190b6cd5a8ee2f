// SPDX-License-Identifier: Apache-2.0
#include "faces/exiv2/metadata_messages.hpp"

#include "core/processes/shared_memory.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr std::size_t most_answered_bytes = std::size_t{256} << 20;
constexpr std::size_t longest_said_at_once = longest_message - 64; ///< with what says where the rest lies
constexpr std::size_t most_places = 3;
constexpr std::int64_t metadata_of_file = 1; ///< the one thing that is asked: no message has no bytes

void add(MessageWriter& to, const std::vector<std::string>& texts) {
    to.add(static_cast<std::int64_t>(texts.size()));
    for (const std::string& text : texts)
        to.add(text);
}

/// None where they are more than there can be.
std::optional<std::vector<std::string>> texts_in(MessageReader& from, std::size_t most) {
    const auto count = static_cast<std::uint64_t>(from.number());
    if (count > most)
        return std::nullopt;
    std::vector<std::string> texts(static_cast<std::size_t>(count));
    for (std::string& text : texts)
        text = from.text();
    return texts;
}

void add(MessageWriter& to, std::optional<double> number) {
    to.add(std::int64_t{number ? 1 : 0}).add(std::bit_cast<std::int64_t>(number.value_or(0.0)));
}

std::optional<double> double_in(MessageReader& from) {
    const bool is_there = from.number() != 0;
    const auto number = std::bit_cast<double>(from.number());
    return is_there ? std::optional(number) : std::nullopt;
}

Message fields_of(const StatedMetadata& stated) {
    MessageWriter fields;
    fields.add(stated.width).add(stated.height).add(std::int64_t{stated.orientation.value_or(0)});
    add(fields, stated.latitude);
    add(fields, stated.longitude);
    for (const std::string* text :
         {&stated.taken, &stated.taken_offset, &stated.date, &stated.time, &stated.caption, &stated.xmp})
        fields.add(*text);
    add(fields, stated.keywords);
    add(fields, stated.places);
    for (const bool damaged :
         {stated.is_damaged, stated.exif_is_damaged, stated.xmp_is_damaged, stated.iptc_is_damaged})
        fields.add(std::int64_t{damaged ? 1 : 0});
    return fields.take();
}

std::optional<StatedMetadata> fields_in(Message& message) {
    MessageReader fields(message);
    StatedMetadata stated;
    stated.width = fields.number();
    stated.height = fields.number();
    if (const std::int64_t orientation = fields.number(); orientation >= 1 && orientation <= 8)
        stated.orientation = static_cast<int>(orientation);
    stated.latitude = double_in(fields);
    stated.longitude = double_in(fields);
    for (std::string* text :
         {&stated.taken, &stated.taken_offset, &stated.date, &stated.time, &stated.caption, &stated.xmp})
        *text = fields.text();
    auto keywords = texts_in(fields, most_stated_keywords);
    auto places = keywords ? texts_in(fields, most_places) : std::nullopt;
    if (!places)
        return std::nullopt;
    stated.keywords = *std::move(keywords);
    stated.places = *std::move(places);
    for (bool* damaged :
         {&stated.is_damaged, &stated.exif_is_damaged, &stated.xmp_is_damaged, &stated.iptc_is_damaged})
        *damaged = fields.number() != 0;
    const bool can_be = fields.whole() && stated.width >= 0 && stated.height >= 0;
    return can_be ? std::optional(std::move(stated)) : std::nullopt;
}

/// The bytes of another message, in it or in memory.
Message carried(const Message& message) {
    MessageWriter carrier;
    carrier.add(static_cast<std::int64_t>(message.bytes.size()));
    if (message.bytes.size() <= longest_said_at_once)
        return carrier
            .add(std::string_view(reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()))
            .take();
    const auto memory = SharedMemory::make(message.bytes.size());
    if (!memory)
        return carried({});
    std::memcpy(memory->data(), message.bytes.data(), message.bytes.size());
    return carrier.hand_over(memory->another()).take();
}

std::optional<Message> message_carried_by(Message& carrier) {
    MessageReader reader(carrier);
    const auto size = static_cast<std::uint64_t>(reader.number());
    Message message;
    if (!reader.has_descriptor()) {
        const std::string bytes = reader.text();
        message.bytes.assign(bytes.begin(), bytes.end());
        return reader.whole() && bytes.size() == size ? std::optional(std::move(message)) : std::nullopt;
    }
    const std::optional<Mapping> memory = received(reader.descriptor());
    if (!reader.whole() || !memory || size > most_answered_bytes || size > memory->size())
        return std::nullopt;
    const auto* const bytes = static_cast<const unsigned char*>(memory->data());
    message.bytes.assign(bytes, bytes + size);
    return message;
}

} // namespace

Message metadata_question(Descriptor file) {
    return MessageWriter().add(metadata_of_file).hand_over(std::move(file)).take();
}

std::optional<Message> metadata_answer(MessageReader& question) {
    const bool is_known = question.number() == metadata_of_file;
    const Descriptor file = question.descriptor();
    if (!is_known || !question.whole())
        return std::nullopt;
    try {
        const std::optional<Mapping> bytes = mapped_file(file);
        return message_of(bytes ? stated_in({static_cast<const unsigned char*>(bytes->data()), bytes->size()})
                                : std::nullopt);
    } catch (const std::bad_alloc&) {
        return message_of(std::nullopt);
    }
}

Message message_of(const std::optional<StatedMetadata>& stated) {
    return carried(stated ? fields_of(*stated) : Message());
}

std::optional<StatedMetadata> metadata_in(Message& answer) {
    std::optional<Message> fields = message_carried_by(answer);
    return fields && !fields->bytes.empty() ? fields_in(*fields) : std::nullopt;
}

} // namespace tp
