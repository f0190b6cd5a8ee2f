// SPDX-License-Identifier: Apache-2.0
// A helper whose messages are orders: to misbehave, or to try what a confined process must not be able to do.
#include "core/processes/answering_linux.hpp"
#include "core/processes/shared_memory_linux.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <map>
#include <optional>
#include <string>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace tp;

namespace {

constexpr Limits limits{std::uint64_t{1} << 30, 32};
constexpr int seconds = 60;

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

std::optional<SharedMemory> shared;

int tried(const std::string& what) {
    const std::map<std::string, int (*)()> tries{
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
        {"look into another", [] { return problem_of(ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr)); }},
        {"map code", mapped_code},
        {"make data code", data_made_code},
        {"shrink what is shared", [] { return problem_of(ftruncate(shared->another().number(), 10)); }},
        {"start a thread", a_thread},
        {"take much memory", much_memory},
        {"take little memory", [] { return std::vector<char>(50'000'000, 1).back() - 1; }},
    };
    const auto found = tries.find(what);
    return found == tries.end() ? -1 : found->second();
}

Message shared_with_all(std::size_t bytes) {
    shared = SharedMemory::make(bytes);
    std::memset(shared->data(), 7, bytes);
    return MessageWriter().add(static_cast<std::int64_t>(bytes)).hand_over(shared->another()).take();
}

int open_descriptors() {
    int count = 0;
    for (int i = 0; i < 1000; ++i)
        count += fcntl(i, F_GETFD) >= 0 ? 1 : 0;
    return count;
}

std::optional<Message> answer(Message& question) {
    MessageReader order(question);
    const std::string word = order.text();
    const std::string object = order.text();
    if (word == "say")
        return MessageWriter().add(object).take();
    if (word == "tell a setting") {
        const char* const setting = std::getenv(object.c_str());
        return MessageWriter().add(setting == nullptr ? "none" : setting).take();
    }
    if (word == "try")
        return MessageWriter().add(std::int64_t{tried(object)}).take();
    if (word == "share")
        return shared_with_all(std::stoul(object));
    if (word == "compute for two seconds") {
        while (std::clock() < 2 * CLOCKS_PER_SEC) {
        }
        return MessageWriter().add(object).take();
    }
    if (word == "count descriptors")
        return MessageWriter().add(std::int64_t{open_descriptors()}).take();
    if (word == "crash")
        std::abort();
    if (word == "leave")
        _exit(0);
    for (std::atomic<int> turns = 0; word == "compute for ever"; ++turns) {
    }
    if (word == "do nothing")
        std::this_thread::sleep_for(std::chrono::hours(1));
    return std::nullopt;
}

} // namespace

int main() {
    answer_messages(limits, seconds, answer);
    _exit(0); // no leak is sought at its end, for which it may not look
}
