// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/libraries/loaded_library.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/frame.h>
#include <libavutil/log.h>
#include <libavutil/mem.h>
#include <libavutil/pixdesc.h>
}

namespace tp {

/// The functions of FFmpeg's libraries that a coded picture needs, by their own names.
struct LibAvCodec {
#define TP_FUNCTIONS_OF_LIBAVCODEC(each)                                                                     \
    each(av_frame_alloc) each(av_frame_free) each(av_grow_packet) each(av_log_set_level) each(av_mallocz)    \
        each(av_packet_alloc) each(av_packet_free) each(av_pix_fmt_desc_get) each(avcodec_alloc_context3)    \
            each(avcodec_find_decoder) each(avcodec_free_context) each(avcodec_open2)                        \
                each(avcodec_receive_frame) each(avcodec_send_packet)
    TP_LIBRARY_FUNCTIONS(TP_FUNCTIONS_OF_LIBAVCODEC)
};

/// Loads FFmpeg's libavcodec at the first call: 12 MB and 17 ms, for which other photographs have no use. It
/// is made to print nothing. Null where it is not there.
const LibAvCodec* load_libavcodec();

} // namespace tp
