// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_run.hpp"

#include "audio/sentences/sentences.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tp {

namespace {

constexpr double fault_again_s = 3.0;
constexpr double hang_s = 0.2;

} // namespace

LabRun::LabRun(const Around& around) : around_(around) {
    connect(&around.tuning, &LabTuning::turned, this, &LabRun::turn);
    connect(&around.scene, &LabScene::rendered, this, [this] {
        if (servo_ && !around_.activity.recording())
            servo_->render(around_.scene.for_servo());
    });
    connect(&around.hand, &LabHand::placed, this, [this](Vec2 place) {
        if (servo_ && servo_->chain().simulated() != nullptr)
            servo_->chain().simulated()->place_finger(place);
    });
    connect(&around.hand, &LabHand::led, this, [this](Vec2 place) {
        if (servo_ && servo_->chain().simulated() != nullptr)
            servo_->chain().simulated()->move_pointer(place);
    });
}

/// What the loop is given: on a real device never more than the person's own strongest force, and its faults
/// are its own.
LabParameters LabRun::allowed() const {
    LabParameters parameters = around_.tuning.parameters();
    if (!around_.devices.simulated())
        parameters.max_force = std::min(parameters.max_force, around_.preferences.choices().max_force_n);
    return parameters;
}

std::string LabRun::setup() const {
    return setup_json(
        {allowed(), around_.scene.name().toStdString(), around_.scene.flat(), !around_.devices.simulated()});
}

void LabRun::start() {
    if (around_.activity.running() || around_.activity.opening())
        return;
    around_.activity.stop();
    open({});
}

void LabRun::open(const std::filesystem::path& recording) {
    const bool recorded = !recording.empty();
    const bool goes_on = around_.activity.state() == LabActivity::Running;
    if (recorded)
        whole_ = true;
    if (!around_.devices.simulated()) {
        around_.activity.become(recorded ? LabActivity::OpeningToRecord : LabActivity::Opening);
        around_.teller.say(tr("Opening %1.").arg(around_.devices.name()));
    }
    around_.devices.open(recording, around_.scene.size(), around_.tuning.parameters(), around_.clock,
                         [this, recorded, goes_on](const Result<std::shared_ptr<DeviceChain>>& chain) {
                             if (chain)
                                 return run(*chain, recorded, goes_on);
                             around_.activity.become(LabActivity::Stopped);
                             around_.teller.say(in_persons_language(chain.error()));
                         });
}

/// `goes_on`: a parameter was turned, and what runs goes on without a word.
void LabRun::run(const std::shared_ptr<DeviceChain>& chain, bool recorded, bool goes_on) {
    const Capabilities& can = chain->capabilities();
    if (SimulatedDevice* device = chain->simulated())
        device->place_finger(around_.hand.place());
    around_.measurements.begin(can.rate, static_cast<std::size_t>(std::lround(can.delay * can.rate)));
    fault_ = told_ = Fault::none;
    servo_ = std::make_unique<LabServo>(chain, around_.scene.for_servo(), allowed(), around_.clock,
                                        around_.virtual_time);
    around_.activity.become(recorded ? LabActivity::Recording : LabActivity::Running);
    if (!goes_on)
        around_.teller.say(
            recorded ? tr("Recording: %1. Escape ends it.").arg(in_persons_language(can.name))
                     : tr("The servo is running: %1. Escape stops it.").arg(in_persons_language(can.name)));
}

void LabRun::turn(bool anew) {
    if (!servo_)
        return;
    if (!anew)
        return servo_->tell(allowed());
    if (!around_.devices.simulated()) // nobody is pulled by a real device that was made anew unasked
        return around_.activity.stop();
    end();
    open({});
}

void LabRun::flush() {
    if (RecordingDevice* recorder = servo_->chain().recorder())
        whole_ = recorder->flush() && whole_;
}

bool LabRun::end() {
    if (servo_)
        flush();
    servo_.reset();
    return whole_;
}

void LabRun::hang() {
    FaultyDevice* faults = servo_ ? servo_->chain().faults() : nullptr;
    if (faults == nullptr)
        return around_.teller.tell(tr("Only a simulated device that is running can be made to hang."));
    faults->hang_once(hang_s);
    around_.teller.tell(tr("The device hangs for 200 milliseconds."));
}

bool LabRun::run_for(double seconds) {
    if (servo_)
        servo_->run_for(seconds);
    return servo_ != nullptr;
}

void LabRun::poll() {
    if (!servo_)
        return;
    for (const TickSample& tick : servo_->chain().take())
        around_.measurements.add(tick);
    flush();
    const ServoSnapshot now = servo_->snapshot();
    if (now.ticks > 0)
        around_.hand.show(now.finger(), now.force());
    watch(now.fault);
}

/// A fault is told when it comes, and not again while it flickers.
void LabRun::watch(Fault fault) {
    if (fault == fault_)
        return;
    fault_ = fault;
    if (fault == Fault::none)
        return;
    const bool same = fault == told_ && around_.clock.now() - told_at_ < fault_again_s;
    told_ = fault;
    told_at_ = around_.clock.now();
    const QString words = in_persons_language(std::string(sentence(fault)));
    if (disables(fault)) {
        around_.activity.stop();
        around_.teller.warn(around_.teller.status() + ' ' + words);
    } else if (!same) {
        around_.teller.warn(words);
    }
}

} // namespace tp
