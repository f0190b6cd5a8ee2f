// SPDX-License-Identifier: Apache-2.0
#include "device/latest_writer.hpp"

#include "core/servo/exit_guard.hpp"
#include "device/awaited_word.hpp"

#include <atomic>
#include <chrono>
#include <utility>

namespace tp {

struct LatestWriter::Mailbox {
    std::shared_ptr<Sink> sink;
    std::uint64_t no_force = 0;
    std::atomic<std::uint64_t> message{0};
    std::atomic<std::uint32_t> turn{0}; ///< counts what was put into the mailbox
    std::atomic<bool> quit{false};
    std::atomic<bool> ended{false};
    std::atomic<bool> lost{false};
    std::atomic<std::uint32_t> sent{0}; ///< turn that was sent last; only the writer changes it

    void send(std::uint32_t turn_now) noexcept {
        const std::uint64_t newest = message.load(std::memory_order_acquire);
        if (!sink->send(ExitGuard::leaving() ? no_force : newest))
            lost.store(true, std::memory_order_release);
        sent.store(turn_now, std::memory_order_release);
    }
    void write_until_quit() noexcept {
        while (!lost.load(std::memory_order_acquire)) {
            await_change(turn, sent.load(std::memory_order_relaxed));
            const bool last = quit.load(std::memory_order_acquire);
            send(turn.load(std::memory_order_acquire));
            if (last)
                break;
        }
        ended.store(true, std::memory_order_release);
    }
    void wake() noexcept {
        turn.fetch_add(1, std::memory_order_release);
        wake_one(turn);
    }
};

LatestWriter::LatestWriter(std::shared_ptr<Sink> sink, std::uint64_t no_force, Thread thread)
    : mailbox_(std::make_shared<Mailbox>()) {
    mailbox_->sink = std::move(sink);
    mailbox_->no_force = no_force;
    if (thread == Thread::own)
        thread_ = std::thread([mailbox = mailbox_] { mailbox->write_until_quit(); });
}

LatestWriter::~LatestWriter() { end(); }

void LatestWriter::post(std::uint64_t message) noexcept {
    mailbox_->message.store(message, std::memory_order_release);
    mailbox_->wake();
}

void LatestWriter::halt() noexcept {
    post(mailbox_->no_force);
    if (ExitGuard::leaving() && thread_.joinable())
        wait_until_sent();
}

void LatestWriter::wait_until_sent() const noexcept {
    const std::uint32_t turn = mailbox_->turn.load(std::memory_order_acquire);
    const auto sent = [&] { // also where something newer was; turns wrap round
        const std::uint32_t ahead = mailbox_->sent.load(std::memory_order_acquire) - turn;
        return ahead < 1u << 31;
    };
    for (int i = 0; i < 500 && !sent() && !lost(); ++i)
        std::this_thread::sleep_for(std::chrono::microseconds(100));
}

void LatestWriter::deliver() noexcept {
    if (ended_ || lost())
        return;
    const std::uint32_t turn = mailbox_->turn.load(std::memory_order_acquire);
    if (turn != mailbox_->sent.load(std::memory_order_relaxed))
        mailbox_->send(turn);
}

bool LatestWriter::end() noexcept {
    if (ended_)
        return !hangs_;
    // Before quit: what a writer sends that has seen quit is this.
    mailbox_->message.store(mailbox_->no_force, std::memory_order_release);
    mailbox_->quit.store(true, std::memory_order_release);
    mailbox_->wake();
    if (!thread_.joinable())
        deliver();
    ended_ = true;
    if (!thread_.joinable())
        return true;
    const auto ended = [this] { return mailbox_->ended.load(std::memory_order_acquire); };
    for (int i = 0; i < 1000 && !ended(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    hangs_ = !ended();
    if (hangs_)
        thread_.detach(); // it holds the mailbox and the sink itself
    else
        thread_.join();
    return !hangs_;
}

bool LatestWriter::lost() const noexcept { return mailbox_->lost.load(std::memory_order_acquire); }

void LatestWriter::lose() noexcept { mailbox_->lost.store(true, std::memory_order_release); }

} // namespace tp
