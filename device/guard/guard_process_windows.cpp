// SPDX-License-Identifier: Apache-2.0
#include "device/guard/guard_process.hpp"
#include "device/guard/no_guard.hpp"
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/wide_text.hpp"

#include <array>
#include <atomic>
#include <filesystem>
#include <optional>
#include <utility>

namespace tp {

namespace {

using windows::Handle;

constexpr DWORD start_patience_ms = 5000;

/// Both ends of a pipe that carries bytes both ways; the second one is inherited by a process that is given
/// it.
std::optional<std::pair<Handle, Handle>> pipe_to_guard() {
    constexpr DWORD buffer_bytes = 4096;
    static std::atomic<unsigned> count{0};
    const std::wstring name = L"\\\\.\\pipe\\touchphoto-force-guard-" +
                              std::to_wstring(GetCurrentProcessId()) + L"-" +
                              std::to_wstring(count.fetch_add(1));
    Handle ours(CreateNamedPipeW(
        name.c_str(), PIPE_ACCESS_DUPLEX | FILE_FLAG_OVERLAPPED | FILE_FLAG_FIRST_PIPE_INSTANCE,
        PIPE_TYPE_BYTE | PIPE_REJECT_REMOTE_CLIENTS, 1, buffer_bytes, buffer_bytes, 0, nullptr));
    SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
    Handle theirs(ours ? CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE, 0, &inherited, OPEN_EXISTING,
                                     FILE_FLAG_OVERLAPPED, nullptr)
                       : nullptr);
    if (!theirs)
        return std::nullopt;
    return std::pair(std::move(ours), std::move(theirs));
}

/// Another handle of the same device, which a process that is given it inherits.
Handle inherited(SystemHandle opened) {
    HANDLE made = nullptr;
    const HANDLE own = GetCurrentProcess();
    DuplicateHandle(own, reinterpret_cast<HANDLE>(opened), own, &made, 0, TRUE, DUPLICATE_SAME_ACCESS);
    return Handle(made);
}

class GuardProcess final : public ForceGuard {
public:
    GuardProcess(Handle beats, Handle process) : beats_(std::move(beats)), process_(std::move(process)) {}
    ~GuardProcess() override {
        beats_.reset(); // what it waits for
        WaitForSingleObject(process_.get(), INFINITE);
    }
    GuardProcess(const GuardProcess&) = delete;
    GuardProcess& operator=(const GuardProcess&) = delete;

    Word beat(bool pulls) noexcept override {
        const int sent = send(pulls ? 'p' : 'z');
        DWORD there = 0;
        if (sent < 0 || PeekNamedPipe(beats_.get(), nullptr, 0, nullptr, &there, nullptr) == 0)
            return Word::gone;
        const bool spoke = there > 0;
        if (spoke) {
            std::array<std::uint8_t, 64> words{};
            windows::read_some(beats_.get(), words, 0);
        }
        return spoke || sent == 0 ? Word::stepped_in : Word::here;
    }
    void dismiss() noexcept override { send('q'); }
    /// Whether it has said that it watches.
    bool watches() {
        std::array<std::uint8_t, 1> word{};
        return windows::read_some(beats_.get(), word, start_patience_ms) == 1 && word[0] == 'r';
    }

private:
    /// 1; 0 where it does not listen, −1 where nobody is there.
    int send(char letter) noexcept {
        const std::array<std::uint8_t, 1> byte{static_cast<std::uint8_t>(letter)};
        return windows::write_some(beats_.get(), byte, 0);
    }

    Handle beats_;
    Handle process_;
};

/// The process, which inherits these two handles and nothing else; none where there is no such program.
Handle spawn(const std::string& program, const std::vector<std::string>& words, HANDLE device, HANDLE beats) {
    std::string line = '"' + program + '"';
    for (const HANDLE handle : {device, beats})
        line += ' ' + std::to_string(reinterpret_cast<SystemHandle>(handle));
    for (const std::string& word : words)
        line += ' ' + word;
    std::wstring command = windows::wide(line);

    SIZE_T size = 0;
    InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    std::vector<std::uint8_t> room(size);
    STARTUPINFOEXW start{};
    start.StartupInfo.cb = sizeof start;
    start.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room.data());
    if (InitializeProcThreadAttributeList(start.lpAttributeList, 1, 0, &size) == 0)
        return {};
    HANDLE given[] = {device, beats};
    UpdateProcThreadAttribute(start.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, given,
                              sizeof given, nullptr, nullptr);
    PROCESS_INFORMATION made{};
    // A group of its own: a console's Ctrl-C is not for it.
    const BOOL started =
        CreateProcessW(windows::wide(program).c_str(), command.data(), nullptr, nullptr, TRUE,
                       EXTENDED_STARTUPINFO_PRESENT | CREATE_NEW_PROCESS_GROUP | CREATE_NO_WINDOW, nullptr,
                       nullptr, &start.StartupInfo, &made);
    DeleteProcThreadAttributeList(start.lpAttributeList);
    const Handle thread(made.hThread);
    return Handle(started != 0 ? made.hProcess : nullptr);
}

} // namespace

std::string force_guard_program() {
    std::wstring own(32768, L'\0'); // the longest path there is
    own.resize(GetModuleFileNameW(nullptr, own.data(), static_cast<DWORD>(own.size())));
    return windows::narrow(
        (std::filesystem::path(own).parent_path() / "touchphoto-force-guard.exe").wstring());
}

Result<std::unique_ptr<ForceGuard>> start_force_guard(const std::string& program, SystemHandle opened,
                                                      const std::vector<std::string>& words) {
    if (opened == no_handle)
        return nobody_to_watch();
    auto ends = pipe_to_guard();
    const Handle device = inherited(opened);
    if (!ends || !device)
        return no_room_for_guard();
    Handle process = spawn(program, words, device.get(), ends->second.get());
    ends->second.reset(); // the guard's alone: where it ends, this end hears of it
    if (!process)
        return guard_is_missing();
    auto guard = std::make_unique<GuardProcess>(std::move(ends->first), std::move(process));
    if (!guard->watches())
        return guard_does_not_start();
    return std::unique_ptr<ForceGuard>(std::move(guard));
}

} // namespace tp
