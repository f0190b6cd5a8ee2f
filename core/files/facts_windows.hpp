// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/errors_windows.hpp"
#include "core/files/open_file.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <windows.h>

namespace tp {

/// A handle of Windows' that closes itself.
class SystemFile {
public:
    explicit SystemFile(HANDLE handle) : handle_(handle) {}
    SystemFile(const SystemFile&) = delete;
    SystemFile& operator=(const SystemFile&) = delete;
    ~SystemFile() {
        if (ok())
            CloseHandle(handle_);
    }
    bool ok() const { return handle_ != INVALID_HANDLE_VALUE; }
    HANDLE get() const { return handle_; }
    HANDLE release() { return std::exchange(handle_, INVALID_HANDLE_VALUE); }

private:
    HANDLE handle_;
};

/// What everybody may do with a file that is open here: it may be read, written, renamed and removed, as on POSIX.
inline constexpr DWORD shared_with_all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

inline constexpr std::int64_t ticks_to_1970 = 116'444'736'000'000'000; ///< Windows counts 100 ns since 1601

inline std::int64_t ns_of(const FILETIME& time) {
    const std::int64_t ticks =
        static_cast<std::int64_t>((std::uint64_t{time.dwHighDateTime} << 32) | time.dwLowDateTime);
    return (ticks - ticks_to_1970) * 100;
}

inline FILETIME time_of(std::int64_t ns) {
    const auto ticks = static_cast<std::uint64_t>(ns / 100 + ticks_to_1970);
    return {static_cast<DWORD>(ticks), static_cast<DWORD>(ticks >> 32)};
}

/// None, and `errno`, where Windows does not say. What is no file of a disk is `other`.
inline std::optional<FileFacts> facts_of_handle(HANDLE file) {
    FileFacts facts;
    if (GetFileType(file) != FILE_TYPE_DISK)
        return facts;
    BY_HANDLE_FILE_INFORMATION about{};
    if (GetFileInformationByHandle(file, &about) == 0) {
        errno_of_last();
        return std::nullopt;
    }
    FILE_ATTRIBUTE_TAG_INFO tag{};
    const bool link =
        (about.dwFileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
        GetFileInformationByHandleEx(file, FileAttributeTagInfo, &tag, sizeof tag) != 0 &&
        (tag.ReparseTag == IO_REPARSE_TAG_SYMLINK || tag.ReparseTag == IO_REPARSE_TAG_MOUNT_POINT);
    facts.kind = link                                                       ? FileFacts::Kind::link
                 : (about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileFacts::Kind::folder
                                                                            : FileFacts::Kind::file;
    facts.bytes = (std::uint64_t{about.nFileSizeHigh} << 32) | about.nFileSizeLow;
    facts.written_ns = ns_of(about.ftLastWriteTime);
    FILE_BASIC_INFO basic{};
    if (GetFileInformationByHandleEx(file, FileBasicInfo, &basic, sizeof basic) != 0)
        facts.changed_ns = ns_of({basic.ChangeTime.LowPart, static_cast<DWORD>(basic.ChangeTime.HighPart)});
    facts.identity = {about.dwVolumeSerialNumber,
                      (std::uint64_t{about.nFileIndexHigh} << 32) | about.nFileIndexLow};
    return facts;
}

} // namespace tp
