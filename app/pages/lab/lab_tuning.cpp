// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_tuning.hpp"

#include "app/pages/lab/lab_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t most_steps = 100;

} // namespace

LabTuning::LabTuning(LabActivity& activity, LabTeller& teller) : activity_(activity), teller_(teller) {
    take(parameters_);
}

QStringList LabTuning::laws() const { return {tr("Exact"), tr("Published Algorithm 1")}; }

void LabTuning::make(const QString& what, const QString& said,
                     const std::function<void(LabParameters&)>& change) {
    LabParameters wanted = parameters_;
    change(wanted);
    if (wanted == parameters_ || activity_.refuses_change())
        return;
    // A slider that is moved on is one step, not many.
    if (history_.empty() || history_.back().what != what)
        history_.push_back({what, parameters_});
    if (history_.size() > most_steps)
        history_.erase(history_.begin());
    take(wanted);
    teller_.tell(said);
}

/// These hold from now on, wherever they are used.
void LabTuning::take(const LabParameters& parameters) {
    const LabParameters before = std::exchange(parameters_, parameters);
    bool of_scene = before.law != parameters.law;
    bool of_loop = false;
    const auto see = [&](const auto& one) {
        values_.insert(one.key, parameters.*one.member);
        const bool differs = before.*one.member != parameters.*one.member;
        of_scene = of_scene || (differs && one.effect == LabEffect::scene);
        of_loop = of_loop || (differs && one.effect == LabEffect::loop);
    };
    for (const LabNumber& number : lab_numbers())
        see(number);
    for (const LabSwitch& one : lab_switches())
        see(one);
    if (of_scene)
        emit sceneTurned();
    emit turned(of_loop);
    emit changed();
}

void LabTuning::chooseLaw(int index) {
    if (index >= 0 && index < laws().size())
        make(tr("the law"), laws()[index] + '.',
             [&](LabParameters& p) { p.law = static_cast<LawKind>(index); });
}

void LabTuning::setNumber(const QString& key, double value, const QString& label) {
    const LabNumber* number = lab_number(key.toStdString());
    if (number == nullptr || !std::isfinite(value))
        return;
    const double allowed = std::clamp(value, number->lowest, number->highest);
    make(label, tr("%1: %2.").arg(label, words(key, allowed)), [&](LabParameters& p) {
        p.*number->member = allowed;
        if (key == "hold" && allowed > 0.0) // the law has one of both
            p.blend = 0.0;
        if (key == "blend" && allowed > 0.0)
            p.hold = 0.0;
    });
}

void LabTuning::setSwitch(const QString& key, bool on, const QString& label) {
    if (const LabSwitch* one = lab_switch(key.toStdString()))
        make(label, on ? tr("%1: on.").arg(label) : tr("%1: off.").arg(label),
             [&](LabParameters& p) { p.*one->member = on; });
}

double LabTuning::lowest(const QString& key) const {
    const LabNumber* number = lab_number(key.toStdString());
    return number == nullptr ? 0.0 : number->lowest;
}
double LabTuning::highest(const QString& key) const {
    const LabNumber* number = lab_number(key.toStdString());
    return number == nullptr ? 0.0 : number->highest;
}
double LabTuning::step(const QString& key) const {
    const LabNumber* number = lab_number(key.toStdString());
    return number == nullptr ? 0.0 : number->step;
}

QString LabTuning::words(const QString& key, double value) const { return parameter_words(key, value); }

void LabTuning::reset() {
    make(tr("the reset"), tr("Law, servo, device and faults are reset."), [](LabParameters& p) { p = {}; });
}

void LabTuning::undo() {
    if (history_.empty())
        return teller_.tell(tr("There is nothing to undo."));
    if (activity_.refuses_change())
        return;
    const Step last = history_.back();
    history_.pop_back();
    take(last.before);
    teller_.tell(tr("Undone: %1.").arg(last.what));
}

} // namespace tp
