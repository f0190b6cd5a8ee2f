// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/libavcodec.hpp"

#include <optional>

namespace tp {
namespace {

std::optional<LibAvCodec> quiet_libavcodec() {
    auto av = load_functions<LibAvCodec>(TP_LIBRARY_FILE("libavcodec", LIBAVCODEC_VERSION_MAJOR));
    if (av)
        av->av_log_set_level(AV_LOG_QUIET); // it would print on stderr; what is wrong is said by who asked
    return av;
}

} // namespace

const LibAvCodec* load_libavcodec() {
    static const std::optional<LibAvCodec> av = quiet_libavcodec();
    return av ? &*av : nullptr;
}

} // namespace tp
