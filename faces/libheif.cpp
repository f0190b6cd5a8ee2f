// SPDX-License-Identifier: Apache-2.0
#include "faces/libheif.hpp"

#include <dlfcn.h>
#include <libheif/heif_version.h>
#include <optional>

namespace tp {
namespace {

static_assert(LIBHEIF_NUMERIC_VERSION >> 24 == 1, "the library of another version has another file name");

std::optional<LibHeif> loaded() {
    void* const library = dlopen("libheif.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        return std::nullopt;
    LibHeif heif;
    bool whole = true;
#define TP_FIND(name)                                                                                        \
    heif.name = reinterpret_cast<decltype(heif.name)>(dlsym(library, #name));                                \
    whole = whole && heif.name != nullptr;
    TP_FUNCTIONS_OF_LIBHEIF(TP_FIND)
#undef TP_FIND
    return whole ? std::optional(heif) : std::nullopt;
}

} // namespace

const LibHeif* load_libheif() {
    static const std::optional<LibHeif> heif = loaded();
    return heif ? &*heif : nullptr;
}

} // namespace tp
