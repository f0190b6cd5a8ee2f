// SPDX-License-Identifier: Apache-2.0
// touchphoto-torque-guard SET-UP: started by TouchPhoto beside a Haply board, whose firmware has no watchdog.
// Holds the serial line as descriptor 3 and listens at 4: 'p' is a sign of life of a program that pulls, 'z'
// of one that does not, 'q' takes leave. When the other end is gone, or 50 ms after the last 'p', it takes
// the torque away and ends.
#include "device/haply_2diy/protocol/board_frames.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <poll.h>
#include <string>
#include <unistd.h>
#include <vector>

using namespace tp::haply;

namespace {

constexpr int line = 3;
constexpr int beats = 4;
constexpr int silence_ms = 50;
constexpr int answer_ms = 30;
constexpr int patience_ms = 2000; ///< with a line that takes nothing
/// A command of no torque; more than can be answered without having been obeyed: what the program's last ones
/// may still be answered with, and one that the board makes of a half frame of the program and half of ours.
constexpr std::size_t times = 5;
constexpr unsigned rounds = 20;

int wait_for(int descriptor, short for_what, int wait_ms) {
    pollfd one{descriptor, for_what, 0};
    int ready = 0;
    while ((ready = poll(&one, 1, wait_ms)) < 0 && errno == EINTR) {
    }
    return ready;
}

bool write_all(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t gone = write(line, bytes.data(), bytes.size());
        if (gone > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(gone));
        else if (gone < 0 && errno == EAGAIN) {
            if (wait_for(line, POLLOUT, patience_ms) <= 0)
                return false;
        } else if (gone < 0 && errno != EINTR)
            return false;
    }
    return true;
}

/// Whether these are a board's answers to commands and nothing else.
bool are_replies(std::span<const std::uint8_t> bytes, std::uint8_t id) {
    for (; bytes.size() >= reply_size; bytes = bytes.subspan(reply_size))
        if (const auto reply = decode_reply(bytes.first<reply_size>()); !reply || reply->device_id != id)
            return false;
    return true;
}

/// Whether the last that a board answers are so many replies to commands.
bool answered(std::uint8_t id, std::size_t replies) {
    std::vector<std::uint8_t> heard;
    std::array<std::uint8_t, 256> some{};
    while (heard.size() < 4096 && wait_for(line, POLLIN, answer_ms) > 0) {
        const ssize_t got = read(line, some.data(), some.size());
        if (got <= 0)
            return false;
        heard.insert(heard.end(), some.begin(), some.begin() + got);
        if (heard.size() >= replies * reply_size && are_replies(std::span(heard).last(replies * reply_size), id))
            return true;
    }
    return false;
}

/// Whether the board is in step and has taken the torque away, as it was told.
bool obeys(std::uint8_t id) {
    for (std::size_t i = 0; i < times; ++i)
        if (!write_all(encode(Command{id, {}})))
            return false;
    return answered(id, times);
}

void drop_what_came() {
    std::array<std::uint8_t, 4096> some{};
    while (wait_for(line, POLLIN, 0) > 0 && read(line, some.data(), some.size()) > 0) {
    }
}

void take_torque_away(const SetUp& set_up) {
    drop_what_came();
    if (obeys(set_up.device_id))
        return;
    // The program died in the middle of a frame, or the board is out of step.
    for (unsigned round = 0; round < rounds; ++round) {
        if (!write_all(resynchronisation(set_up, round).view()))
            return;
        if (answered(set_up.device_id, 1) && obeys(set_up.device_id)) {
            write_all(
                encode_reset(set_up.device_id)); // its angles are not those it had: nobody shall believe them
            return;
        }
    }
}

/// "01052f…"; none where it is no set-up.
std::optional<SetUp> set_up_in(const char* text) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t at = 0; at + 1 < std::strlen(text); at += 2)
        bytes.push_back(
            static_cast<std::uint8_t>(std::strtoul(std::string(text + at, 2).c_str(), nullptr, 16)));
    return decode_set_up(bytes);
}

} // namespace

int main(int count, char** arguments) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTTOU, SIGTTIN})
        std::signal(signal, SIG_IGN);
    const auto set_up = count == 2 ? set_up_in(arguments[1]) : std::nullopt;
    if (!set_up)
        return 2;
    const char here = 'r';
    if (write(beats, &here, 1) != 1)
        return 1;
    bool pulls = false;
    for (;;) {
        if (wait_for(beats, POLLIN, pulls ? silence_ms : -1) == 0)
            break;
        std::array<char, 256> heard{};
        const ssize_t got = read(beats, heard.data(), heard.size());
        if (got <= 0)
            break;
        for (const char beat : std::span(heard).first(static_cast<std::size_t>(got))) {
            if (beat == 'q')
                return 0;
            pulls = beat == 'p';
        }
    }
    take_torque_away(*set_up);
    return 0;
}
