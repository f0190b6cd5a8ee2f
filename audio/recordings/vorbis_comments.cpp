// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/vorbis_comments.hpp"

#include <algorithm>
#include <cstdint>

namespace tp {

namespace {

/// Takes what is there from the front of a block.
class Reader {
public:
    explicit Reader(std::string_view block) : rest_(block) {}

    std::optional<std::uint32_t> number() {
        if (rest_.size() < 4)
            return std::nullopt;
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(rest_[i]);
        rest_.remove_prefix(4);
        return value;
    }
    /// A text with its length before it.
    std::optional<std::string_view> text() {
        const auto length = number();
        if (!length || *length > rest_.size())
            return std::nullopt;
        const std::string_view result = rest_.substr(0, *length);
        rest_.remove_prefix(*length);
        return result;
    }

private:
    std::string_view rest_;
};

void add_number(std::string& to, std::size_t value) {
    for (int i = 0; i < 4; ++i)
        to.push_back(static_cast<char>(value >> (8 * i) & 0xFFu));
}

bool is_name(std::string_view name) {
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= 0x20 && c <= 0x7D && c != '='; });
}

} // namespace

bool same_field(std::string_view a, std::string_view b) {
    const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return upper(x) == upper(y); });
}

std::optional<std::string> VorbisComments::value(std::string_view name) const {
    for (const Field& field : fields)
        if (same_field(field.name, name))
            return field.value;
    return std::nullopt;
}

Result<VorbisComments> vorbis_comments(std::string_view block) {
    const Error damaged{"its comments are damaged."};
    Reader reader(block);
    VorbisComments comments;
    const auto vendor = reader.text();
    const auto count = reader.number();
    if (!vendor || !count)
        return damaged;
    comments.vendor = *vendor;
    for (std::uint32_t i = 0; i < *count; ++i) {
        const auto text = reader.text();
        if (!text)
            return damaged;
        const std::size_t equals = text->find('=');
        if (equals != std::string_view::npos && is_name(text->substr(0, equals)))
            comments.fields.push_back(
                {std::string(text->substr(0, equals)), std::string(text->substr(equals + 1))});
    }
    return comments;
}

Result<std::string> vorbis_comment_block(const VorbisComments& comments) {
    std::size_t size = 8 + comments.vendor.size();
    for (const auto& field : comments.fields)
        size += 5 + field.name.size() + field.value.size();
    if (size > most_comment_bytes)
        return Error{"its texts are too long."};
    std::string block;
    block.reserve(size);
    add_number(block, comments.vendor.size());
    block += comments.vendor;
    add_number(block, comments.fields.size());
    for (const auto& field : comments.fields) {
        add_number(block, field.name.size() + 1 + field.value.size());
        block += field.name;
        block += '=';
        block += field.value;
    }
    return block;
}

} // namespace tp
