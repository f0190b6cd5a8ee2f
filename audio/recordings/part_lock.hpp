// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/files/open_file.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace tp {

/// The right to write a recording's part, or to take it away: held by who records into it and by who makes a
/// FLAC of it. It ends with its process, however that ends, so what a crash left can be told from
/// what is being recorded.
class PartLock {
public:
    /// Nothing: somebody holds it, or the part is gone. An error is the end of a sentence.
    static Result<std::optional<PartLock>> take(const std::filesystem::path& part);

    /// The part, open for reading and writing.
    const OpenFile& file() const { return file_; }

private:
    explicit PartLock(OpenFile file) : file_(std::move(file)) {}

    OpenFile file_;
};

} // namespace tp
