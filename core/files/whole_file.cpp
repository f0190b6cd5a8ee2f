// SPDX-License-Identifier: Apache-2.0
#include "core/files/whole_file.hpp"

#include "core/files/file_words.hpp"

#include <array>
#include <fstream>
#include <new>
#include <system_error>

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
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (error == std::errc::permission_denied)
        return Error{"The file " + quoted(file) + " is in a folder that you are not allowed to open."};
    if (!fs::exists(status))
        return Error{"There is no file " + quoted(file) + "."};
    if (!fs::is_regular_file(status))
        return Error{quoted(file) +
                     (fs::is_directory(status) ? " is a folder, not a file." : " is not a file.")};
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return Error{"The file " + quoted(file) + " cannot be opened; you may not be allowed to read it."};
    std::string bytes;
    std::array<char, 65536> block{};
    while (stream) {
        stream.read(block.data(), block.size());
        bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > most_bytes)
            return too_large(file, most_bytes);
    }
    if (stream.bad())
        return Error{"The file " + quoted(file) + " cannot be read to its end."};
    return bytes;
} catch (const std::bad_alloc&) {
    return Error{"The file " + quoted(file) + " could not be read: there is not enough memory for it."};
}

} // namespace tp
