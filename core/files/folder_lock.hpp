// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>

namespace tp {

/// Held by one thread of one of our programs at a time, for reading a file of a folder and writing it
/// changed. Other programs do not know it. Nothing is left in the folder, and a process that dies lets go.
class FolderLock {
public:
    /// Waits for at most `patience`.
    explicit FolderLock(const std::filesystem::path& folder,
                        std::chrono::milliseconds patience = std::chrono::seconds(10));
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

    /// False where somebody else kept it all the time. True also where the file system knows no locks.
    bool held() const { return held_; }

private:
    int descriptor_ = -1;
    bool held_ = false;
};

} // namespace tp
