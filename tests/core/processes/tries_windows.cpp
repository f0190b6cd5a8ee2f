// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/processes/child_process.hpp"
#include "core/processes/message.hpp"
#include "tries.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <thread>
#include <tlhelp32.h>
#include <vector>

namespace {

/// 0 where it could be done, else the system's error.
int problem_of(bool done) { return done ? 0 : static_cast<int>(GetLastError()); }

int file_written() {
    return problem_of(CreateFileW(L"C:\\touchphoto helper was here", GENERIC_WRITE, 0, nullptr, CREATE_ALWAYS,
                                  FILE_FLAG_DELETE_ON_CLOSE, nullptr) != INVALID_HANDLE_VALUE);
}

int program_started() {
    wchar_t line[] = L"cmd.exe /c exit";
    STARTUPINFOW start{};
    start.cb = sizeof start;
    PROCESS_INFORMATION made{};
    return problem_of(
        CreateProcessW(nullptr, line, nullptr, nullptr, FALSE, 0, nullptr, nullptr, &start, &made) != 0);
}

DWORD parent() {
    const HANDLE all = CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS, 0);
    PROCESSENTRY32W entry{};
    entry.dwSize = sizeof entry;
    for (BOOL more = Process32FirstW(all, &entry); more != 0; more = Process32NextW(all, &entry))
        if (entry.th32ProcessID == GetCurrentProcessId())
            return entry.th32ParentProcessID;
    return 0;
}

int parent_opened(DWORD access) { return problem_of(OpenProcess(access, FALSE, parent()) != nullptr); }

int mapped_code() {
    return problem_of(VirtualAlloc(nullptr, 4096, MEM_RESERVE | MEM_COMMIT, PAGE_EXECUTE_READWRITE) !=
                      nullptr);
}

int data_made_code() {
    void* const data = VirtualAlloc(nullptr, 4096, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
    DWORD before = 0;
    return problem_of(VirtualProtect(data, 4096, PAGE_EXECUTE_READ, &before) != 0);
}

int a_thread() {
    std::atomic<int> ran = 0;
    std::thread([&] { ran = 1; }).join();
    return ran == 1 ? 0 : 1;
}

int memory(std::size_t bytes) {
    return problem_of(VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE) != nullptr);
}

bool has_a_privilege() {
    HANDLE token = nullptr;
    TOKEN_PRIVILEGES first{};
    DWORD size = 0;
    OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY, &token);
    const BOOL all = GetTokenInformation(token, TokenPrivileges, &first, sizeof first, &size);
    return all == 0 || first.PrivilegeCount > 0;
}

/// The number of what it answers on.
std::int64_t channel() { return tp::given_descriptor(3).release(); }

/// Says that on its channel, as no message of ours is made. The answer to what was asked follows it.
int said(const std::vector<unsigned char>& bytes) {
    OVERLAPPED request{};
    request.hEvent = CreateEventW(nullptr, TRUE, FALSE, nullptr);
    const auto pipe = reinterpret_cast<HANDLE>(channel());
    WriteFile(pipe, bytes.data(), static_cast<DWORD>(bytes.size()), nullptr, &request);
    DWORD count = 0;
    return problem_of(GetOverlappedResult(pipe, &request, &count, TRUE) != 0);
}

int handed_over(std::int64_t number) {
    std::vector<unsigned char> bytes(sizeof number);
    std::memcpy(bytes.data(), &number, sizeof number);
    return said(bytes);
}

} // namespace

int tried(const std::string& what, const tp::SharedMemory*) {
    const std::map<std::string, std::function<int()>> tries{
        {"write a file", file_written},
        {"start a program", program_started},
        {"end another", [] { return parent_opened(PROCESS_TERMINATE); }},
        {"look into another", [] { return parent_opened(PROCESS_VM_READ); }},
        {"map code", mapped_code},
        {"make data code", data_made_code},
        {"have a privilege", [] { return has_a_privilege() ? 0 : ERROR_PRIVILEGE_NOT_HELD; }},
        {"start a thread", a_thread},
        {"take much memory", [] { return memory(std::size_t{2} << 30); }},
        {"take little memory", [] { return memory(50'000'000); }},
        {"hand over this process itself", [] { return handed_over(-1); }},
        {"hand over what it has not", [] { return handed_over(0x7FFFFFF0); }},
        {"hand over more than a number", [] { return handed_over((std::int64_t{1} << 40) + channel()); }},
        {"say half a number",
         [] {
             return said({1, 2, 3});
         }},
        {"say too much", [] { return said(std::vector<unsigned char>(tp::longest_message + 9)); }},
    };
    const auto found = tries.find(what);
    return found == tries.end() ? -1 : found->second();
}
