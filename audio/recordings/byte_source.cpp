// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/byte_source.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace tp {

std::size_t MemoryBytes::read(std::uint64_t at, std::span<char> to) const {
    if (at >= bytes_.size())
        return 0;
    return bytes_.copy(to.data(), to.size(), static_cast<std::size_t>(at));
}

PartOfBytes::PartOfBytes(std::unique_ptr<ByteSource> whole, std::uint64_t begin, std::uint64_t size)
    : whole_(std::move(whole)), begin_(std::min(begin, whole_->size())),
      size_(std::min(size, whole_->size() - begin_)) {}

std::size_t PartOfBytes::read(std::uint64_t at, std::span<char> to) const {
    if (at >= size_)
        return 0;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), size_ - at));
    return whole_->read(begin_ + at, to.first(count));
}

Result<std::unique_ptr<FileBytes>> FileBytes::open(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return Error{errno == ENOENT   ? "it does not exist."
                     : errno == EACCES ? "you are not allowed to read it."
                                       : reason_of(errno)};
    std::unique_ptr<FileBytes> bytes(new FileBytes(descriptor, true));
    if (std::string reason = bytes->measure(); !reason.empty())
        return Error{reason};
    return bytes;
}

Result<std::unique_ptr<FileBytes>> FileBytes::of(int descriptor) {
    std::unique_ptr<FileBytes> bytes(new FileBytes(descriptor, false));
    if (std::string reason = bytes->measure(); !reason.empty())
        return Error{reason};
    return bytes;
}

FileBytes::~FileBytes() {
    if (own_)
        ::close(descriptor_);
}

std::string FileBytes::measure() {
    struct stat about {};
    if (::fstat(descriptor_, &about) != 0)
        return reason_of(errno);
    if (!S_ISREG(about.st_mode))
        return "it is not a file.";
    size_ = static_cast<std::uint64_t>(about.st_size);
    return {};
}

std::size_t FileBytes::read(std::uint64_t at, std::span<char> to) const {
    std::size_t done = 0;
    while (done < to.size() && at + done < size_) {
        const std::size_t most =
            static_cast<std::size_t>(std::min<std::uint64_t>(to.size() - done, size_ - at - done));
        const ssize_t count = ::pread(descriptor_, to.data() + done, most, static_cast<off_t>(at + done));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

} // namespace tp
