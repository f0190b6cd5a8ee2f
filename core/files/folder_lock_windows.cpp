// SPDX-License-Identifier: Apache-2.0
// Windows locks no folders. A file that bears the folder's number stands for it among the person's temporary files; it is
// open for one opening at a time, and gone when that is closed or its process dies.
#include "core/files/facts_windows.hpp"
#include "core/files/file_system.hpp"
#include "core/files/folder_lock.hpp"

#include <fcntl.h>
#include <io.h>
#include <string>
#include <thread>
#include <windows.h>

namespace tp {

namespace {

std::filesystem::path file_for(const FileFacts& folder) {
    return std::filesystem::temp_directory_path() /
           ("touchphoto-lock-" + std::to_string(folder.identity.first) + "-" +
            std::to_string(folder.identity.second));
}

} // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, std::chrono::milliseconds patience) {
    const auto facts = facts_of(folder.empty() ? "." : folder);
    if (!facts) { // none: writing will tell
        held_ = true;
        return;
    }
    const std::filesystem::path file = file_for(*facts);
    constexpr std::chrono::milliseconds pause(2);
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        SystemFile opened(CreateFileW(file.c_str(), GENERIC_WRITE, 0, nullptr, OPEN_ALWAYS,
                                      FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr));
        const DWORD error = GetLastError();
        if (opened.ok()) {
            descriptor_ =
                _open_osfhandle(reinterpret_cast<intptr_t>(opened.release()), _O_WRONLY | _O_NOINHERIT);
            break;
        }
        if (error != ERROR_SHARING_VIOLATION && error != ERROR_ACCESS_DENIED) // that one: it is being removed
            break;
        if (std::chrono::steady_clock::now() >= end)
            return;
        std::this_thread::sleep_for(pause);
    }
    held_ = true;
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0)
        _close(descriptor_);
}

} // namespace tp
