// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

struct heif_decoder_plugin;

namespace tp {

/// A decoder of HEVC for libheif, by FFmpeg's libavcodec, which takes a third of the time of libheif's own,
/// libde265, for the same bits (the decoding of HEVC is normative, ISO/IEC 23008-2). libavcodec is loaded
/// when libheif first asks who decodes HEVC. Where it is not there, libheif takes its own. One thread, no
/// hardware; whatever libavcodec finds wrong is refused, for libheif's own to be asked.
const heif_decoder_plugin& hevc_decoder();

/// While one lives, pictures with 8 bits in full range and halved chroma, as phones write them, come from
/// hevc_decoder() as RGB already, where libheif decodes on this thread: libheif 1.15 takes three times as long for that, for the
/// same bits.
class HevcAsRgb {
public:
    /// How colours are coded is said by the file, because a decoder does not hear of it.
    explicit HevcAsRgb(std::optional<int> matrix);
    ~HevcAsRgb();
    HevcAsRgb(const HevcAsRgb&) = delete;
    HevcAsRgb& operator=(const HevcAsRgb&) = delete;

    static constexpr int as_the_stream_says = -1;
    /// What a file of these bytes says: a number of ITU-T H.273 (colour_shares), or nothing beside its streams. None
    /// where it says that values are not in full range, or different things of different pictures.
    static std::optional<int> matrix_of(std::string_view bytes);
};

/// Whether an error's message, libheif's, says that hevc_decoder() refused.
bool is_hevc_refused(const char* message);

/// While one lives, libheif does what this thread asks of it with its own decoder of HEVC.
class WithoutHevcDecoder {
public:
    WithoutHevcDecoder();
    ~WithoutHevcDecoder();
    WithoutHevcDecoder(const WithoutHevcDecoder&) = delete;
    WithoutHevcDecoder& operator=(const WithoutHevcDecoder&) = delete;
};

} // namespace tp
