// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/libraries/loaded_library.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavformat/avio.h>
#include <libavutil/display.h>
#include <libavutil/error.h>
#include <libavutil/frame.h>
#include <libavutil/log.h>
#include <libavutil/mathematics.h>
#include <libavutil/mem.h>
#include <libavutil/pixdesc.h>
#include <libavutil/samplefmt.h>
}

namespace tp {

// FFmpeg 7 keeps a stream's side data with its parameters.
#if LIBAVFORMAT_VERSION_MAJOR >= 61
#define TP_SIDE_DATA_OF_LIBAV(each) each(av_packet_side_data_get)
#else
#define TP_SIDE_DATA_OF_LIBAV(each) each(av_stream_get_side_data)
#endif

/// The functions of FFmpeg's libraries that the sound and the pictures of a video need, by their own names.
struct LibAv {
#define TP_FUNCTIONS_OF_LIBAV(each)                                                                          \
    each(av_display_rotation_get) each(av_find_best_stream) each(av_find_input_format) each(av_frame_alloc)  \
        each(av_frame_free) each(av_freep) each(av_get_packed_sample_fmt) each(av_log_set_level)             \
            each(av_malloc) each(av_max_alloc) each(av_packet_alloc) each(av_packet_free)                    \
                each(av_packet_unref) each(av_pix_fmt_desc_get) each(av_read_frame) each(av_rescale_q)       \
                    each(av_sample_fmt_is_planar) TP_SIDE_DATA_OF_LIBAV(each) each(avcodec_alloc_context3)   \
                        each(avcodec_find_decoder) each(avcodec_free_context) each(avcodec_get_name)         \
                            each(avcodec_open2) each(avcodec_parameters_to_context)                          \
                                each(avcodec_receive_frame) each(avcodec_send_packet)                        \
                                    each(avformat_alloc_context) each(avformat_close_input)                  \
                                        each(avformat_open_input) each(avio_alloc_context)                   \
                                            each(avio_context_free)
    TP_LIBRARY_FUNCTIONS(TP_FUNCTIONS_OF_LIBAV)
};

/// The file name of the library that is loaded, of the version that this program was built for.
extern const char* const libav_name;

/// Loads FFmpeg's libraries at the first call, and not at the program's start: with all that they bring along they take
/// 17 MB, and most who use this program never import a video. Null where they are not there.
const LibAv* load_libav();

} // namespace tp
