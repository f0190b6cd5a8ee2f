// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/part_lock.hpp"

#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>
#include <utility>

namespace tp {

Result<std::optional<PartLock>> PartLock::take(const std::filesystem::path& part) {
    OpenFile file(part, {.write = true, .follow_link = false});
    if (!file.ok() && errno == ENOENT)
        return std::optional<PartLock>();
    if (!file.ok())
        return Error{errno == EISDIR || errno == ELOOP || errno == ENXIO ? "it is not a file."
                                                                         : reason_of(errno)};
    const auto open_one = file.facts();
    if (!open_one)
        return Error{reason_of(errno)};
    if (open_one->kind != FileFacts::Kind::file)
        return Error{"it is not a file."};
    if (!file.lock()) {
        if (errno == EWOULDBLOCK)
            return std::optional<PartLock>();
        return Error{reason_of(errno)};
    }
    const auto named_one = facts_of_name(part); // who held it before may have taken it away meanwhile
    if (!named_one && is_disks_fault(errno))
        return Error{reason_of(errno)};
    if (!named_one || named_one->identity != open_one->identity)
        return std::optional<PartLock>();
    return std::optional<PartLock>(PartLock(std::move(file)));
}

} // namespace tp
