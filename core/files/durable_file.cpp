// SPDX-License-Identifier: Apache-2.0
#include "core/files/durable_file.hpp"

#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"

#include <cerrno>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
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
    copy->no_more_open_than(from);
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
    if (folder.empty() || folder_there(folder))
        return {};
    if (!folder.has_relative_path()) // a disk that is not there
        return reason_of(ENOENT);
    if (const auto link = link_on_the_way(folder))
        return left_alone(*link);
    if (std::string reason = make_folder(folder.parent_path(), readers); !reason.empty())
        return reason;
    const int made = make_directory(folder, readers);
    if (made != 0 && !(made == EEXIST && folder_there(folder)))
        return reason_of(made);
    return sync_folder(folder.parent_path());
}

std::string sync_folder(const fs::path& folder) {
    const int error = names_to_disk(folder);
    return error == 0 ? std::string{} : reason_of(error);
}

std::string remove_file(const fs::path& file) {
    const int error = remove_name(file);
    if (error == ELOOP)
        return reason_of(ELOOP);
    return error == 0 || error == ENOENT ? sync_folder(file.parent_path()) : reason_of(error);
}

std::string remove_tree(const fs::path& folder) {
    const auto is = facts_of_name(folder);
    if (!is)
        return errno == ENOENT || errno == ENOTDIR ? std::string{} : reason_of(errno);
    if (is->kind == FileFacts::Kind::link)
        return left_alone(folder);
    if (is->kind != FileFacts::Kind::folder) {
        const int error = remove_name(folder);
        return error == 0 || error == ENOENT ? std::string{} : reason_of(error);
    }
    std::string first;
    const auto note = [&](std::string problem) {
        if (first.empty())
            first = std::move(problem);
    };
    int error = 0;
    const OpenFolder opened(folder);
    if (!opened.ok())
        return reason_of(errno);
    for (const FolderEntry& entry : opened.entries([](std::string_view) { return true; }, error))
        note(entry.link ? left_alone(folder / entry.name) : remove_tree(folder / entry.name));
    if (error != 0)
        note(reason_of(error));
    if (!first.empty())
        return first;
    error = remove_directory(folder);
    return error == 0 || error == ENOENT ? std::string{} : reason_of(error);
}

bool name_taken(const fs::path& file) { return facts_of_name(file).has_value(); }

bool is_gone(const fs::path& file) { return !facts_of_name(file) && (errno == ENOENT || errno == ENOTDIR); }

bool file_there(const fs::path& file) {
    const auto facts = facts_of(file);
    return facts && facts->kind == FileFacts::Kind::file;
}

bool folder_there(const fs::path& folder) {
    const auto facts = facts_of(folder);
    return facts && facts->kind == FileFacts::Kind::folder;
}

bool link_there(const fs::path& file) {
    const auto facts = facts_of_name(file);
    return facts && facts->kind == FileFacts::Kind::link;
}

bool photo_there(const fs::path& photo) {
    const auto facts = facts_of_photo(photo);
    return facts && facts->kind == FileFacts::Kind::file;
}

std::vector<FolderEntry> entries_of(const fs::path& folder, int* error) {
    int problem = 0;
    std::vector<FolderEntry> entries;
    if (const OpenFolder opened(folder.empty() ? fs::path(".") : folder);
        opened.ok() && opened.is_of_kernel())
        problem = ENXIO;
    else if (opened.ok())
        entries = opened.entries([](std::string_view) { return true; }, problem, true);
    else
        problem = errno;
    if (error)
        *error = problem;
    return entries;
}

} // namespace tp
