// SPDX-License-Identifier: Apache-2.0
#include "core/processes/our_programs.hpp"

#include <string>
#include <string_view>
#include <system_error>
#if defined(__APPLE__)
#include <cstdint>
#include <mach-o/dyld.h>
#endif

namespace tp {

std::filesystem::path this_program() {
    std::error_code problem;
#if defined(__APPLE__)
    std::uint32_t size = 0;
    _NSGetExecutablePath(nullptr, &size);
    std::string own_name(size + 1, '\0');
    _NSGetExecutablePath(own_name.data(), &size);
    return std::filesystem::canonical(own_name.c_str(), problem);
#else
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", problem);
    constexpr std::string_view replaced =
        " (deleted)"; // so Linux calls one that another lies in the place of
    std::string name = own.filename().string();
    if (!name.ends_with(replaced))
        return own;
    name.resize(name.size() - replaced.size());
    return own.parent_path() / name;
#endif
}

} // namespace tp
