// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/byte_source.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>
#include <vector>

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
    OpenFile opened(file, {});
    if (!opened.ok())
        return Error{errno == ENOENT   ? "it does not exist."
                     : errno == EACCES ? "you are not allowed to read it."
                                       : reason_of(errno)};
    std::unique_ptr<FileBytes> bytes(new FileBytes(std::move(opened)));
    if (std::string reason = bytes->measure(); !reason.empty())
        return Error{reason};
    return bytes;
}

Result<std::unique_ptr<FileBytes>> FileBytes::of(const OpenFile& file) {
    std::unique_ptr<FileBytes> bytes(new FileBytes(&file));
    if (std::string reason = bytes->measure(); !reason.empty())
        return Error{reason};
    return bytes;
}

std::string FileBytes::measure() {
    const auto facts = file_->facts();
    if (!facts)
        return reason_of(errno);
    if (facts->kind != FileFacts::Kind::file)
        return "it is not a file.";
    size_ = facts->bytes;
    return {};
}

std::size_t FileBytes::read(std::uint64_t at, std::span<char> to) const {
    if (at >= size_)
        return 0;
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), size_ - at));
    const std::size_t done = file_->read_at(at, to.first(most));
    if (done < most && errno != 0) {
        int none = 0;
        fault_.compare_exchange_strong(none, errno);
    }
    return done;
}

std::string fault_in_reading(const std::filesystem::path& file) {
    const auto bytes = FileBytes::open(file);
    if (!bytes)
        return bytes.error();
    std::vector<char> block(1 << 16);
    for (std::uint64_t at = 0; at < (*bytes)->size() && (*bytes)->fault() == 0; at += block.size())
        (*bytes)->read(at, block);
    return (*bytes)->fault() != 0 ? reason_of((*bytes)->fault()) : std::string();
}

} // namespace tp
