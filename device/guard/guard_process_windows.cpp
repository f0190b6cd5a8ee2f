// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/pipe_pair.hpp"
#include "core/base/windows/wide_text.hpp"
#include "core/processes/child_process.hpp"
#include "core/processes/our_programs.hpp"
#include "device/guard/guard_process.hpp"
#include "device/guard/no_guard.hpp"

#include <array>
#include <utility>

namespace tp {

namespace {

using windows::Handle;

constexpr DWORD start_patience_ms = 5000;
constexpr DWORD waiting_bytes = 4096;

class GuardProcess final : public ForceGuard {
public:
    GuardProcess(Handle beats, ChildProcess process)
        : beats_(std::move(beats)), process_(std::move(process)) {}
    ~GuardProcess() override { beats_.reset(); } // what it waits for
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
    ChildProcess process_;
};

} // namespace

std::string force_guard_program() {
    const std::u8string program = helper_program("touchphoto-force-guard").u8string();
    return {program.begin(), program.end()};
}

Result<std::unique_ptr<ForceGuard>> start_force_guard(const std::string& program, SystemHandle opened,
                                                      const std::vector<std::string>& words) {
    if (opened == no_handle)
        return nobody_to_watch();
    auto ends = windows::pipe_pair(PIPE_TYPE_BYTE, waiting_bytes);
    if (!ends)
        return no_room_for_guard();
    const std::array given{
        opened, reinterpret_cast<SystemHandle>(ends->second.get())}; // as process/main.cpp has them
    auto process = ChildProcess::start(windows::wide(program), words, given, Streams::ours);
    ends->second.reset(); // the guard's alone: where it ends, this end hears of it
    if (!process)
        return guard_is_missing();
    auto guard = std::make_unique<GuardProcess>(std::move(ends->first), *std::move(process));
    if (!guard->watches())
        return guard_does_not_start();
    return std::unique_ptr<ForceGuard>(std::move(guard));
}

} // namespace tp
