// SPDX-License-Identifier: Apache-2.0
#include "tries.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <functional>
#include <map>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

/// 0 where it could be done, else errno.
int problem_of(long result) { return result < 0 ? errno : 0; }

int mapped_code() {
    void* const code =
        mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return code == MAP_FAILED ? errno : 0;
}

int data_made_code() {
    void* const data = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return problem_of(mprotect(data, 4096, PROT_READ | PROT_EXEC));
}

int a_thread() {
    std::atomic<int> ran = 0;
    std::thread([&] { ran = 1; }).join();
    return ran == 1 ? 0 : EAGAIN;
}

int much_memory() {
    void* const data = mmap(nullptr, std::size_t{2} << 30, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return data == MAP_FAILED ? errno : 0;
}

/// Whom the kernel tells of the descriptor, by SIGIO where no other signal is chosen.
int a_signal_by_descriptor() {
    f_owner_ex owner{F_OWNER_PID, getppid()};
    return fcntl(3, F_SETOWN, getppid()) == 0 || fcntl(3, F_SETOWN_EX, &owner) == 0 ? 0 : errno;
}

int open_descriptors() {
    int count = 0;
    for (int i = 0; i < 1000; ++i)
        count += fcntl(i, F_GETFD) >= 0 ? 1 : 0;
    return count;
}

} // namespace

int tried(const std::string& what, const tp::SharedMemory* shared) {
    const std::map<std::string, std::function<int()>> tries{
        {"read a file", [] { return problem_of(open("/etc/passwd", O_RDONLY)); }},
        {"write a file",
         [] { return problem_of(open("/tmp/touchphoto helper was here", O_WRONLY | O_CREAT, 0600)); }},
        {"make a folder", [] { return problem_of(mkdir("/tmp/touchphoto helper's folder", 0700)); }},
        {"remove a file", [] { return problem_of(unlink("/tmp/touchphoto helper was here")); }},
        {"reach the network", [] { return problem_of(socket(AF_INET, SOCK_STREAM, 0)); }},
        {"reach a program", [] { return problem_of(socket(AF_UNIX, SOCK_STREAM, 0)); }},
        {"start a program", [] { return problem_of(execl("/bin/true", "true", nullptr)); }},
        {"start a process", [] { return problem_of(fork()); }},
        {"signal another", [] { return problem_of(kill(getppid(), SIGTERM)); }},
        {"signal another by its descriptor", a_signal_by_descriptor},
        {"signal another with a signal of its choice",
         [] { return problem_of(fcntl(3, F_SETSIG, SIGKILL)); }},
        {"hear of its descriptor by signals", [] { return problem_of(fcntl(3, F_SETFL, O_ASYNC)); }},
        {"look into another", [] { return problem_of(ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr)); }},
        {"map code", mapped_code},
        {"make data code", data_made_code},
        {"shrink what is shared", [&] { return problem_of(ftruncate(shared->another().number(), 10)); }},
        {"start a thread", a_thread},
        {"take much memory", much_memory},
        {"count what is open", open_descriptors},
        {"take little memory", [] { return std::vector<char>(50'000'000, 1).back() - 1; }},
    };
    const auto found = tries.find(what);
    return found == tries.end() ? -1 : found->second();
}
