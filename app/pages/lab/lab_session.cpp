// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_session.hpp"

namespace tp {

namespace {

constexpr int poll_ms = 16;

} // namespace

LabSession::LabSession(Narrator& narrator, Preferences& preferences, const LabSettings& settings)
    : virtual_time_(settings.time != nullptr),
      clock_(virtual_time_ ? static_cast<Clock&>(*settings.time) : steady_), teller_(narrator),
      activity_(teller_), tuning_(activity_, teller_),
      scene_(settings.surface, tuning_, activity_, preferences, teller_),
      devices_(settings.find_devices, activity_, teller_), hand_(scene_, activity_, teller_), plots_(teller_),
      run_(LabRun::Around{activity_, tuning_, scene_, devices_, hand_, plots_, teller_, preferences, clock_,
                          virtual_time_}),
      archive_(settings.folder, activity_, run_, plots_, teller_),
      replayer_(archive_, activity_, hand_, plots_, clock_, teller_) {
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &LabSession::poll);
    connect(&teller_, &LabTeller::changed, this, &LabSession::statusChanged);
    connect(&activity_, &LabActivity::stopAsked, this, &LabSession::stop);
    connect(&activity_, &LabActivity::changed, this, [this] {
        const bool polled =
            !virtual_time_ && (activity_.running() || activity_.state() == LabActivity::Replaying);
        if (polled)
            timer_.start();
        else
            timer_.stop();
    });
}

void LabSession::enter() {
    teller_.tell(tr("The lab. A finger on a simulated device, a force field, and everything that can be "
                    "adjusted. Space on the surface starts the servo, Escape stops it."));
    devices_.find();
    emit archive_.changed();
}

void LabSession::leave() {
    stop();
    devices_.cancel();
    teller_.silence();
}

bool LabSession::stop() {
    const bool reading = scene_.cancel();
    replayer_.end();
    if (activity_.stopped() && !reading)
        return false;
    if (activity_.opening())
        devices_.cancel();
    const bool whole = run_.end();
    const QString told = activity_.recording() ? archive_.finish(whole) : tr("Stopped.");
    activity_.become(LabActivity::Stopped);
    hand_.release();
    teller_.say(told);
    return true;
}

void LabSession::advance(double seconds) {
    if (!run_.run_for(seconds))
        clock_.sleep_until(clock_.now() + seconds);
    poll();
    plots_.renew();
}

void LabSession::poll() {
    run_.poll();
    replayer_.poll();
    plots_.poll();
}

} // namespace tp
