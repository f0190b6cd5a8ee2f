// SPDX-License-Identifier: Apache-2.0
#include "device/open_problem.hpp"
#include "device/touch_output/force_feedback/event_nodes.hpp"

#include <cerrno>
#include <fcntl.h>
#include <linux/input.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace tp {

namespace {

int errno_of(int result) { return result < 0 ? errno : 0; }

template <typename Argument>
int asked_of_driver(int descriptor, unsigned long request, Argument argument) {
    int error = 0;
    do
        error = errno_of(::ioctl(descriptor, request, argument));
    while (error == EINTR);
    return error;
}

class EventNode final : public FeedbackNode {
public:
    EventNode(int descriptor, FeedbackKind kind) : descriptor_(descriptor), kind_(kind) { effect_.id = -1; }
    ~EventNode() override {
        ::close(descriptor_);
    } // the kernel ends and forgets what this descriptor put there
    EventNode(const EventNode&) = delete;
    EventNode& operator=(const EventNode&) = delete;

    FeedbackKind kind() const override { return kind_; }

    int upload(const FeedbackEffect& effect) noexcept override {
        effect_.replay.length = effect.length_ms;
        if (plays_waves(kind_)) {
            effect_.type = FF_PERIODIC;
            effect_.u.periodic.waveform = kind_ == FeedbackKind::sine ? FF_SINE : FF_SQUARE;
            effect_.u.periodic.period = effect.period_ms;
            effect_.u.periodic.magnitude = static_cast<__s16>(effect.strong >> 1);
        } else {
            effect_.type = FF_RUMBLE;
            effect_.u.rumble.strong_magnitude = effect.strong;
            effect_.u.rumble.weak_magnitude = effect.weak;
        }
        return asked_of_driver(descriptor_, EVIOCSFF, &effect_);
    }

    int play(bool on) noexcept override { return tell(static_cast<__u16>(effect_.id), on ? 1 : 0); }

    bool there() const noexcept override {
        pollfd node{descriptor_, 0, 0};
        return ::poll(&node, 1, 0) <= 0 || (node.revents & (POLLHUP | POLLERR)) == 0;
    }

    /// Another program that has grabbed it keeps every other one's effects from being played, without a word.
    int find_grabbed() const {
        const int error = asked_of_driver(descriptor_, EVIOCGRAB, 1UL);
        if (error == 0)
            asked_of_driver(descriptor_, EVIOCGRAB, 0UL);
        return error;
    }

    /// What another program turned down would stay so.
    void turn_up() noexcept {
        unsigned char can[FF_CNT / 8] = {};
        constexpr unsigned whole_gain = 0xFFFF;
        if (::ioctl(descriptor_, EVIOCGBIT(EV_FF, sizeof can), can) >= 0 &&
            (can[FF_GAIN / 8] >> FF_GAIN % 8 & 1) != 0)
            tell(FF_GAIN, whole_gain);
    }

private:
    int tell(__u16 code, unsigned value) const noexcept {
        input_event event{};
        event.type = EV_FF;
        event.code = code;
        event.value = static_cast<__s32>(value);
        ssize_t written = 0;
        do
            written = ::write(descriptor_, &event, sizeof event);
        while (written < 0 && errno == EINTR);
        return written == static_cast<ssize_t>(sizeof event) ? 0 : written < 0 ? errno : EIO;
    }

    int descriptor_;
    FeedbackKind kind_;
    ff_effect effect_{};
};

} // namespace

std::vector<FoundFeedback> find_feedback() { return find_feedback_below("/sys/class/input", "/dev/input"); }

Result<std::unique_ptr<FeedbackNode>> open_feedback(const FoundFeedback& found) {
    const int descriptor = ::open(found.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return Error{sentence(open_problem_of(errno), this_system(), found.name)};
    auto node = std::make_unique<EventNode>(descriptor, found.kind);
    if (const int error = node->find_grabbed(); error != 0)
        return Error{
            sentence(error == EBUSY ? OpenProblem::busy : OpenProblem::gone, this_system(), found.name)};
    node->turn_up();
    return std::unique_ptr<FeedbackNode>(std::move(node));
}

} // namespace tp
