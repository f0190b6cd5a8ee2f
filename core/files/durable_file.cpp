// SPDX-License-Identifier: Apache-2.0
#include "core/files/durable_file.hpp"

#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>
#include <cstdint>
#include <optional>
#include <system_error>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::string copied(OpenFile& from, NewFile& to) {
    std::vector<char> block(1 << 16);
    while (true) {
        const std::int64_t count = from.read(block);
        if (count < 0)
            return "it cannot be read: " + reason_of(errno);
        if (count == 0)
            return {};
        if (std::string reason = to.write({block.data(), static_cast<std::size_t>(count)}); !reason.empty())
            return reason;
    }
}

} // namespace

std::string replace_file(const fs::path& file, std::string_view bytes, Readers readers) {
    auto written = NewFile::beside(file, readers);
    if (!written)
        return written.error();
    if (std::string reason = written->write(bytes); !reason.empty())
        return reason;
    return written->take_place();
}

std::string copy_whole(const fs::path& from, const fs::path& to, Readers readers) {
    OpenFile source(from, {});
    const auto facts = source.ok() ? source.facts() : std::nullopt;
    if (!facts)
        return "it cannot be read: " + reason_of(errno);
    if (facts->kind != FileFacts::Kind::file)
        return quoted(from) + " is not a file.";
    auto copy = NewFile::beside(to, readers);
    if (!copy)
        return copy.error();
    if (std::string reason = copied(source, *copy); !reason.empty())
        return reason;
    if (const int error = copy_times(source, copy->temporary()); error != 0)
        return reason_of(error);
    return copy->take_place(Existing::kept);
}

std::string move_file(const fs::path& from, const fs::path& to) {
    if (const int error = move_to_free(from, to); error != 0)
        return error == EXDEV ? std::string("they lie on different disks.") : reason_of(error);
    if (std::string failed = sync_folder(to.parent_path()); !failed.empty())
        return failed;
    return from.parent_path() == to.parent_path() ? std::string{} : sync_folder(from.parent_path());
}

std::string make_folder(const fs::path& folder, Readers readers) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error))
        return {};
    if (!folder.has_relative_path()) // a disk that is not there
        return reason_of(ENOENT);
    if (std::string reason = make_folder(folder.parent_path(), readers); !reason.empty())
        return reason;
    const int made = make_directory(folder, readers);
    if (made != 0 && !(made == EEXIST && fs::is_directory(folder, error)))
        return reason_of(made);
    return sync_folder(folder.parent_path());
}

std::string sync_folder(const fs::path& folder) {
    const int error = names_to_disk(folder);
    return error == 0 ? std::string{} : reason_of(error);
}

bool name_taken(const fs::path& file) {
    std::error_code error;
    return fs::exists(fs::symlink_status(file, error));
}

} // namespace tp
