// SPDX-License-Identifier: Apache-2.0
#pragma once

struct heif_decoder_plugin;

namespace tp {

/// A decoder of HEVC for libheif, by FFmpeg's libavcodec, which takes a third of the time of libheif's own,
/// libde265, for the same bits (the decoding of HEVC is normative, ISO/IEC 23008-2). libavcodec is loaded
/// when libheif first asks who decodes HEVC. Where it is not there, libheif takes its own. One thread, no
/// hardware; whatever libavcodec finds wrong is refused, for libheif's own to be asked.
const heif_decoder_plugin& hevc_decoder();

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
