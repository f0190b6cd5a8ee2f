// SPDX-License-Identifier: Apache-2.0
#include "core/files/growing_file.hpp"

#include "core/base/result.hpp"
#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"

#include <cerrno>
#include <optional>

namespace tp {

namespace {

Result<std::uintmax_t> size_of(const OpenFile& file) {
    const auto facts = file.ok() ? file.facts() : std::nullopt;
    if (!facts)
        return errno == ENOENT ? Error{"it is gone."} : Error{reason_of(errno)};
    if (facts->kind != FileFacts::Kind::file)
        return Error{"it is not a file."};
    return std::uintmax_t{facts->bytes};
}

/// 0, or the system's error.
int written(OpenFile& file, std::string_view bytes) {
    const Written written = file.write(bytes);
    return written.error != 0 ? written.error : file.to_disk();
}

int cut(OpenFile& file, std::uintmax_t size) {
    const int error = file.cut(size);
    return error != 0 ? error : file.to_disk();
}

} // namespace

std::string append_to_file(const std::filesystem::path& path, std::uintmax_t size, std::string_view bytes) {
    OpenFile file(path, {.read = false, .write = true, .at_end = true});
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
    OpenFile file(path, {.read = false, .write = true});
    const auto is = size_of(file);
    if (!is)
        return is.error();
    if (*is < size)
        return changed_meanwhile;
    const int error = cut(file, size);
    return error == 0 ? std::string{} : reason_of(error);
}

} // namespace tp
