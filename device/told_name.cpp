// SPDX-License-Identifier: Apache-2.0
#include "device/told_name.hpp"

#include <cstddef>

namespace tp {

std::string told_name(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string name;
    for (const char letter : text)
        if (letter >= ' ' && letter <= '~' && letter != '"' && name.size() < longest)
            name += letter;
    const std::size_t first = name.find_first_not_of(' ');
    return first == name.npos ? std::string() : name.substr(first, name.find_last_not_of(' ') + 1 - first);
}

} // namespace tp
