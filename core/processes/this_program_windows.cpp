// SPDX-License-Identifier: Apache-2.0
#include "core/processes/our_programs.hpp"

#include <string>
#include <windows.h>

namespace tp {

std::filesystem::path this_program() {
    std::wstring own(32768, L'\0'); // the longest path there is
    own.resize(GetModuleFileNameW(nullptr, own.data(), static_cast<DWORD>(own.size())));
    return own;
}

} // namespace tp
