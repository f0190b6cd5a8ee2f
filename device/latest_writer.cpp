// SPDX-License-Identifier: Apache-2.0
#include "device/latest_writer.hpp"

#include <atomic>
#include <chrono>
#include <utility>

namespace tp {

struct LatestWriter::Mailbox {
    std::shared_ptr<Sink> sink;
    std::atomic<std::uint64_t> message{0};
    std::atomic<std::uint32_t> turn{0}; ///< counts what was put into the mailbox
    std::atomic<bool> quit{false};
    std::atomic<bool> ended{false};
    std::atomic<bool> lost{false};
    std::uint32_t sent = 0; ///< turn that was sent last; only the writer

    void send(std::uint32_t turn_now) noexcept {
        sent = turn_now;
        if (!sink->send(message.load(std::memory_order_acquire)))
            lost.store(true, std::memory_order_release);
    }
    void write_until_quit() noexcept {
        while (!lost.load(std::memory_order_acquire)) {
            turn.wait(sent, std::memory_order_acquire);
            send(turn.load(std::memory_order_acquire));
            if (quit.load(std::memory_order_acquire) && turn.load(std::memory_order_acquire) == sent)
                break;
        }
        ended.store(true, std::memory_order_release);
    }
};

LatestWriter::LatestWriter(std::shared_ptr<Sink> sink, Thread thread)
    : mailbox_(std::make_shared<Mailbox>()) {
    mailbox_->sink = std::move(sink);
    if (thread == Thread::own)
        thread_ = std::thread([mailbox = mailbox_] { mailbox->write_until_quit(); });
}

LatestWriter::~LatestWriter() { end(mailbox_->message.load(std::memory_order_acquire)); }

void LatestWriter::post(std::uint64_t message) noexcept {
    mailbox_->message.store(message, std::memory_order_release);
    mailbox_->turn.fetch_add(1, std::memory_order_release);
    mailbox_->turn.notify_one();
}

void LatestWriter::deliver() noexcept {
    if (ended_ || lost())
        return;
    const std::uint32_t turn = mailbox_->turn.load(std::memory_order_acquire);
    if (turn != mailbox_->sent)
        mailbox_->send(turn);
}

bool LatestWriter::end(std::uint64_t last) noexcept {
    if (ended_)
        return !hangs_;
    post(last); // before quit: a writer that sees quit has sent this, or still will
    mailbox_->quit.store(true, std::memory_order_release);
    post(last); // wakes a writer that has sent the first and not seen quit
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
