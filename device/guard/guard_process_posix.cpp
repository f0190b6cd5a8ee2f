// SPDX-License-Identifier: Apache-2.0
#include "device/guard/guard_process.hpp"
#include "device/guard/no_guard.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#if defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

extern char** environ; // POSIX has it in no header

namespace tp {

namespace {

constexpr int guards_device = 3; ///< descriptors of the guard's process
constexpr int guards_beats = 4;
constexpr int first_free = 10; ///< above those, so that neither overwrites the other's source
constexpr int start_patience_ms = 5000;

/// A descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { reset(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    int get() const { return number_; }
    void reset() {
        if (number_ >= 0)
            ::close(std::exchange(number_, -1));
    }

private:
    int number_;
};

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
    GuardProcess(Descriptor beats, pid_t process) : beats_(std::move(beats)), process_(process) {}
    ~GuardProcess() override {
        beats_.reset(); // what it waits for
        wait();
    }
    Word beat(bool pulls) noexcept override {
        const Sent sent = send(pulls ? 'p' : 'z');
        if (sent == Sent::to_nobody)
            return Word::gone;
        char said = 0;
        const bool spoke = ::recv(beats_.get(), &said, 1, MSG_DONTWAIT) == 1;
        return spoke || sent == Sent::not_yet ? Word::stepped_in : Word::here;
    }
    void dismiss() noexcept override { send('q'); }

private:
    enum class Sent : std::uint8_t { yes, not_yet, to_nobody };
    Sent send(char byte) noexcept {
        if (::send(beats_.get(), &byte, 1, without_signal) == 1)
            return Sent::yes;
        return errno == EAGAIN || errno == EWOULDBLOCK ? Sent::not_yet : Sent::to_nobody;
    }
    void wait() noexcept {
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    Descriptor beats_;
    pid_t process_;
};

/// 0, or why it could not be started.
int spawn(const std::string& program, std::vector<std::string> words, int device, int beats, pid_t& process) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, device, guards_device);
    posix_spawn_file_actions_adddup2(&actions, beats, guards_beats);
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
    posix_spawn_file_actions_addclosefrom_np(&actions,
                                             guards_beats + 1); // what others forgot to keep to themselves
#endif
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP); // a terminal's Ctrl-C is not for it
    words.insert(words.begin(), program);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int problem =
        posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return problem;
}

/// The guard, once it has said that it watches.
Result<std::unique_ptr<ForceGuard>> watching(Descriptor beats, pid_t process) {
    const int listening = beats.get();
    std::unique_ptr<ForceGuard> guard = std::make_unique<GuardProcess>(std::move(beats), process);
    char said = 0;
    if (!within(listening, start_patience_ms, said) || said != 'r')
        return guard_does_not_start();
    return guard;
}

} // namespace

std::string force_guard_program() {
    std::error_code problem;
#if defined(__APPLE__)
    std::uint32_t size = 0;
    _NSGetExecutablePath(nullptr, &size);
    std::vector<char> name(size + 1, '\0');
    _NSGetExecutablePath(name.data(), &size);
    const std::filesystem::path own = std::filesystem::canonical(name.data(), problem);
#else
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", problem);
#endif
    return (own.parent_path() / "touchphoto-force-guard").string();
}

Result<std::unique_ptr<ForceGuard>> start_force_guard(const std::string& program, SystemHandle opened,
                                                      const std::vector<std::string>& words) {
    if (opened == no_handle)
        return nobody_to_watch();
    int pair[2] = {-1, -1};
    if (socketpair(AF_UNIX, socket_kind, 0, pair) != 0)
        return no_room_for_guard();
    Descriptor low_ours(pair[0]);
    Descriptor low_theirs(pair[1]);
    for (const int low : pair)
        fcntl(low, F_SETFD, FD_CLOEXEC);
    Descriptor ours(fcntl(pair[0], F_DUPFD_CLOEXEC, first_free));
    Descriptor theirs(fcntl(pair[1], F_DUPFD_CLOEXEC, first_free));
    const Descriptor device(fcntl(static_cast<int>(opened), F_DUPFD_CLOEXEC, first_free));
    low_ours.reset();
    low_theirs.reset();
    quiet(ours.get());
    pid_t process = 0;
    const int problem = spawn(program, words, device.get(), theirs.get(), process);
    theirs.reset(); // the guard's alone: where it ends, this end hears of it
    if (problem != 0)
        return guard_is_missing();
    return watching(std::move(ours), process);
}

} // namespace tp
