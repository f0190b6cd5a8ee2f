// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/jpeg_picture.hpp"

#include <turbojpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace tp {
namespace {

constexpr unsigned char end_of_image = 0xD9, start_of_scan = 0xDA, adobe_segment = 0xEE;

bool has_no_length(unsigned char marker) {
    return marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8) || marker == 0x00;
}

bool is_frame_header(unsigned char marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

bool ends_properly(const Bytes& bytes, std::size_t from) {
    constexpr unsigned char marker[] = {0xFF, end_of_image};
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(from);
    return std::search(begin, bytes.end(), std::begin(marker), std::end(marker)) != bytes.end();
}

/// Each scan goes over the whole picture, be it empty: hundreds of them in a file of some kilobytes take minutes.
bool has_too_many_scans(const Bytes& bytes, std::size_t from) {
    constexpr int most_scans = 100; // programs write ten or so
    int scans = 1;
    for (std::size_t i = from; i + 1 < bytes.size() && scans <= most_scans; ++i) {
        const void* const found = std::memchr(&bytes[i], 0xFF, bytes.size() - 1 - i);
        if (found == nullptr)
            break;
        i = static_cast<std::size_t>(static_cast<const unsigned char*>(found) - bytes.data());
        scans += bytes[i + 1] == start_of_scan ? 1 : 0;
    }
    return scans > most_scans;
}

struct Closer {
    void operator()(void* handle) const { tjDestroy(handle); }
};
using Decoder = std::unique_ptr<void, Closer>;

const Error jpeg_cut_short{"The JPEG file is cut short: a part of the picture is missing."};
const Error damaged_jpeg{"The JPEG file is damaged."};

/// Each channel times black: the paper white minus the ink, ink over ink.
cv::Mat from_cmyk(const cv::Mat& cmyk, bool inverted) {
    cv::Mat bgr(cmyk.size(), CV_8UC3);
    const int flip = inverted ? 0 : 255;
    for (int y = 0; y < cmyk.rows; ++y) {
        const unsigned char* from = cmyk.ptr(y);
        unsigned char* to = bgr.ptr(y);
        for (int x = 0; x < cmyk.cols; ++x, from += 4, to += 3) {
            const int light = from[3] ^ flip;
            for (int channel = 0; channel < 3; ++channel)
                to[2 - channel] = static_cast<unsigned char>(((from[channel] ^ flip) * light + 127) / 255);
        }
    }
    return bgr;
}

/// libjpeg keeps the first thing it finds odd. These mean that pixels are wrong; the others are harmless.
Error judged(std::string_view warning) {
    if (warning.find("Premature end of JPEG file") != std::string_view::npos)
        return jpeg_cut_short;
    for (std::string_view harm :
         {"premature end of data segment", "bad Huffman code", "bad arithmetic code", "instead of RST"})
        if (warning.find(harm) != std::string_view::npos)
            return damaged_jpeg;
    return {};
}

} // namespace

JpegHeader jpeg_header(const Bytes& bytes) {
    JpegHeader header;
    std::size_t at = 2;
    while (at + 4 <= bytes.size()) {
        if (bytes[at] != 0xFF || bytes[at + 1] == 0xFF) { // stray or fill bytes
            ++at;
            continue;
        }
        const unsigned char marker = bytes[at + 1];
        if (has_no_length(marker)) {
            at += 2;
            continue;
        }
        if (marker == end_of_image)
            break;
        const auto two_bytes = [&](std::size_t i) { return bytes[i] << 8 | bytes[i + 1]; };
        const std::size_t length = static_cast<std::size_t>(two_bytes(at + 2));
        if (is_frame_header(marker) && at + 9 <= bytes.size()) {
            header.height = two_bytes(at + 5);
            header.width = two_bytes(at + 7);
        }
        if (marker == adobe_segment && length >= 7 && at + 9 <= bytes.size())
            header.adobe =
                header.adobe || std::string_view("Adobe") == std::string(&bytes[at + 4], &bytes[at + 9]);
        at += 2 + length;
        if (marker == start_of_scan) {
            header.scan = std::min(at, bytes.size());
            break;
        }
    }
    return header;
}

Result<cv::Mat> decode_jpeg(const Bytes& bytes, const JpegHeader& header, int shrink, JpegDamage damage) {
    if (header.scan == 0)
        return jpeg_cut_short;
    if (has_too_many_scans(bytes, header.scan))
        return Error{
            "The JPEG file goes over its picture more often than any program does; it was not read."};
    const Decoder decoder(tjInitDecompress());
    if (!decoder)
        return Error{"There is not enough memory for this picture."};
    const auto size = static_cast<unsigned long>(bytes.size());
    int width = 0, height = 0, subsampling = 0, colours = 0;
    if (tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &subsampling, &colours) !=
            0 &&
        tjGetErrorCode(decoder.get()) == TJERR_FATAL)
        return damaged_jpeg;
    if (width != header.width || height != header.height)
        return damaged_jpeg;
    const bool cmyk = colours == TJCS_CMYK || colours == TJCS_YCCK;
    const tjscalingfactor scale{1, shrink};
    cv::Mat pixels(TJSCALED(height, scale), TJSCALED(width, scale), cmyk ? CV_8UC4 : CV_8UC3);
    if (tjDecompress2(decoder.get(), bytes.data(), size, pixels.data, pixels.cols,
                      static_cast<int>(pixels.step), pixels.rows, cmyk ? TJPF_CMYK : TJPF_BGR,
                      TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) != 0) {
        if (tjGetErrorCode(decoder.get()) == TJERR_FATAL)
            return damaged_jpeg;
        const Error harm = judged(tjGetErrorStr2(decoder.get()));
        if (damage == JpegDamage::refused && !harm.sentence.empty())
            return harm;
        if (damage == JpegDamage::refused && !ends_properly(bytes, header.scan))
            return jpeg_cut_short;
    }
    return cmyk ? from_cmyk(pixels, header.adobe) : pixels;
}

} // namespace tp
