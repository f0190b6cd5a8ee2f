// SPDX-License-Identifier: Apache-2.0
#include "audio/video/libav.hpp"

namespace tp {

const char* const libav_name = TP_LIBRARY_FILE("libavformat", LIBAVFORMAT_VERSION_MAJOR);

const LibAv* load_libav() {
    static const auto av = load_functions<LibAv>(libav_name); // libavcodec and libavutil come with it
    return av ? &*av : nullptr;
}

} // namespace tp
