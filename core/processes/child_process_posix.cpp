// SPDX-License-Identifier: Apache-2.0
#include "core/processes/child_process.hpp"

#include <cerrno>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <utility>

extern char** environ; // POSIX has it in no header

namespace tp {
namespace {

constexpr int first_given = 3; ///< after the standard streams

/// What is to happen between the start of a process and that of its program.
class SpawnPlan {
public:
    SpawnPlan() {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    }
    ~SpawnPlan() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&actions_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    void without_streams() {
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDWR, 0);
    }
    void give(int descriptor, int as) { posix_spawn_file_actions_adddup2(&actions_, descriptor, as); }
    /// What others forgot to keep to themselves.
    void nothing_from(int descriptor) {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
        posix_spawn_file_actions_addclosefrom_np(&actions_, descriptor);
#else
        static_cast<void>(descriptor);
#endif
    }
    /// None where the system does not start it.
    std::optional<pid_t> start(std::vector<std::string> words, std::vector<std::string> settings) const {
        std::vector<char*> arguments = pointers_to(words), environment = pointers_to(settings);
        char** end = environ;
        while (*end != nullptr)
            ++end;
        environment.insert(environment.end(), environ, end);
        arguments.push_back(nullptr);
        environment.push_back(nullptr);
        pid_t process = 0;
        if (posix_spawn(&process, words.front().c_str(), &actions_, &attributes_, arguments.data(),
                        environment.data()) != 0)
            return std::nullopt;
        return process;
    }

private:
    static std::vector<char*> pointers_to(std::vector<std::string>& texts) {
        std::vector<char*> pointers;
        pointers.reserve(texts.size() + 1); // a null behind them
        for (std::string& text : texts)
            pointers.push_back(text.data());
        return pointers;
    }

    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

} // namespace

std::optional<ChildProcess> ChildProcess::start(const std::filesystem::path& program,
                                                const std::vector<std::string>& words,
                                                std::span<const DescriptorNumber> given, Streams streams,
                                                const std::vector<std::string>& settings) {
    const int after = first_given + static_cast<int>(given.size());
    SpawnPlan plan;
    if (streams == Streams::none)
        plan.without_streams();
    std::vector<Descriptor> above; // so that none overwrites another's source
    for (std::size_t i = 0; i < given.size(); ++i) {
        above.emplace_back(fcntl(given[i], F_DUPFD_CLOEXEC, after));
        if (!above.back().ok())
            return std::nullopt;
        plan.give(above.back().number(), first_given + static_cast<int>(i));
    }
    plan.nothing_from(after);
    std::vector<std::string> arguments{program.string()};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const std::optional<pid_t> process = plan.start(std::move(arguments), settings);
    return process ? std::optional(ChildProcess(*process)) : std::nullopt;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : process_(std::exchange(other.process_, 0)) {}

ChildProcess::~ChildProcess() {
    while (process_ > 0 && waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void ChildProcess::kill() noexcept {
    if (process_ > 0)
        ::kill(process_, SIGKILL);
}

std::optional<std::chrono::nanoseconds> ChildProcess::computed() const {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process_, &clock) != 0 || clock_gettime(clock, &time) != 0)
        return std::nullopt;
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

Descriptor given_descriptor(int number) { return Descriptor(number); }

} // namespace tp
