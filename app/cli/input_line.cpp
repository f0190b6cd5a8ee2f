// SPDX-License-Identifier: Apache-2.0
#include "app/cli/input_line.hpp"

namespace tp {

bool next_line(std::istream& in, std::string& line) {
    line.clear();
    char letter = 0;
    while (line.size() <= most_line_bytes && in.get(letter) && letter != '\n')
        line += letter;
    return !line.empty() || in.good();
}

} // namespace tp
