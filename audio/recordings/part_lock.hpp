// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace tp {

/// The right to write a recording's part, or to take it away: held by who records into it and by who makes a
/// FLAC of it. It ends with its process, however that ends (flock), so what a crash left can be told from
/// what is being recorded.
class PartLock {
public:
    /// Nothing: somebody holds it, or the part is gone. An error is the end of a sentence.
    static Result<std::optional<PartLock>> take(const std::filesystem::path& part);
    PartLock(PartLock&& other) noexcept;
    PartLock& operator=(PartLock&&) = delete;
    ~PartLock();

    /// The part, open for reading and writing.
    int descriptor() const { return descriptor_; }

private:
    explicit PartLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_;
};

} // namespace tp
