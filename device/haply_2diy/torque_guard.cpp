// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/torque_guard.hpp"

#if defined(__unix__) || defined(__APPLE__)
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <span>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>
#endif
#if defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

#if defined(__unix__) || defined(__APPLE__)
extern char** environ; // POSIX has it in no header
#endif

namespace tp {

#if defined(__unix__) || defined(__APPLE__)

namespace {

constexpr int guards_line = 3; ///< descriptors of the guard's process
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

class GuardProcess final : public MotorGuard {
public:
    GuardProcess(Descriptor beats, pid_t process) : beats_(std::move(beats)), process_(process) {}
    ~GuardProcess() override {
        beats_.reset(); // what it waits for
        wait();
    }
    bool beat(bool pulls) noexcept override { return send(pulls ? 'p' : 'z'); }
    void dismiss() noexcept override { send('q'); }

private:
    bool send(char byte) noexcept { return ::send(beats_.get(), &byte, 1, without_signal) == 1; }
    void wait() noexcept {
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    Descriptor beats_;
    pid_t process_;
};

std::string hex(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15u];
    }
    return text;
}

/// 0, or why it could not be started.
int spawn(const std::string& program, const std::string& set_up, int line, int beats, pid_t& process) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, line, guards_line);
    posix_spawn_file_actions_adddup2(&actions, beats, guards_beats);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP); // a terminal's Ctrl-C is not for it
    std::string name = program;
    std::string argument = set_up;
    std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
    const int problem =
        posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return problem;
}

/// The guard, once it has said that it watches.
Result<std::unique_ptr<MotorGuard>> watching(Descriptor beats, pid_t process) {
    const int listening = beats.get();
    std::unique_ptr<MotorGuard> guard = std::make_unique<GuardProcess>(std::move(beats), process);
    char said = 0;
    if (!within(listening, start_patience_ms, said) || said != 'r')
        return Error{"The device stays off, because the program that watches over its motors, "
                     "touchphoto-torque-guard, does "
                     "not start. Install TouchPhoto again."};
    return guard;
}

} // namespace

std::string torque_guard_program() {
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
    return (own.parent_path() / "touchphoto-torque-guard").string();
}

Result<std::unique_ptr<MotorGuard>> start_torque_guard(const std::string& program, int line_descriptor,
                                                       const haply::SetUp& set_up) {
    int pair[2] = {-1, -1};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0)
        return Error{"This computer has no room for the program that watches over the motors. Close other "
                     "programs and try "
                     "again."};
    const Descriptor low_ours(pair[0]);
    const Descriptor low_theirs(pair[1]);
    Descriptor ours(fcntl(pair[0], F_DUPFD_CLOEXEC, first_free));
    const Descriptor theirs(fcntl(pair[1], F_DUPFD_CLOEXEC, first_free));
    const Descriptor line(fcntl(line_descriptor, F_DUPFD_CLOEXEC, first_free));
    for (const int low : pair)
        fcntl(low, F_SETFD, FD_CLOEXEC);
    quiet(ours.get());
    pid_t process = 0;
    if (spawn(program, hex(encode(set_up).view()), line.get(), theirs.get(), process) != 0)
        return Error{"The device stays off, because the program that watches over its motors, "
                     "touchphoto-torque-guard, is "
                     "not beside this one. Install TouchPhoto again."};
    return watching(std::move(ours), process);
}

#else

std::string torque_guard_program() { return {}; }

Result<std::unique_ptr<MotorGuard>> start_torque_guard(const std::string&, int, const haply::SetUp&) {
    return Error{"The device stays off, because nothing would watch over its motors on this system."};
}

#endif

} // namespace tp
