// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/pipe_pair.hpp"

#include <atomic>
#include <string>

namespace tp::windows {

std::optional<std::pair<Handle, Handle>> pipe_pair(DWORD kind, DWORD bytes) {
    static std::atomic<unsigned> count{0};
    const std::wstring name = L"\\\\.\\pipe\\touchphoto-" + std::to_wstring(GetCurrentProcessId()) + L"-" +
                              std::to_wstring(count.fetch_add(1));
    Handle one(CreateNamedPipeW(name.c_str(),
                                PIPE_ACCESS_DUPLEX | FILE_FLAG_OVERLAPPED | FILE_FLAG_FIRST_PIPE_INSTANCE,
                                kind | PIPE_REJECT_REMOTE_CLIENTS, 1, bytes, bytes, 0, nullptr));
    Handle other(one ? CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING,
                                   FILE_FLAG_OVERLAPPED, nullptr)
                     : nullptr);
    DWORD how_read = kind & PIPE_READMODE_MESSAGE;
    if (!other || SetNamedPipeHandleState(other.get(), &how_read, nullptr, nullptr) == 0)
        return std::nullopt;
    return std::pair(std::move(one), std::move(other));
}

} // namespace tp::windows
