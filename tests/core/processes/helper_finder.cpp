// SPDX-License-Identifier: Apache-2.0
// Says in the file that its first word names where it looks for a helper. With a second word, only after its own file was
// replaced, as by an upgrade.
#include "core/processes/our_programs.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

int main(int count, char** words) {
    if (count == 3) {
        const fs::path own = words[0];
        const fs::path copy = own.string() + ".new";
        fs::copy_file(own, copy);
        std::error_code runs; // on Windows a program that does makes way only by another name
        fs::rename(copy, own, runs);
        if (runs) {
            fs::rename(own, own.string() + ".old");
            fs::rename(copy, own);
        }
    }
    if (count > 1)
        std::ofstream(words[1]) << tp::helper_program("helper").generic_string();
}
