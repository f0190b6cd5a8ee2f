// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/libraries/loaded_library.hpp"

#include <libheif/heif.h>
#include <libheif/heif_plugin.h>

namespace tp {

/// The functions of libheif that a photograph needs, by their own names.
struct LibHeif {
#define TP_FUNCTIONS_OF_LIBHEIF(each)                                                                        \
    each(heif_context_alloc) each(heif_context_free) each(heif_context_get_primary_image_handle) each(       \
        heif_context_read_from_memory_without_copy) each(heif_context_set_max_decoding_threads)              \
        each(heif_context_set_maximum_image_size_limit) each(heif_decode_image) each(                        \
            heif_decoder_descriptor_get_id_name) each(heif_decoding_options_alloc)                           \
            each(heif_decoding_options_free) each(heif_get_decoder_descriptors) each(                        \
                heif_image_add_plane) each(heif_image_create) each(heif_image_get_bits_per_pixel_range)      \
                each(heif_image_get_height) each(heif_image_get_nclx_color_profile) each(                    \
                    heif_image_get_plane) each(heif_image_get_plane_readonly) each(heif_image_get_width)     \
                    each(heif_image_handle_get_height) each(heif_image_handle_get_ispe_height) each(         \
                        heif_image_handle_get_ispe_width) each(heif_image_handle_get_list_of_thumbnail_IDs)  \
                        each(heif_image_handle_get_thumbnail) each(heif_image_handle_get_width)              \
                            each(heif_image_handle_release) each(heif_image_release)                         \
                                each(heif_image_set_nclx_color_profile) each(heif_init)                      \
                                    each(heif_nclx_color_profile_alloc) each(heif_nclx_color_profile_free)   \
                                        each(heif_nclx_color_profile_set_color_primaries)                    \
                                            each(heif_nclx_color_profile_set_matrix_coefficients)            \
                                                each(heif_nclx_color_profile_set_transfer_characteristics)   \
                                                    each(heif_register_decoder_plugin)
    TP_LIBRARY_FUNCTIONS(TP_FUNCTIONS_OF_LIBHEIF)
};

/// Loads libheif at the first call, and not at the program's start: with its decoders come twelve libraries,
/// for which other photographs have no use. Null where it is not there.
const LibHeif* load_libheif();

} // namespace tp
