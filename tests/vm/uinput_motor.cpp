// SPDX-License-Identifier: Apache-2.0
#include "uinput_motor.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <linux/uinput.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tp::vm {

namespace {

double monotonic_now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

UinputMotor::UinputMotor(const std::string& name, std::initializer_list<int> bits, unsigned places)
    : file_(::open("/dev/uinput", O_RDWR | O_NONBLOCK | O_CLOEXEC)) {
    uinput_setup setup{};
    setup.id.bustype = BUS_VIRTUAL;
    setup.ff_effects_max = places;
    name.copy(setup.name, sizeof setup.name - 1);
    bool made = file_ >= 0 && ::ioctl(file_, UI_SET_EVBIT, EV_FF) == 0;
    for (const int bit : bits)
        made = made && ::ioctl(file_, UI_SET_FFBIT, bit) == 0;
    made = made && ::ioctl(file_, UI_DEV_SETUP, &setup) == 0 && ::ioctl(file_, UI_DEV_CREATE) == 0;
    if (made) {
        motor_ = std::thread([this] { serve(); });
        return;
    }
    std::perror("/dev/uinput");
    if (file_ >= 0)
        ::close(file_);
    file_ = -1;
}

UinputMotor::~UinputMotor() { unplug(); }

void UinputMotor::unplug() {
    if (!good())
        return;
    ::ioctl(file_, UI_DEV_DESTROY);
    quit_ = true;
    motor_.join();
    ::close(file_);
    file_ = -1;
}

void UinputMotor::serve() {
    while (!quit_) {
        pollfd waiting{file_, POLLIN, 0};
        if (::poll(&waiting, 1, 5) <= 0)
            continue;
        input_event event{};
        if (::read(file_, &event, sizeof event) != static_cast<ssize_t>(sizeof event))
            continue;
        if (event.type == EV_UINPUT && event.code == UI_FF_UPLOAD)
            keep(static_cast<unsigned>(event.value));
        else if (event.type == EV_UINPUT && event.code == UI_FF_ERASE)
            forget(static_cast<unsigned>(event.value));
        else if (event.type == EV_FF && event.code < FF_GAIN)
            note(event.value != 0 ? Happening::began : Happening::ended, event.code);
    }
}

void UinputMotor::keep(unsigned request) {
    uinput_ff_upload upload{};
    upload.request_id = request;
    if (::ioctl(file_, UI_BEGIN_FF_UPLOAD, &upload) != 0)
        return;
    ::usleep(static_cast<unsigned>(1e6 * slow_s_));
    note(Happening::kept, upload.effect.id, upload.effect);
    upload.retval = 0;
    ::ioctl(file_, UI_END_FF_UPLOAD, &upload);
}

void UinputMotor::forget(unsigned request) {
    uinput_ff_erase erase{};
    erase.request_id = request;
    if (::ioctl(file_, UI_BEGIN_FF_ERASE, &erase) != 0)
        return;
    note(Happening::forgotten, static_cast<int>(erase.effect_id));
    erase.retval = 0;
    ::ioctl(file_, UI_END_FF_ERASE, &erase);
}

void UinputMotor::note(Happening what, int id, const ff_effect& effect) {
    const std::lock_guard lock(mutex_);
    moments_.push_back({monotonic_now(), what, id, effect});
}

std::vector<UinputMotor::Moment> UinputMotor::moments() const {
    const std::lock_guard lock(mutex_);
    return moments_;
}

std::optional<UinputMotor::Moment> UinputMotor::last(Happening what) const {
    std::optional<Moment> found;
    for (const Moment& moment : moments())
        if (moment.what == what)
            found = moment;
    return found;
}

int UinputMotor::count(Happening what) const {
    const std::vector<Moment> all = moments();
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [what](const Moment& moment) { return moment.what == what; }));
}

} // namespace tp::vm
