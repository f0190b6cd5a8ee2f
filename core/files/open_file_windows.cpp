// SPDX-License-Identifier: Apache-2.0
#include "core/files/open_file.hpp"
#include "core/files/way_windows.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <io.h>
#include <limits>
#include <windows.h>

namespace tp {

namespace {

/// Far behind every file's end, because what Windows locks nobody else can read.
constexpr DWORD lock_place_high = 0x7FFFFFFF;

HANDLE handle_of(int number) { return reinterpret_cast<HANDLE>(_get_osfhandle(number)); }

OVERLAPPED place_at(std::uint64_t at) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(at);
    place.OffsetHigh = static_cast<DWORD>(at >> 32);
    return place;
}

DWORD most_at_once(std::size_t size) {
    return static_cast<DWORD>(std::min<std::size_t>(size, std::size_t{1} << 30));
}

DWORD disposition_of(const OpenMode& how) {
    if (how.make && how.only_new)
        return CREATE_NEW;
    if (how.make)
        return OPEN_ALWAYS;
    return OPEN_EXISTING;
}

/// Bytes read into `to`; false, and `errno`: a fault.
bool filled(HANDLE file, std::span<char> to, const std::uint64_t* at, std::size_t& done) {
    while (done < to.size()) {
        OVERLAPPED place = place_at(at != nullptr ? *at + done : 0);
        DWORD count = 0;
        if (ReadFile(file, to.data() + done, most_at_once(to.size() - done), &count,
                     at != nullptr ? &place : nullptr) == 0) {
            const DWORD error = GetLastError();
            if (error == ERROR_HANDLE_EOF || error == ERROR_BROKEN_PIPE)
                break;
            errno = errno_of(error);
            return false;
        }
        if (count == 0)
            break;
        done += count;
    }
    return true;
}

Written all_written(HANDLE file, std::string_view bytes, const std::uint64_t* at) {
    Written written;
    while (written.count < bytes.size()) {
        OVERLAPPED place = place_at(at != nullptr ? *at + written.count : 0);
        DWORD count = 0;
        if (WriteFile(file, bytes.data() + written.count, most_at_once(bytes.size() - written.count), &count,
                      at != nullptr ? &place : nullptr) == 0) {
            written.error = errno_of_last();
            break;
        }
        written.count += count;
    }
    return written;
}

bool locked(int number, DWORD how) {
    OVERLAPPED place{};
    place.OffsetHigh = lock_place_high;
    if (LockFileEx(handle_of(number), LOCKFILE_EXCLUSIVE_LOCK | how, 0, 1, 0, &place) != 0)
        return true;
    errno_of_last();
    return false;
}

} // namespace

// Who may read a file that is made follows from its folder: a person's own are theirs alone.
OpenFile::OpenFile(const std::filesystem::path& file, const OpenMode& how) {
    const Way way(file);
    if (way.error() != 0) {
        errno = way.error();
        return;
    }
    const bool follows = how.follow_link && (!way.foreign() || (how.looked_at && !how.write));
    const DWORD access = (how.read ? GENERIC_READ : FILE_READ_ATTRIBUTES) | (how.write ? GENERIC_WRITE : 0U);
    const DWORD links = follows ? 0 : FILE_FLAG_OPEN_REPARSE_POINT;
    const DWORD folders = how.write ? 0 : FILE_FLAG_BACKUP_SEMANTICS; // to be looked at, as on other systems
    SystemFile opened(CreateFileW(way.path().c_str(), access, shared_with_all, nullptr, disposition_of(how),
                                  FILE_ATTRIBUTE_NORMAL | links | folders, nullptr));
    if (!opened.ok()) {
        const int error = errno_of_last();
        const DWORD attributes = GetFileAttributesW(way.path().c_str());
        if (error == EACCES && attributes != INVALID_FILE_ATTRIBUTES &&
            (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
            errno = EISDIR;
        else
            errno = error;
        return;
    }
    if (!follows) {
        const auto facts = facts_of_handle(opened.get());
        if (!facts || facts->kind == FileFacts::Kind::link) {
            errno = ELOOP;
            return;
        }
    }
    if (way.foreign()) {
        BY_HANDLE_FILE_INFORMATION about{};
        const bool known = GetFileType(opened.get()) == FILE_TYPE_DISK &&
                           GetFileInformationByHandle(opened.get(), &about) != 0;
        if (!known || (how.write && about.nNumberOfLinks > 1)) {
            errno = known ? EMLINK : ENXIO;
            return;
        }
    }
    if (how.emptied && SetEndOfFile(opened.get()) == 0) {
        errno_of_last();
        return;
    }
    const int flags = (how.write ? (how.read ? _O_RDWR : _O_WRONLY) : _O_RDONLY) |
                      (how.at_end ? _O_APPEND : 0) | _O_BINARY | _O_NOINHERIT;
    number_ = _open_osfhandle(reinterpret_cast<intptr_t>(opened.get()), flags);
    if (number_ >= 0)
        static_cast<void>(opened.release());
}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
    close();
    number_ = other.release();
    return *this;
}

void OpenFile::close() {
    if (ok())
        _close(release());
}

Descriptor OpenFile::handed_over() {
    HANDLE another = nullptr;
    const bool made = ok() && DuplicateHandle(GetCurrentProcess(), handle_of(number_), GetCurrentProcess(),
                                              &another, 0, FALSE, DUPLICATE_SAME_ACCESS) != 0;
    close();
    return made ? Descriptor(reinterpret_cast<DescriptorNumber>(another)) : Descriptor();
}

std::optional<FileFacts> OpenFile::facts() const { return facts_of_handle(handle_of(number_)); }

std::filesystem::path OpenFile::name_of_opened() const { return {}; }

std::int64_t OpenFile::read(std::span<char> to) {
    std::size_t done = 0;
    return filled(handle_of(number_), to, nullptr, done) ? static_cast<std::int64_t>(done) : -1;
}

std::size_t OpenFile::read_at(std::uint64_t at, std::span<char> to) const {
    return tp::read_at(reinterpret_cast<DescriptorNumber>(handle_of(number_)), at, to);
}

Written OpenFile::write(std::string_view bytes) {
    Written written;
    while (written.count < bytes.size()) { // by the library, which goes to the end where that was asked for
        const std::size_t most =
            std::min<std::size_t>(bytes.size() - written.count, std::numeric_limits<int>::max());
        const int count = _write(number_, bytes.data() + written.count, static_cast<unsigned>(most));
        if (count <= 0) {
            written.error = count < 0 ? errno : ENOSPC;
            break;
        }
        written.count += static_cast<std::size_t>(count);
    }
    return written;
}

Written OpenFile::write_at(std::uint64_t at, std::string_view bytes) const {
    return all_written(handle_of(number_), bytes, &at);
}

std::int64_t OpenFile::go_to(std::int64_t offset, int from) { return _lseeki64(number_, offset, from); }

int OpenFile::cut(std::uint64_t bytes) {
    FILE_END_OF_FILE_INFO end{};
    end.EndOfFile.QuadPart = static_cast<LONGLONG>(bytes);
    return SetFileInformationByHandle(handle_of(number_), FileEndOfFileInfo, &end, sizeof end) != 0
               ? 0
               : errno_of_last();
}

int OpenFile::to_disk() const { return FlushFileBuffers(handle_of(number_)) != 0 ? 0 : errno_of_last(); }

int OpenFile::bytes_to_disk() const { return to_disk(); }

int OpenFile::bytes_out_of_memory() const { return to_disk(); }

void OpenFile::give_readers_of(const std::filesystem::path&) const {}
void OpenFile::no_more_open_than(const std::filesystem::path&) const {}

bool OpenFile::lock() const { return locked(number_, LOCKFILE_FAIL_IMMEDIATELY); }

bool OpenFile::wait_for_lock() const { return locked(number_, 0); }

std::size_t read_at(DescriptorNumber file, std::uint64_t at, std::span<char> to) {
    std::size_t done = 0;
    if (filled(reinterpret_cast<HANDLE>(file), to, &at, done))
        errno = 0;
    return done;
}

} // namespace tp
