// SPDX-License-Identifier: Apache-2.0
#include "core/files/file_system.hpp"
#include "core/files/way_windows.hpp"

#include <cerrno>
#include <windows.h>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::optional<FileFacts> facts_by_name(const Way& way, DWORD links) {
    if (way.error() != 0) {
        errno = way.error();
        return std::nullopt;
    }
    const SystemFile opened(CreateFileW(way.path().c_str(), FILE_READ_ATTRIBUTES, shared_with_all, nullptr,
                                        OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | links, nullptr));
    if (!opened.ok()) {
        errno_of_last();
        return std::nullopt;
    }
    return facts_of_handle(opened.get());
}

int moved(const fs::path& from, const fs::path& to, DWORD how) {
    const Way one(from), other(to);
    if (const int error = one.refused(); error != 0)
        return error;
    if (const int error = how == MOVEFILE_REPLACE_EXISTING ? other.refused() : other.error(); error != 0)
        return error;
    return MoveFileExW(one.path().c_str(), other.path().c_str(), how | MOVEFILE_WRITE_THROUGH) != 0
               ? 0
               : errno_of_last();
}

} // namespace

std::optional<FileFacts> facts_of(const fs::path& file) {
    const Way way(file);
    return facts_by_name(way, way.no_links());
}

std::optional<FileFacts> facts_of_name(const fs::path& file) {
    return facts_by_name(Way(file), FILE_FLAG_OPEN_REPARSE_POINT);
}

std::optional<FileFacts> facts_of_photo(const fs::path& file) { return facts_by_name(Way(file), 0); }

int rename_over(const fs::path& from, const fs::path& to) {
    return moved(from, to, MOVEFILE_REPLACE_EXISTING);
}

int rename_to_free(const fs::path& from, const fs::path& to) { return moved(from, to, 0); }

int move_to_free(const fs::path& from, const fs::path& to) { return moved(from, to, 0); }

int swap_names(const fs::path& one, const fs::path& other) {
    if (!facts_of_name(one) || !facts_of_name(other))
        return errno;
    return ENOSYS;
}

int remove_name(const fs::path& file) noexcept try {
    const Way way(file);
    if (const int error = way.refused(); error != 0)
        return error;
    return DeleteFileW(way.path().c_str()) != 0 ? 0 : errno_of_last();
} catch (...) { // no memory for its name
    return ENOMEM;
}

int remove_directory(const fs::path& folder) {
    const Way way(folder);
    if (const int error = way.refused(); error != 0)
        return error;
    return RemoveDirectoryW(way.path().c_str()) != 0 ? 0 : errno_of_last();
}

// Who may read a file follows from its folder: a person's own are theirs alone.
bool open_to_others(const fs::path&) { return false; }
int only_for_owner(const fs::path&) { return 0; }
bool names_its_readers(const fs::path&) { return true; } // each takes over what its folder says
bool more_open_than(const fs::path&, const fs::path&) { return false; }
int no_more_open_than(const fs::path&, const fs::path&) { return 0; }

HeldElsewhere::HeldElsewhere(const std::vector<fs::path>&) {}
HeldElsewhere::~HeldElsewhere() = default;

int make_directory(const fs::path& folder, Readers) {
    const Way way(folder);
    if (way.error() != 0)
        return way.error();
    return CreateDirectoryW(way.path().c_str(), nullptr) != 0 ? 0 : errno_of_last();
}

int names_to_disk(const fs::path&) {
    return 0;
} // NTFS writes them into its journal, and MoveFileEx waits for that

int copy_times(const OpenFile& from, const fs::path& to) {
    const auto facts = from.facts();
    if (!facts)
        return errno;
    const Way way(to);
    if (way.error() != 0)
        return way.error();
    const SystemFile file(CreateFileW(way.path().c_str(), FILE_WRITE_ATTRIBUTES, shared_with_all, nullptr,
                                      OPEN_EXISTING, way.no_links(), nullptr));
    if (!file.ok())
        return errno_of_last();
    const FILETIME written = time_of(facts->written_ns);
    return SetFileTime(file.get(), nullptr, nullptr, &written) != 0 ? 0 : errno_of_last();
}

long this_process() { return static_cast<long>(GetCurrentProcessId()); }

bool process_lives(long number) {
    const HANDLE process = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(number));
    if (process == nullptr)
        return GetLastError() == ERROR_ACCESS_DENIED;
    const bool lives = WaitForSingleObject(process, 0) == WAIT_TIMEOUT;
    CloseHandle(process);
    return lives;
}

} // namespace tp
