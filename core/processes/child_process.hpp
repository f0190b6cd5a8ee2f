// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tp {

/// What a started program's standard streams are.
enum class Streams { ours, none };

/// A process that this one started. It belongs to a process group of its own: a terminal's Ctrl-C is not for
/// it.
class ChildProcess {
public:
    /// Starts `program` with these words, in UTF-8. Its descriptors are the standard streams and then, from 3 on,
    /// those of `given` in their order; no other one of this process reaches it. On Windows, where what is open
    /// has no such numbers, its environment says which handles they are: TOUCHPHOTO_GIVEN=76 80. Its environment
    /// is this one's, and before it `settings`, each as NAME=value. None where the system does not start it.
    static std::optional<ChildProcess> start(const std::filesystem::path& program,
                                             const std::vector<std::string>& words,
                                             std::span<const DescriptorNumber> given, Streams streams,
                                             const std::vector<std::string>& settings = {});
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    /// Waits until it has ended: who wants that soon tells it so, or kills it, before.
    ~ChildProcess();

    /// Ends it at once, whatever it does.
    void kill() noexcept;
    /// How long all its threads have computed; none where it has ended.
    std::optional<std::chrono::nanoseconds> computed() const;
    /// What the system calls it by: a process id, on Windows a handle.
    DescriptorNumber number() const { return process_; }

private:
    explicit ChildProcess(DescriptorNumber process) : process_(process) {}

    DescriptorNumber process_; ///< 0: none
};

/// In a process that was started so: what it was given as that number, from 3 on.
Descriptor given_descriptor(int number);

} // namespace tp
