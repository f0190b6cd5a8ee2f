// SPDX-License-Identifier: Apache-2.0
#include "core/libraries/loaded_library.hpp"

#include <dlfcn.h>

namespace tp {

LoadedLibrary::LoadedLibrary(const char* file) : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {}

void* LoadedLibrary::address_of(const char* name) const {
    return handle_ == nullptr ? nullptr
                              : dlsym(handle_, name); // the libraries that it needs are searched too
}

} // namespace tp
