// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/png_picture.hpp"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <new>
#include <png.h>
#include <string>
#include <string_view>
#include <vector>

namespace tp {
namespace {

constexpr std::size_t signature_size = 8, chunk_frame = 12; ///< bytes; length, type and checksum of a chunk
constexpr std::array<std::string_view, 5> needed{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};

const Error png_cut_short{"The PNG file is cut short: a part of the picture is missing."};
const Error damaged_png{"The PNG file is damaged."};

std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) << 24 | static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit)
            table[i] = table[i] & 1u ? (table[i] >> 1) ^ 0xEDB88320u : table[i] >> 1;
    }
    return table;
}

/// Cyclic redundancy code of the PNG specification, annex D.
std::uint32_t crc_of(const unsigned char* begin, const unsigned char* end) {
    static constexpr auto table = crc_table();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (; begin != end; ++begin)
        crc = table[(crc ^ *begin) & 0xFFu] ^ (crc >> 8);
    return ~crc;
}

/// libpng, reading from memory. It tells of a fault by a long jump, over which nothing with a destructor may live: each of
/// these functions is all that is jumped out of.
class PngRows {
public:
    explicit PngRows(const Bytes& bare)
        : at_(bare.data()), left_(bare.size()),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_fault, on_warning)),
          info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, &info_, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, this, hand_over);
    }
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;
    ~PngRows() { png_destroy_read_struct(&png_, &info_, nullptr); }

    /// From here on rows are of 8-bit BGR. False where the file is damaged.
    bool begin() {
        if (setjmp(png_jmpbuf(png_)) != 0) // NOLINT(cert-err52-cpp): libpng knows no other way
            return false;
        png_read_info(png_, info_);
        png_set_expand(png_);
        png_set_strip_16(png_);
        png_set_strip_alpha(png_);
        png_set_gray_to_rgb(png_);
        png_set_bgr(png_);
        passes_ = png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    /// How often all rows are read, each time into the same memory: 1, or 7 where they are interlaced.
    int passes() const { return passes_; }
    std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
    bool next(unsigned char* row) {
        if (setjmp(png_jmpbuf(png_)) != 0) // NOLINT(cert-err52-cpp)
            return false;
        png_read_row(png_, row, nullptr);
        return true;
    }

private:
    static void hand_over(png_structp png, png_bytep to, std::size_t count) {
        auto* const rows = static_cast<PngRows*>(png_get_io_ptr(png));
        if (count > rows->left_)
            on_fault(png, nullptr);
        std::memcpy(to, rows->at_, count);
        rows->at_ += count;
        rows->left_ -= count;
    }
    [[noreturn]] static void on_fault(png_structp png, png_const_charp) { png_longjmp(png, 1); }
    static void on_warning(png_structp, png_const_charp) {}

    const unsigned char* at_;
    std::size_t left_; ///< bytes
    png_structp png_;
    png_infop info_;
    int passes_ = 1;
};

/// Adds a row to sums of areas that are `shrink` px wide; the last one may be narrower.
void add_row(const unsigned char* row, std::size_t bytes, int shrink, std::vector<std::uint32_t>& sums) {
    const std::size_t step = std::size_t{3} * static_cast<std::size_t>(shrink);
    for (std::size_t begin = 0, to = 0; begin < bytes; begin += step, to += 3)
        for (std::size_t i = begin; i < std::min(begin + step, bytes); i += 3)
            for (std::size_t colour = 0; colour < 3; ++colour)
                sums[to + colour] += row[i + colour];
}

/// Of areas of `rows` rows, in a picture that is `width` px wide.
void average(const std::vector<std::uint32_t>& sums, int width, int shrink, int rows, unsigned char* to) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const int left = static_cast<int>(i / 3) * shrink;
        const auto area = static_cast<std::uint32_t>(std::min(shrink, width - left) * rows);
        to[i] = static_cast<unsigned char>((sums[i] + area / 2) / area);
    }
}

/// `next_row` gives the rows one after the other; null where there is no more.
template <typename NextRow>
Result<cv::Mat> averaged_areas(cv::Size size, int shrink, NextRow next_row) {
    cv::Mat small((size.height + shrink - 1) / shrink, (size.width + shrink - 1) / shrink, CV_8UC3);
    std::vector<std::uint32_t> sums(std::size_t{3} * static_cast<std::size_t>(small.cols));
    for (int y = 0; y < small.rows; ++y) {
        std::fill(sums.begin(), sums.end(), 0U);
        const int rows = std::min(shrink, size.height - y * shrink);
        for (int i = 0; i < rows; ++i) {
            const unsigned char* const row = next_row();
            if (row == nullptr)
                return damaged_png;
            add_row(row, std::size_t{3} * static_cast<std::size_t>(size.width), shrink, sums);
        }
        average(sums, size.width, shrink, rows, small.ptr(y));
    }
    return small;
}

Result<cv::Mat> all_rows(PngRows& rows, cv::Size size) {
    cv::Mat picture(size, CV_8UC3);
    for (int pass = 0; pass < rows.passes(); ++pass)
        for (int y = 0; y < size.height; ++y)
            if (!rows.next(picture.ptr(y)))
                return damaged_png;
    return picture;
}

} // namespace

Result<PngSize> png_size(const Bytes& bytes) {
    constexpr std::size_t width_at = 16, height_at = 20, needs = 24;
    if (bytes.size() < needs)
        return png_cut_short;
    if (std::string(&bytes[12], &bytes[16]) != needed.front())
        return damaged_png;
    return PngSize{number_at(bytes, width_at), number_at(bytes, height_at)};
}

Result<Bytes> bare_png(const Bytes& bytes) {
    Bytes bare(bytes.begin(), bytes.begin() + signature_size);
    bool has_pixels = false;
    std::size_t at = signature_size;
    while (at + chunk_frame <= bytes.size()) {
        const std::size_t length = number_at(bytes, at);
        if (length > bytes.size() - at - chunk_frame)
            break;
        const unsigned char* chunk = bytes.data() + at;
        const std::string type(chunk + 4, chunk + 8);
        at += chunk_frame + length;
        if (std::find(needed.begin(), needed.end(), type) == needed.end())
            continue;
        if (crc_of(chunk + 4, chunk + 8 + length) != number_at(bytes, at - 4))
            return damaged_png;
        bare.insert(bare.end(), chunk, bytes.data() + at);
        has_pixels = has_pixels || type == "IDAT";
        if (type == "IEND")
            return has_pixels ? Result<Bytes>(std::move(bare)) : damaged_png;
    }
    return png_cut_short;
}

Result<cv::Mat> decode_png(const Bytes& bare, cv::Size size, int shrink) {
    PngRows rows(bare);
    std::vector<unsigned char> row(std::size_t{3} * static_cast<std::size_t>(size.width));
    if (!rows.begin() || rows.row_bytes() != row.size())
        return damaged_png;
    if (shrink > 1 && rows.passes() == 1)
        return averaged_areas(size, shrink, [&] { return rows.next(row.data()) ? row.data() : nullptr; });
    const Result<cv::Mat> whole = all_rows(rows, size);
    if (!whole || shrink == 1)
        return whole;
    int y = 0;
    return averaged_areas(size, shrink, [&] { return whole->ptr(y++); });
}

} // namespace tp
