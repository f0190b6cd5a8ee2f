// SPDX-License-Identifier: Apache-2.0
#include "core/libraries/loaded_library.hpp"

#include <windows.h>

namespace tp {

// Beside the program and in Windows' own folders: not where the program happens to have been started.
LoadedLibrary::LoadedLibrary(const char* file)
    : handle_(LoadLibraryExA(file, nullptr, LOAD_LIBRARY_SEARCH_DEFAULT_DIRS)) {}

void* LoadedLibrary::address_of(const char* name) const {
    return handle_ == nullptr ? nullptr
                              : reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle_), name));
}

} // namespace tp
