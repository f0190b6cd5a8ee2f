// SPDX-License-Identifier: Apache-2.0
#include "core/files/growing_file.hpp"

#include "core/base/descriptor_posix.hpp"
#include "core/base/result.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tp {

namespace {

Result<std::uintmax_t> size_of(const Descriptor& file) {
    struct stat about {};
    if (!file.ok() || ::fstat(file.number(), &about) != 0)
        return errno == ENOENT ? Error{"it is gone."} : Error{reason_of(errno)};
    if (!S_ISREG(about.st_mode))
        return Error{"it is not a file."};
    return static_cast<std::uintmax_t>(about.st_size);
}

/// 0, or the system's error.
int written(const Descriptor& file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file.number(), bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR)
            return errno;
        if (count > 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return ::fsync(file.number()) == 0 ? 0 : errno;
}

int cut(const Descriptor& file, std::uintmax_t size) {
    if (::ftruncate(file.number(), static_cast<off_t>(size)) != 0 || ::fsync(file.number()) != 0)
        return errno;
    return 0;
}

} // namespace

std::string append_to_file(const std::filesystem::path& path, std::uintmax_t size, std::string_view bytes) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK));
    const auto is = size_of(file);
    if (!is)
        return is.error();
    if (*is != size)
        return changed_meanwhile;
    const int error = written(file, bytes);
    if (error == 0)
        return {};
    cut(file, size);
    return reason_of(error);
}

std::string cut_file(const std::filesystem::path& path, std::uintmax_t size) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK));
    const auto is = size_of(file);
    if (!is)
        return is.error();
    if (*is < size)
        return changed_meanwhile;
    const int error = cut(file, size);
    return error == 0 ? std::string{} : reason_of(error);
}

} // namespace tp
