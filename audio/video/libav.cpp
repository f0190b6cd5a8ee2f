// SPDX-License-Identifier: Apache-2.0
#include "audio/video/libav.hpp"

#include <dlfcn.h>

#include <optional>

namespace tp {

namespace {

std::optional<LibAv> loaded() {
    void* const library = dlopen(libav_name, RTLD_NOW | RTLD_LOCAL); // libavcodec and libavutil come with it
    if (library == nullptr)
        return std::nullopt;
    LibAv av;
    bool whole = true;
#define TP_FIND(name)                                                                                              \
    av.name = reinterpret_cast<decltype(av.name)>(dlsym(library, #name));                                          \
    whole = whole && av.name != nullptr;
    TP_FUNCTIONS_OF_LIBAV(TP_FIND)
#undef TP_FIND
    return whole ? std::optional(av) : std::nullopt;
}

} // namespace

#define TP_TEXT(number) #number
#define TP_TEXT_OF(macro) TP_TEXT(macro)
const char* const libav_name = "libavformat.so." TP_TEXT_OF(LIBAVFORMAT_VERSION_MAJOR);

const LibAv* load_libav() {
    static const std::optional<LibAv> av = loaded();
    return av ? &*av : nullptr;
}

} // namespace tp
