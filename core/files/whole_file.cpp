// SPDX-License-Identifier: Apache-2.0
#include "core/files/whole_file.hpp"

#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/open_file.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <new>

namespace tp {

namespace fs = std::filesystem;

namespace {

Error too_large(const fs::path& file, std::size_t most_bytes) {
    const std::size_t kilobytes = most_bytes / 1024;
    if (kilobytes < 1024)
        return Error{"The file " + quoted(file) + " is larger than " + std::to_string(kilobytes) +
                     " KB; that is more than such a file may be."};
    return Error{"The file " + quoted(file) + " is larger than " + std::to_string(kilobytes / 1024) +
                 " MB; that is more than such a file may be."};
}

} // namespace

Result<std::string> read_whole(const fs::path& file, std::size_t most_bytes) try {
    OpenFile opened(file, {});
    const int error = opened.ok() ? 0 : errno;
    if (error == EACCES && !facts_of_name(file) && errno == EACCES)
        return Error{"The file " + quoted(file) + " is in a folder that you are not allowed to open."};
    if (error == ELOOP)
        if (const auto link = link_on_the_way(file))
            return Error{left_alone(*link)};
    if (error == ENOENT || error == ENOTDIR || error == ELOOP)
        return Error{"There is no file " + quoted(file) + "."};
    const auto facts = opened.ok() ? opened.facts() : facts_of(file);
    if (facts && facts->kind != FileFacts::Kind::file)
        return Error{quoted(file) + (facts->kind == FileFacts::Kind::folder ? " is a folder, not a file."
                                                                            : " is not a file.")};
    if (!opened.ok() && is_disks_fault(error))
        return Error{"The file " + quoted(file) + " cannot be read: " + reason_of(error)};
    if (!opened.ok())
        return Error{"The file " + quoted(file) + " cannot be opened; you may not be allowed to read it."};
    std::string bytes;
    std::array<char, 65536> block{};
    while (true) {
        const std::int64_t count = opened.read(block);
        if (count < 0)
            return Error{"The file " + quoted(file) + " cannot be read to its end."};
        if (count == 0)
            return bytes;
        bytes.append(block.data(), static_cast<std::size_t>(count));
        if (bytes.size() > most_bytes)
            return too_large(file, most_bytes);
    }
} catch (const std::bad_alloc&) {
    return Error{"The file " + quoted(file) + " could not be read: there is not enough memory for it."};
}

} // namespace tp
