// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/feedback_output.hpp"

#include "device/open_problem.hpp"

#include <cerrno>
#include <chrono>
#include <utility>

namespace tp {

namespace {

constexpr std::uint64_t no_effect = 0;
constexpr FeedbackEffect unplayed{0, 0, 8, 1}; ///< takes a place in the device

bool means_gone(int error) { return error == ENODEV || error == ENXIO || error == EBADF; }

} // namespace

void FeedbackOutput::Wire::is_in(Trouble what) noexcept {
    Trouble before = trouble->load(std::memory_order_acquire);
    while (before != Trouble::gone &&
           !trouble->compare_exchange_weak(before, what, std::memory_order_acq_rel)) {
    }
}

bool FeedbackOutput::Wire::answered(int error) noexcept {
    if (error != 0)
        is_in(means_gone(error) ? Trouble::gone : Trouble::refused);
    return !means_gone(error);
}

bool FeedbackOutput::Wire::send(std::uint64_t message) noexcept {
    if (message == no_effect)
        return answered(node->play(false));
    const double asked = asked_at.load(std::memory_order_acquire);
    const FeedbackEffect effect = unpacked_feedback(message);
    if (stored != effect) {
        stored.reset();
        if (const int error = node->upload(effect); error != 0)
            return answered(error);
        stored = effect;
    }
    if (newest.load(std::memory_order_acquire) != message)
        return true; // stopped, or told something else, while the driver took its time
    if (clock() - asked > late_after_s) {
        is_in(Trouble::late);
        return true;
    }
    const int error = node->play(true);
    if (error == 0)
        is_in(Trouble::none);
    return answered(error);
}

FeedbackOutput::FeedbackOutput(Identity identity, Opener opener, LatestWriter::Thread thread, Clock clock)
    : identity_(std::move(identity)), opener_(std::move(opener)), thread_(thread), clock_(std::move(clock)) {}

FeedbackOutput::~FeedbackOutput() { stop(); }

double FeedbackOutput::steady_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Result<TouchCapabilities> FeedbackOutput::open() {
    stop();
    Result<std::unique_ptr<FeedbackNode>> node = opener_();
    if (!node.ok())
        return Error{node.error()};
    writer_.reset();
    wire_ = std::make_shared<Wire>();
    wire_->node = std::move(node).value();
    wire_->clock = clock_;
    wire_->trouble = trouble_;
    trouble_->store(Trouble::none);
    kind_ = wire_->node->kind();
    if (const int error = wire_->node->upload(unplayed); error != 0) {
        wire_->node.reset();
        if (error == ENOSPC)
            return Error{"Other programs use all that the " + identity_.name +
                         " can play. Close them and try again."};
        return Error{sentence(error == EINVAL ? OpenProblem::other : open_problem_of(error), this_system(),
                              identity_.name)};
    }
    wire_->stored = unplayed;
    writer_ = std::make_unique<LatestWriter>(wire_, no_effect, thread_);
    open_ = true;
    TouchCapabilities can;
    can.name = identity_.name;
    can.serial_number = identity_.serial_number;
    can.means = plays_waves(kind_) ? TouchMeans::ticks : TouchMeans::rumble;
    can.delay = feedback_delay_s(kind_);
    can.shortest_s = shortest_feedback_s(kind_);
    can.rate = 1.0 / can.shortest_s;
    return can;
}

bool FeedbackOutput::resist(double) noexcept { return open_ && !lost(); }

bool FeedbackOutput::tick(const Tick& tick) noexcept {
    if (!open_ || lost())
        return false;
    if (tick.empty())
        return true;
    const std::uint64_t message = packed(feedback_of(tick, kind_));
    wire_->asked_at.store(clock_(), std::memory_order_release);
    wire_->newest.store(message, std::memory_order_release);
    writer_->post(message);
    return true;
}

void FeedbackOutput::halt() noexcept {
    if (!writer_)
        return;
    wire_->newest.store(no_effect, std::memory_order_release);
    writer_->halt();
}

void FeedbackOutput::deliver() noexcept {
    if (open_)
        writer_->deliver();
}

void FeedbackOutput::stop() noexcept {
    if (!open_)
        return;
    open_ = false;
    wire_->newest.store(no_effect, std::memory_order_release);
    if (writer_->end()) // else it holds the wire itself
        wire_->node.reset();
}

bool FeedbackOutput::lost() const noexcept {
    if (!open_)
        return writer_ && writer_->lost();
    if (!writer_->lost() && !wire_->node->there()) {
        trouble_->store(Trouble::gone, std::memory_order_release);
        writer_->lose();
    }
    return writer_->lost();
}

std::string FeedbackOutput::complaint() const {
    switch (trouble_->load(std::memory_order_acquire)) {
    case Trouble::none:
        break;
    case Trouble::late:
        return "The " + identity_.name +
               " answers too slowly to tell of lines. Unplug it and plug it in again; if that does not help, "
               "choose another output.";
    case Trouble::refused:
        return "The " + identity_.name +
               " did not play what it was told. Close other programs that use it, unplug it and plug it in "
               "again.";
    case Trouble::gone:
        return sentence(OpenProblem::gone, this_system(), identity_.name);
    }
    return {};
}

} // namespace tp
