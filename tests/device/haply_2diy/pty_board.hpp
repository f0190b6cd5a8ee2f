// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/haply_2diy/model_board.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <mutex>
#include <poll.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace tp::testing {

/// A board at the other end of a pseudo-terminal, on a thread of its own.
class PtyBoard {
public:
    PtyBoard() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
        grantpt(master_);
        unlockpt(master_);
        path_ = ptsname(master_);
        thread_ = std::thread([this] { serve(); });
    }
    ~PtyBoard() {
        quit_.store(true);
        thread_.join();
        ::close(master_);
    }
    PtyBoard(const PtyBoard&) = delete;
    PtyBoard& operator=(const PtyBoard&) = delete;

    std::string path() const { return path_; }
    bool pulls() {
        const std::scoped_lock lock(mutex_);
        return board_.torques() != std::array<double, 2>{};
    }
    bool is_set_up() {
        const std::scoped_lock lock(mutex_);
        return board_.set_up();
    }
    /// Nobody has the line open.
    bool hung_up() const { return hung_up_.load(); }
    std::uint64_t heard() const { return heard_.load(); }
    /// The board gets these before what comes next, as the beginning of a frame that was never ended: a
    /// command with the torque of the first motor, 0.1 N·m, which the next bytes of whatever kind complete.
    void begin_a_frame() {
        const std::scoped_lock lock(mutex_);
        for (const std::uint8_t byte : std::array<std::uint8_t, 6>{2, 5, 0xcd, 0xcc, 0xcc, 0x3d})
            board_.receive(byte);
    }

private:
    void serve() {
        while (!quit_.load()) {
            pollfd one{master_, POLLIN, 0};
            poll(&one, 1, 1);
            std::uint8_t bytes[256];
            const ssize_t got = ::read(master_, bytes, sizeof bytes);
            hung_up_.store(got < 0 && errno == EIO);
            if (got <= 0) {
                std::this_thread::sleep_for(std::chrono::microseconds(100));
                continue;
            }
            const std::scoped_lock lock(mutex_);
            heard_.fetch_add(static_cast<std::uint64_t>(got));
            for (ssize_t i = 0; i < got; ++i) {
                board_.receive(bytes[i]);
                send_the_answer();
            }
        }
    }
    void send_the_answer() {
        const std::vector<std::uint8_t> answer(board_.sent().begin(), board_.sent().end());
        board_.sent().clear();
        if (answer.empty())
            return;
        if (::write(master_, answer.data(), answer.size()) < 0)
            hung_up_.store(true);
        std::this_thread::sleep_for(
            std::chrono::microseconds(300)); // a board is no faster: it is read before the next
    }

    int master_;
    std::string path_;
    std::mutex mutex_;
    ModelBoard board_{HaplyGeneration::third};
    std::atomic<bool> quit_{false};
    std::atomic<bool> hung_up_{false};
    std::atomic<std::uint64_t> heard_{0};
    std::thread thread_;
};

} // namespace tp::testing
