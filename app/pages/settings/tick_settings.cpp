// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/tick_settings.hpp"

#include "audio/sentences/sentences.hpp"
#include "core/servo/clock.hpp"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr Vec2 no_surface(100.0, 100.0); ///< nothing is felt but ticks that are asked for
constexpr int felt_ms = 500;             ///< a tick, and its sound, are over by then
constexpr double tick_s = 0.016;

int in_ms(double seconds) { return static_cast<int>(1000.0 * seconds); }

} // namespace

TickSettings::TickSettings(SettingSteps& steps, Narrator& narrator, Setup setup)
    : steps_(steps), narrator_(narrator), now_(std::move(setup.now)),
      pause_before_(std::move(setup.pause_before)), connector_(std::move(setup.access)) {
    if (!now_)
        now_ = [] { return SteadyClock().now(); };
    next_.setSingleShot(true);
    connect(&next_, &QTimer::timeout, this, &TickSettings::go_on);
    connect(&steps_, &SettingSteps::changed, this, &TickSettings::changed);
    connect(&connector_, &TouchConnector::looked, this, &TickSettings::changed);
    connect(&connector_, &TouchConnector::opened, this,
            [this](const std::shared_ptr<OpenTouch>& open) { use(*open); });
    connect(&connector_, &TouchConnector::refused, this, &TickSettings::end);
}

QStringList TickSettings::names() const {
    QStringList names;
    for (const ListedTouchOutput& one : connector_.there())
        names << in_persons_language(one.about);
    return names;
}

const ListedTouchOutput* TickSettings::chosen() const {
    return touch_for(connector_.there(), steps_.now().touch);
}

double TickSettings::latency() const {
    const ListedTouchOutput* one = chosen();
    return one == nullptr ? steps_.now().touch_latency_s
                          : touch_latency_s(steps_.now(), key_of(*one), one->delay);
}

int TickSettings::current() const {
    const ListedTouchOutput* one = chosen();
    return one == nullptr ? -1 : static_cast<int>(one - connector_.there().data());
}

void TickSettings::enter() { connector_.watch(true); }

void TickSettings::leave() {
    stop();
    connector_.watch(false);
}

void TickSettings::choose(int index) {
    if (index < 0 || index >= names().size())
        return;
    const QString key = key_of(connector_.there()[static_cast<std::size_t>(index)]);
    steps_.make(tr("what ticks"), tr("Ticks: %1.").arg(names()[index]),
                [&key](Choices& choices) { choices.touch = key; });
}

void TickSettings::setStrength(double share) {
    const double bounded = std::clamp(share, 0.1, 1.0);
    steps_.make(tr("the strength of ticks"),
                tr("Strength of ticks: %1 percent.").arg(qRound(100.0 * bounded)),
                [bounded](Choices& choices) { choices.touch_strength = bounded; });
}

void TickSettings::setSharpness(double share) {
    const double bounded = std::clamp(share, 0.0, 1.0);
    steps_.make(tr("the sharpness of ticks"),
                tr("Sharpness of ticks: %1 percent.").arg(qRound(100.0 * bounded)),
                [bounded](Choices& choices) { choices.touch_sharpness = bounded; });
}

void TickSettings::setLatency(double seconds) {
    const ListedTouchOutput* one = chosen();
    set_latency(one == nullptr ? QString() : key_of(*one), seconds);
}

/// Of that output; without a key, of all that have none of their own.
void TickSettings::set_latency(const QString& key, double seconds) {
    const double bounded = std::clamp(seconds, 0.0, TapTest::longest_latency_s);
    steps_.make(tr("how late ticks are felt"),
                tr("Ticks are felt %n millisecond(s) late.", nullptr, qRound(1000.0 * bounded)),
                [&key, bounded](Choices& choices) {
                    if (key.isEmpty())
                        choices.touch_latency_s = bounded;
                    else
                        choices.touch_latencies_s[key] = bounded;
                });
}

void TickSettings::open(Doing wish) {
    end();
    const ListedTouchOutput* one = chosen();
    if (one == nullptr)
        return steps_.tell(tr("There is nothing here that ticks under a finger."));
    doing_ = wish;
    measured_ = key_of(*one);
    connector_.open(*one);
}

void TickSettings::use(OpenTouch& open) {
    drive_ = std::make_unique<TouchDrive>(std::move(open.output), open.can, no_surface, TouchSettings{});
    drive_->loop().start();
    ticks_ = 0;
    taps_ = {};
    if (doing_ == Doing::opening_to_feel) {
        doing_ = Doing::feeling;
        steps_.tell(tr("Now."));
        return next_.start(felt_ms);
    }
    doing_ = Doing::measuring;
    narrator_.tell_then(
        tr("Seven ticks come. Press Space as soon as you feel one. The time from a tick to the key, less "
           "what people usually take, is how late ticks are felt; it is only about right."),
        [this] {
            if (measuring() && ticks_ == 0)
                next_.start(in_ms(pause_before_(0)));
        });
    emit changed();
}

void TickSettings::end(const QString& sentence) {
    next_.stop();
    connector_.cancel();
    connector_.release(std::move(drive_));
    const bool was = std::exchange(doing_, Doing::nothing) == Doing::measuring;
    if (!sentence.isEmpty())
        steps_.tell(sentence);
    if (was)
        emit changed();
}

/// The pause is over.
void TickSettings::go_on() {
    if (drive_->loop().snapshot().lost)
        return end(tr("What ticks is gone."));
    const Tick tick(steps_.now().touch_strength, steps_.now().touch_sharpness, tick_s);
    if (ticks_ == 0 || doing_ == Doing::measuring) {
        if (doing_ == Doing::measuring && ticks_ == TapTest::ticks)
            return finish_measuring();
        drive_->loop().feel(tick);
        taps_.ticked(now_());
        ++ticks_;
        return next_.start(doing_ == Doing::feeling ? felt_ms : in_ms(pause_before_(ticks_)));
    }
    end();
}

void TickSettings::tap() {
    if (measuring())
        taps_.tapped(now_());
}

void TickSettings::finish_measuring() {
    const std::optional<double> latency = taps_.latency();
    if (!latency)
        return end(tr("Too few ticks were answered. Nothing was changed."));
    end();
    set_latency(measured_, *latency);
}

bool TickSettings::stop() {
    if (doing_ == Doing::nothing)
        return false;
    end(tr("Ended."));
    return true;
}

} // namespace tp
