// SPDX-License-Identifier: Apache-2.0
#include "core/files/first_line.hpp"

#include <fstream>
#include <system_error>

namespace tp {

std::string first_line(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return {};
    std::ifstream in(file, std::ios::binary);
    std::string line(longest_first_line, '\0');
    in.read(line.data(), static_cast<std::streamsize>(line.size()));
    line.resize(static_cast<std::size_t>(in.gcount()));
    return line.substr(0, line.find('\n'));
}

} // namespace tp
