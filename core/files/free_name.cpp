// SPDX-License-Identifier: Apache-2.0
#include "core/files/free_name.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>

namespace tp {

namespace fs = std::filesystem;

Result<fs::path> free_name(const std::function<std::vector<fs::path>(int number)>& names_of) {
    for (int number = 1;; ++number) {
        const std::vector<fs::path> names = names_of(number);
        bool free = true;
        for (const fs::path& name : names) {
            if (name_taken(name))
                free = false;
            else if (errno != ENOENT && errno != ENOTDIR)
                return Error{reason_of(errno)};
        }
        if (free)
            return names.front();
    }
}

} // namespace tp
