// SPDX-License-Identifier: Apache-2.0
// A program of its own for the tests, for Windows too:
//     board_puller pull PORT GUARD    opens the 2diy there, pulls on it until its input ends, then stops as a
//                                     program should; prints what the device has to say
//     board_puller echo PORT          gives back 256 bytes that come there, then waits until the port is gone
//     board_puller boards             prints port and serial number of each Arduino board
// Ends in 0, or says what went wrong.
#include "device/guard/guard_process.hpp"
#include "device/haply_2diy/found_boards.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/serial_port.hpp"
#include "safe_force.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace tp;

namespace {

std::atomic<bool> input_ended{false};

/// Nothing waits for this thread: a program that ends ends it.
void listen_for_the_end() {
    std::thread([] {
        while (std::getchar() != EOF) {
        }
        input_ended.store(true);
    }).detach();
}

int complain(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::fflush(nullptr);
    return 2;
}

Result<Haply2diy::Board> opened(const std::string& path, const std::string& program) {
    auto port = open_serial_port(path, "Haply 2diy");
    if (!port)
        return Error{port.error()};
    const Pantograph arms(HaplyGeneration::third);
    auto guard = start_force_guard(program, (*port)->handle(),
                                   {"board", guard_word(encode(arms.set_up(arms.reference_deg())).view())});
    if (!guard)
        return Error{guard.error()};
    return Haply2diy::Board{std::move(*port), std::move(*guard), {}, "X"};
}

int pull(const std::string& path, const std::string& program) {
    Haply2diy device(HaplyGeneration::third, [&] { return opened(path, program); });
    const auto can = device.open();
    const auto homed = can ? device.home() : Result<bool>(Error{can.error()});
    if (!homed)
        return complain(homed.error());
    listen_for_the_end();
    std::string said;
    for (double now = 0.0; !input_ended.load(); now += 0.001) {
        device.read(now);
        if (!device.write(tp::testing::safe({0.5, 0.3})))
            return complain("The board is gone.");
        if (const std::string complaint = device.complaint(); complaint != said) {
            std::printf("%s\n", complaint.c_str());
            std::fflush(stdout);
            said = complaint;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    device.stop();
    return 0;
}

int echo(const std::string& path) {
    auto port = open_serial_port(path, "Haply 2diy");
    if (!port)
        return complain(port.error());
    std::printf("open\n");
    std::fflush(stdout);
    std::vector<std::uint8_t> heard;
    std::uint8_t some[64];
    while (heard.size() < 256) {
        const int got = (*port)->read(some, 1000);
        if (got < 0)
            return complain("The port is gone too early.");
        heard.insert(heard.end(), some, some + got);
    }
    if (!(*port)->write(heard))
        return complain("The port does not take what it gave.");
    if ((*port)->read(some, 0) > 0)
        return complain("More came than was sent.");
    while ((*port)->read(some, 1) == 0) {
    }
    return (*port)->write(heard) ? complain("A port that is gone takes bytes.") : 0;
}

int boards() {
    for (const FoundBoard& board : find_boards())
        std::printf("%s %s\n", board.path.c_str(), board.serial_number.c_str());
    return 0;
}

} // namespace

int main(int count, char** words) {
    const std::vector<std::string> told(words + 1, words + count);
    if (told.size() == 3 && told[0] == "pull")
        return pull(told[1], told[2]);
    if (told.size() == 2 && told[0] == "echo")
        return echo(told[1]);
    if (told.size() == 1 && told[0] == "boards")
        return boards();
    return complain("board_puller pull PORT GUARD | echo PORT | boards");
}
