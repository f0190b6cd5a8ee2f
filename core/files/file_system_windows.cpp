// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_windows.hpp"
#include "core/files/file_system.hpp"

#include <cerrno>
#include <windows.h>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::optional<FileFacts> facts_by_name(const fs::path& file, DWORD links) {
    const SystemFile opened(CreateFileW(file.c_str(), FILE_READ_ATTRIBUTES, shared_with_all, nullptr,
                                        OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | links, nullptr));
    if (!opened.ok()) {
        errno_of_last();
        return std::nullopt;
    }
    return facts_of_handle(opened.get());
}

int moved(const fs::path& from, const fs::path& to, DWORD how) {
    return MoveFileExW(from.c_str(), to.c_str(), how | MOVEFILE_WRITE_THROUGH) != 0 ? 0 : errno_of_last();
}

} // namespace

std::optional<FileFacts> facts_of(const fs::path& file) { return facts_by_name(file, 0); }

std::optional<FileFacts> facts_of_name(const fs::path& file) {
    return facts_by_name(file, FILE_FLAG_OPEN_REPARSE_POINT);
}

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

int remove_name(const fs::path& file) noexcept {
    return DeleteFileW(file.c_str()) != 0 ? 0 : errno_of_last();
}

HeldElsewhere::HeldElsewhere(const std::vector<fs::path>&) {}
HeldElsewhere::~HeldElsewhere() = default;

int make_directory(const fs::path& folder, Readers) {
    return CreateDirectoryW(folder.c_str(), nullptr) != 0 ? 0 : errno_of_last();
}

int names_to_disk(const fs::path&) {
    return 0;
} // NTFS writes them into its journal, and MoveFileEx waits for that

int copy_times(const OpenFile& from, const fs::path& to) {
    const auto facts = from.facts();
    if (!facts)
        return errno;
    const SystemFile file(
        CreateFileW(to.c_str(), FILE_WRITE_ATTRIBUTES, shared_with_all, nullptr, OPEN_EXISTING, 0, nullptr));
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
