// SPDX-License-Identifier: Apache-2.0
// touchphoto-force-guard: started by TouchPhoto beside a device that has no watchdog. Holds the device open
// too and listens to the program: 'p' is a sign of life of a program that pulls, 'z' of one that does not,
// 'q' takes leave. 50 ms after the last 'p' it takes the force away and says 's' there, or ends where the
// program cannot go on; when the other end is gone it takes the force away and ends.
//
//     touchphoto-force-guard board SET-UP
//     touchphoto-force-guard reports NO-FORCE… then AT-THE-END…
//     touchphoto-force-guard packet ENDPOINT NO-FORCE
//     touchphoto-force-guard --version
//
// Bytes are words of hexadecimal digits. The device is descriptor 3 and the program descriptor 4, as
// core/processes/child_process.hpp gives them.
#include "core/version/version.hpp"
#include "device/guard/process/ends.hpp"
#include "device/guard/process/force_taker.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string_view>
#include <utility>

using namespace tp::guard;

namespace {

constexpr int silence_ms = 50;

/// "0105ff…"; none where it is no bytes.
Bytes bytes_in(std::string_view word) {
    Bytes bytes;
    for (; !word.empty(); word.remove_prefix(2)) {
        std::uint8_t byte = 0;
        if (word.size() < 2 || std::from_chars(word.data(), word.data() + 2, byte, 16).ptr != word.data() + 2)
            return {};
        bytes.push_back(byte);
    }
    return bytes;
}

std::unique_ptr<ForceTaker> reports_of(std::span<const Bytes> words, std::size_t before) {
    return report_taker({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(before)},
                        {words.begin() + static_cast<std::ptrdiff_t>(before), words.end()});
}

/// Nothing where the words say nothing that it could do.
std::unique_ptr<ForceTaker> taker_of(std::string_view kind, std::span<char* const> words) {
    std::vector<Bytes> bytes;
    std::size_t before = words.size();
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (kind == "reports" && before == words.size() && std::string_view(words[i]) == "then") {
            before = i;
            continue;
        }
        bytes.push_back(bytes_in(words[i]));
        if (bytes.back().empty())
            return nullptr;
    }
    if (kind == "board" && bytes.size() == 1)
        return board_taker(bytes[0]);
    if (kind == "reports" && before > 0)
        return reports_of(bytes, before);
    if (kind == "packet" && bytes.size() == 2 && bytes[0].size() == 1)
        return packet_taker(bytes[0][0], bytes[1]);
    return nullptr;
}

bool say(char letter) {
    const std::array<std::uint8_t, 1> byte{static_cast<std::uint8_t>(letter)};
    return write_all(End::program, byte);
}

/// What was heard of the program.
struct Heard {
    bool may_pull = false; ///< its last word on that
    bool awaits = false;   ///< a sign of life must come in time
    bool took_leave = false;
    bool gone = false;

    /// False where nothing came in time.
    bool listen() {
        std::array<std::uint8_t, 256> bytes{};
        const int got = read_within(End::program, bytes, awaits ? silence_ms : -1);
        gone = got < 0;
        if (got <= 0)
            return gone;
        for (const std::uint8_t byte : std::span(bytes).first(static_cast<std::size_t>(got))) {
            took_leave = took_leave || byte == 'q';
            may_pull = awaits = byte == 'p';
        }
        return true;
    }
};

void watch(ForceTaker& taker) {
    for (Heard program;;) {
        if (!program.listen()) {
            if (!taker.let_go())
                return;
            program.awaits = false;
            say('s');
            continue;
        }
        if (program.took_leave)
            return;
        if (program.gone)
            return taker.leave(program.may_pull);
    }
}

} // namespace

int main(int count, char** words) {
    const std::span<char* const> told =
        std::span(words, static_cast<std::size_t>(count)).subspan(count > 0 ? 1 : 0);
    if (told.size() == 1 && std::string_view(told.front()) == "--version")
        return std::puts(tp::version_line("touchphoto-force-guard").c_str()) < 0;
    if (!take_ends())
        return 2;
    const auto taker = told.empty() ? nullptr : taker_of(told.front(), told.subspan(1));
    if (!taker)
        return 2;
    if (!say('r'))
        return 1;
    watch(*taker);
    return 0;
}
