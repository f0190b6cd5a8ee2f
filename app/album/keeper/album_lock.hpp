// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>

namespace tp {

/// The right to change the files of one folder of an album: one program at a time reads, changes and writes.
/// It ends with its process, however that ends (flock). Held for moments only; who asks waits.
class AlbumLock {
public:
    /// An error is the end of a sentence.
    static Result<AlbumLock> take(const std::filesystem::path& album);
    AlbumLock(AlbumLock&& other) noexcept;
    AlbumLock& operator=(AlbumLock&&) = delete;
    ~AlbumLock();

private:
    explicit AlbumLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_;
};

} // namespace tp
