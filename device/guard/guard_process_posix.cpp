// SPDX-License-Identifier: Apache-2.0
#include "core/base/descriptor.hpp"
#include "core/processes/child_process.hpp"
#include "core/processes/our_programs.hpp"
#include "device/guard/guard_process.hpp"
#include "device/guard/no_guard.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

namespace tp {

namespace {

constexpr int start_patience_ms = 5000;

#if defined(SOCK_CLOEXEC)
constexpr int socket_kind = SOCK_STREAM | SOCK_CLOEXEC; // not for what another thread starts meanwhile
#else
constexpr int socket_kind = SOCK_STREAM;
#endif

/// Of bytes that nobody takes any more, an error and no signal.
void quiet(int socket) {
#if defined(SO_NOSIGPIPE)
    const int on = 1;
    setsockopt(socket, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
#else
    static_cast<void>(socket);
#endif
}
#if defined(MSG_NOSIGNAL)
constexpr int without_signal = MSG_NOSIGNAL | MSG_DONTWAIT;
#else
constexpr int without_signal = MSG_DONTWAIT;
#endif

bool within(int descriptor, int wait_ms, char& byte) {
    pollfd one{descriptor, POLLIN, 0};
    while (poll(&one, 1, wait_ms) < 0)
        if (errno != EINTR)
            return false;
    return ::recv(descriptor, &byte, 1, MSG_DONTWAIT) == 1;
}

class GuardProcess final : public ForceGuard {
public:
    GuardProcess(Descriptor beats, ChildProcess process)
        : beats_(std::move(beats)), process_(std::move(process)) {}
    ~GuardProcess() override { beats_.reset(); } // what it waits for
    Word beat(bool pulls) noexcept override {
        const Sent sent = send(pulls ? 'p' : 'z');
        if (sent == Sent::to_nobody)
            return Word::gone;
        char said = 0;
        const bool spoke = ::recv(beats_.number(), &said, 1, MSG_DONTWAIT) == 1;
        return spoke || sent == Sent::not_yet ? Word::stepped_in : Word::here;
    }
    void dismiss() noexcept override { send('q'); }

private:
    enum class Sent : std::uint8_t { yes, not_yet, to_nobody };
    Sent send(char byte) noexcept {
        if (::send(beats_.number(), &byte, 1, without_signal) == 1)
            return Sent::yes;
        return errno == EAGAIN || errno == EWOULDBLOCK ? Sent::not_yet : Sent::to_nobody;
    }

    Descriptor beats_;
    ChildProcess process_;
};

/// The guard, once it has said that it watches.
Result<std::unique_ptr<ForceGuard>> watching(Descriptor beats, ChildProcess process) {
    const int listening = beats.number();
    std::unique_ptr<ForceGuard> guard = std::make_unique<GuardProcess>(std::move(beats), std::move(process));
    char said = 0;
    if (!within(listening, start_patience_ms, said) || said != 'r')
        return guard_does_not_start();
    return guard;
}

} // namespace

std::string force_guard_program() { return helper_program("touchphoto-force-guard").string(); }

Result<std::unique_ptr<ForceGuard>> start_force_guard(const std::string& program, SystemHandle opened,
                                                      const std::vector<std::string>& words) {
    if (opened == no_handle)
        return nobody_to_watch();
    std::array<int, 2> pair{-1, -1};
    if (socketpair(AF_UNIX, socket_kind, 0, pair.data()) != 0)
        return no_room_for_guard();
    Descriptor ours(pair[0]);
    Descriptor theirs(pair[1]);
    for (const int end : pair)
        fcntl(end, F_SETFD, FD_CLOEXEC);
    quiet(ours.number());
    const std::array given{static_cast<int>(opened),
                           theirs.number()}; // as device/guard/process/main.cpp has them
    std::optional<ChildProcess> process = ChildProcess::start(program, words, given, Streams::ours);
    theirs.reset(); // the guard's alone: where it ends, this end hears of it
    return process ? watching(std::move(ours), *std::move(process)) : guard_is_missing();
}

} // namespace tp
