// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "own_processes.hpp"

#include <tlhelp32.h>
#include <utility>
#include <vector>

namespace tp::test {
namespace {

using windows::Handle;

/// Those that have not ended, which are all that nobody waits for any more: Windows lists no others.
std::vector<Handle> open_processes() {
    std::vector<Handle> processes;
    const Handle all(CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS, 0));
    PROCESSENTRY32W entry{};
    entry.dwSize = sizeof entry;
    for (BOOL more = Process32FirstW(all.get(), &entry); more != 0;
         more = Process32NextW(all.get(), &entry)) {
        if (entry.th32ParentProcessID != GetCurrentProcessId())
            continue;
        Handle process(OpenProcess(PROCESS_TERMINATE | SYNCHRONIZE, FALSE, entry.th32ProcessID));
        if (process && WaitForSingleObject(process.get(), 0) == WAIT_TIMEOUT)
            processes.push_back(std::move(process));
    }
    return processes;
}

} // namespace

const bool in_wine = GetProcAddress(GetModuleHandleW(L"ntdll.dll"), "wine_get_version") != nullptr;

int own_processes() { return static_cast<int>(open_processes().size()); }

int kill_own_processes() {
    const std::vector<Handle> processes = open_processes();
    for (const Handle& process : processes) {
        TerminateProcess(process.get(), 1);
        WaitForSingleObject(process.get(), INFINITE);
    }
    return static_cast<int>(processes.size());
}

} // namespace tp::test
