// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace tp {

/// Where a program lies that lies beside the one that runs.
std::filesystem::path beside_this_program(const std::string& name);

/// Where one of our programs lies that is not for people: beside the one that runs, as they are built; where it
/// is not there, in ../libexec/PROGRAM from it, as it is installed (cmake/Install.cmake), PROGRAM being the file
/// name of the one that runs.
std::filesystem::path helper_program(const std::string& name);

/// What a started program's standard streams are.
enum class Streams { ours, none };

/// A process that this one started. It belongs to a process group of its own: a terminal's Ctrl-C is not for
/// it.
class ChildProcess {
public:
    /// Starts `program` with these words. Its descriptors are the standard streams and then, from 3 on,
    /// those of `given` in their order; no other one of this process reaches it. Its environment is this
    /// one's, and before it `settings`, each as NAME=value. None where the system does not start it.
    static std::optional<ChildProcess> start(const std::filesystem::path& program,
                                             const std::vector<std::string>& words,
                                             std::span<const int> given, Streams streams,
                                             const std::vector<std::string>& settings = {});
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    /// Waits until it has ended: who wants that soon tells it so, or kills it, before.
    ~ChildProcess();

    /// Ends it at once, whatever it does.
    void kill() noexcept;
    /// How long all its threads have computed; none where it has ended.
    std::optional<std::chrono::nanoseconds> computed() const;
    pid_t number() const { return process_; }

private:
    explicit ChildProcess(pid_t process) : process_(process) {}

    pid_t process_;
};

} // namespace tp
