// SPDX-License-Identifier: Apache-2.0
#include "core/files/durable_file.hpp"

#include "core/base/descriptor_posix.hpp"
#include "core/files/file_words.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::string copied(int from, NewFile& to) {
    std::array<char, 1 << 16> block;
    while (true) {
        const ssize_t count = ::read(from, block.data(), block.size());
        if (count < 0 && errno == EINTR)
            continue;
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
    const Descriptor source(::open(from.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat about {};
    if (!source.ok() || ::fstat(source.number(), &about) != 0)
        return "it cannot be read: " + reason_of(errno);
    if (!S_ISREG(about.st_mode))
        return quoted(from) + " is not a file.";
    auto copy = NewFile::beside(to, readers);
    if (!copy)
        return copy.error();
    if (std::string reason = copied(source.number(), *copy); !reason.empty())
        return reason;
    const std::array<timespec, 2> times{about.st_atim, about.st_mtim};
    if (::utimensat(AT_FDCWD, copy->temporary().c_str(), times.data(), 0) != 0)
        return reason_of(errno);
    return copy->take_place(Existing::kept);
}

std::string move_file(const fs::path& from, const fs::path& to) {
    const auto reason = [](int error) {
        return error == EXDEV ? std::string("they lie on different disks.") : reason_of(error);
    };
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) != 0) {
        if (errno != EINVAL && errno != ENOSYS)
            return reason(errno);
        struct stat there {}; // a file system without that flag
        if (::lstat(to.c_str(), &there) == 0)
            return reason_of(EEXIST);
        if (::rename(from.c_str(), to.c_str()) != 0)
            return reason(errno);
    }
    if (std::string failed = sync_folder(to.parent_path()); !failed.empty())
        return failed;
    return from.parent_path() == to.parent_path() ? std::string{} : sync_folder(from.parent_path());
}

std::string make_folder(const fs::path& folder, Readers readers) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error))
        return {};
    if (std::string reason = make_folder(folder.parent_path(), readers); !reason.empty())
        return reason;
    if (::mkdir(folder.c_str(), readers == Readers::owner_only ? 0700 : 0777) != 0 &&
        !(errno == EEXIST && fs::is_directory(folder, error)))
        return reason_of(errno);
    return sync_folder(folder.parent_path());
}

std::string sync_folder(const fs::path& folder) {
    const Descriptor directory(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!directory.ok()) // one that may be written to and not read
        return errno == EACCES ? std::string{} : reason_of(errno);
    if (::fsync(directory.number()) != 0 && errno != EINVAL && errno != EROFS)
        return reason_of(errno);
    return {};
}

bool name_taken(const fs::path& file) {
    std::error_code error;
    return fs::exists(fs::symlink_status(file, error));
}

} // namespace tp
