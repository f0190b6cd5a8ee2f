// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <thread>

namespace tp {

/// Hands the latest message of a device's back end to its transport, whose writes can stall for milliseconds
/// to seconds: a mailbox that holds only the newest message, and a writer that sends it. The writer sends
/// once for each time something was posted at most, and never by itself, so that a servo that stands still
/// starves the device's watchdog too.
///
/// A message is a word of 64 bits that the back end packs and its sink unpacks.
class LatestWriter {
public:
    /// Where the messages go. Only the writer calls it; it outlives the back end where the writer hangs.
    class Sink {
    public:
        virtual ~Sink() = default;
        /// False where the device is gone. May block for as long as the system likes.
        virtual bool send(std::uint64_t message) noexcept = 0;
    };
    enum class Thread {
        own,
        caller, ///< deliver() is the writer's step; for simulated time
    };

    /// `no_force`: the message that takes every force away.
    LatestWriter(std::shared_ptr<Sink> sink, std::uint64_t no_force, Thread thread);
    /// As end(), if it has not ended yet.
    ~LatestWriter();
    LatestWriter(const LatestWriter&) = delete;
    LatestWriter& operator=(const LatestWriter&) = delete;

    /// Any thread, also from a signal handler: no lock, no allocation.
    void post(std::uint64_t message) noexcept;
    /// Posts no force. Where a signal is about to end the process (ExitGuard) it waits until that was sent,
    /// for 50 ms at most, and nothing else is sent from then on: a force that the writer was about to send
    /// while the process died would stay. Any thread, also from a signal handler.
    void halt() noexcept;
    /// Sends what the mailbox holds, if anything is new in it; for Thread::caller.
    void deliver() noexcept;
    /// Sends no force and ends the writer. Waits a second at most: false where the writer hangs in the
    /// system, where it is left to end by itself and still uses the sink. May be called twice.
    bool end() noexcept;

    /// A write has failed, or lose() was called: the writer ends. Any thread.
    bool lost() const noexcept;
    /// The back end has seen that the device is gone. Any thread.
    void lose() noexcept;

private:
    struct Mailbox;
    void wait_until_sent() const noexcept;
    std::shared_ptr<Mailbox> mailbox_;
    std::thread thread_;
    bool ended_ = false;
    bool hangs_ = false;
};

} // namespace tp
