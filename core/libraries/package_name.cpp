// SPDX-License-Identifier: Apache-2.0
#include "core/libraries/package_name.hpp"

#include <algorithm>
#include <cctype>

namespace tp {

std::string debian_package(std::string_view library_file) {
    constexpr std::string_view ending = ".so"; // and a dot before the version
    const std::size_t end = library_file.find(ending);
    std::string name(library_file.substr(0, end));
    std::ranges::replace(name, '_', '-');
    if (end == std::string_view::npos || end + ending.size() == library_file.size())
        return name;
    if (std::isdigit(static_cast<unsigned char>(name.back())))
        name += '-';
    return name.append(library_file.substr(end + ending.size() + 1));
}

} // namespace tp
