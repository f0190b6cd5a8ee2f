// SPDX-License-Identifier: Apache-2.0
// A helper whose messages are orders: to misbehave, or to try what a confined process must not be able to do.
#include "core/files/open_file.hpp"
#include "core/processes/answering.hpp"
#include "core/processes/shared_memory.hpp"
#include "tries.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

using namespace tp;

namespace {

constexpr Limits limits{std::uint64_t{1} << 30, 32};
constexpr int seconds = 60;

std::optional<SharedMemory> shared;
std::string own_word; ///< that it was started with

Message shared_with_all(std::size_t bytes) {
    shared = SharedMemory::make(bytes);
    std::memset(shared->data(), 7, bytes);
    return MessageWriter().add(static_cast<std::int64_t>(bytes)).hand_over(shared->another()).take();
}

std::optional<Message> answer(Message& question) {
    MessageReader order(question);
    const std::string word = order.text();
    const std::string object = order.text();
    if (word == "say your word")
        return MessageWriter().add(own_word).take();
    if (word == "say")
        return MessageWriter().add(object).take();
    if (word == "tell a setting") {
        const char* const setting = std::getenv(object.c_str());
        return MessageWriter().add(setting == nullptr ? "none" : setting).take();
    }
    if (word == "read") {
        const Descriptor file = order.descriptor();
        std::array<char, 100> bytes{};
        return MessageWriter().add(std::string_view(bytes.data(), read_at(file.number(), 0, bytes))).take();
    }
    if (word == "try")
        return MessageWriter().add(std::int64_t{tried(object, shared ? &*shared : nullptr)}).take();
    if (word == "share")
        return shared_with_all(std::stoul(object));
    if (word == "compute for two seconds") {
        while (std::clock() < 2 * CLOCKS_PER_SEC) {
        }
        return MessageWriter().add(object).take();
    }
    if (word == "crash")
        std::abort();
    if (word == "leave")
        std::_Exit(0);
    for (std::atomic<int> turns = 0; word == "compute for ever"; ++turns) {
    }
    if (word == "do nothing")
        std::this_thread::sleep_for(std::chrono::hours(1));
    return std::nullopt;
}

} // namespace

int main(int count, char** words) {
    own_word = count == 2 ? words[1] : "none";
    answer_messages(limits, seconds, answer);
    std::_Exit(0); // no leak is sought at its end, for which it may not look
}
