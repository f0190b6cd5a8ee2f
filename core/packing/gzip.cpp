// SPDX-License-Identifier: Apache-2.0
#include "core/packing/gzip.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <utility>
#include <zlib.h>

namespace tp {
namespace {

constexpr int gzip_window = 15 + 16; // 32 KB, with the header and trailer of gzip
constexpr int unknown_system = 255;
constexpr std::size_t most_at_once = std::size_t{1} << 30; // zlib counts in 32 bits

/// Hands zlib the next part of `rest`.
void feed(z_stream& stream, std::string_view& rest) {
    const std::size_t count = std::min(rest.size(), most_at_once);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest.data())); // zlib only reads there
    stream.avail_in = static_cast<uInt>(count);
    rest.remove_prefix(count);
}

} // namespace

std::string gzipped(std::string_view bytes) {
    z_stream stream{};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        return {};
    gz_header header{};
    header.os = unknown_system;
    deflateSetHeader(&stream, &header);
    std::string file;
    std::array<char, 1 << 16> block;
    int state = Z_OK;
    while (state != Z_STREAM_END) {
        if (stream.avail_in == 0)
            feed(stream, bytes);
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
        file.append(block.data(), block.size() - stream.avail_out);
    }
    deflateEnd(&stream);
    return file;
}

Result<std::string> gunzipped(std::string_view file, std::size_t most_bytes) try {
    z_stream stream{};
    if (inflateInit2(&stream, gzip_window) != Z_OK)
        return Error{"there is not enough memory for it."};
    struct End {
        z_stream& stream;
        ~End() { inflateEnd(&stream); }
    } const end{stream};
    std::string bytes;
    std::array<char, 1 << 16> block;
    while (true) {
        if (stream.avail_in == 0)
            feed(stream, file);
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        const int state = inflate(&stream, Z_NO_FLUSH);
        const std::size_t count = block.size() - stream.avail_out;
        if (count > most_bytes - bytes.size())
            return Error{"it holds more than such a file may."};
        bytes.append(block.data(), count);
        if (state == Z_STREAM_END)
            break;
        if (state == Z_BUF_ERROR ||
            (state == Z_OK && stream.avail_in == 0 && file.empty() && stream.avail_out > 0))
            return Error{"it ends too soon."};
        if (state != Z_OK)
            return Error{"it is damaged."};
    }
    if (stream.avail_in > 0 || !file.empty())
        return Error{"there is something behind its end."};
    return bytes;
} catch (const std::bad_alloc&) {
    return Error{"there is not enough memory for it."};
}

} // namespace tp
