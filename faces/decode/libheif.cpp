// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/libheif.hpp"

#include "faces/decode/hevc_decoder.hpp"

#include <libheif/heif_version.h>
#include <optional>

namespace tp {
namespace {

static_assert(LIBHEIF_NUMERIC_VERSION >> 24 == 1, "the library of another version has another file name");

std::optional<LibHeif> libheif_with_our_decoder() {
    auto heif = load_functions<LibHeif>("libheif.so.1");
    if (heif) {
        // Loads its own decoders where they are files beside it: later the process may open none (core/processes).
        heif->heif_init(nullptr);
        heif->heif_register_decoder_plugin(&hevc_decoder()); // where it will not, its own decoder remains
    }
    return heif;
}

} // namespace

const LibHeif* load_libheif() {
    static const std::optional<LibHeif> heif = libheif_with_our_decoder();
    return heif ? &*heif : nullptr;
}

} // namespace tp
