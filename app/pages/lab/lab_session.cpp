// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_session.hpp"

#include "app/pages/lab/lab_photo.hpp"
#include "app/pages/lab/lab_words.hpp"
#include "app/pages/lab/sample_scenes.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr int poll_ms = 16;
constexpr int polls_a_plot = 5;     ///< 80 ms
constexpr int polls_a_reading = 31; ///< half a second
constexpr double fault_again_s = 3.0;
constexpr double hang_s = 0.2;
constexpr std::size_t most_steps = 100;
constexpr int photo_scene = 3;

} // namespace

LabSession::LabSession(Narrator& narrator, Preferences& preferences, LabSettings settings)
    : narrator_(narrator), preferences_(preferences), settings_(std::move(settings)),
      clock_(settings_.time != nullptr ? static_cast<Clock&>(*settings_.time) : steady_),
      found_{{simulated_device_name, {}, {}, {}}}, files_(settings_.folder),
      field_(surface(), [this] { emit fieldChanged(); }), extractor_(std::make_shared<std::unique_ptr<FaceExtractor>>()) {
    status_ = tr("Nothing runs.");
    take(parameters_);
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &LabSession::poll);
    use_scene(0, scenes()[0], flatten(sample_scene(LabShape::circle, surfaceWidth(), surfaceHeight())));
    read_out();
}

LabSession::~LabSession() { servo_.reset(); }

QPointF LabSession::to_sheet(Vec2 p) const { return {p.x + 0.5 * surfaceWidth(), 0.5 * surfaceHeight() - p.y}; }

Vec2 LabSession::to_surface(QPointF p) const {
    const Rect area = surface();
    return glm::clamp(Vec2(p.x() + area.min.x, area.max.y - p.y()), area.min, area.max);
}

Rect LabSession::surface() const {
    const Vec2 half(0.5 * surfaceWidth(), 0.5 * surfaceHeight());
    return {-half, half};
}

/// Tells it, and keeps it in sight.
void LabSession::say(const QString& sentence) {
    status_ = sentence;
    emit changed();
    narrator_.tell(sentence, Priority::message);
}

void LabSession::become(State state, const QString& status) {
    state_ = state;
    say(status);
}

void LabSession::enter() {
    tell(tr("The lab. A finger on a simulated device, a force field, and everything that can be turned. Space on the surface "
            "starts the servo, Escape stops it."));
    findDevices();
    emit recordingsChanged();
}

void LabSession::leave() {
    stop();
    photo_work_.cancel();
    device_work_.cancel();
    narrator_.stop();
}

bool LabSession::stop() {
    const bool loading = photo_work_.busy();
    photo_work_.cancel();
    replay_work_.cancel();
    if (state_ == Stopped && !loading)
        return false;
    if (state_ == Opening)
        device_work_.cancel();
    timer_.stop();
    end_run();
    const QString told = recording_ ? finish_recording() : tr("Stopped.");
    playback_.reset();
    force_ = Vec2(0.0);
    become(Stopped, told);
    emit moved();
    return true;
}

// --- what is felt ---

QStringList LabSession::scenes() const {
    const QString photo = photo_.isEmpty() ? tr("Photograph") : tr("Photograph %1").arg(QFileInfo(photo_).fileName());
    return {tr("Circle, radius 40 mm"), tr("Triangle, 50 mm high"), tr("Curved path, 200 mm wide"), photo};
}

void LabSession::use_scene(int index, const QString& name, FlatScene flat) {
    scene_ = index;
    scene_name_ = name;
    flat_ = std::move(flat);
    apply(LabEffect::scene);
    emit changed();
}

void LabSession::chooseScene(int index) {
    if (index < 0 || index >= scenes().size() || fixed())
        return;
    photo_work_.cancel();
    if (index == photo_scene)
        return use_photo(photo_.isEmpty() ? preferences_.choices().last_photo : photo_);
    use_scene(index, scenes()[index],
              flatten(sample_scene(static_cast<LabShape>(index), surfaceWidth(), surfaceHeight())));
    tell(scenes()[index] + '.');
}

void LabSession::openPhoto(const QUrl& file) {
    if (fixed())
        return;
    if (file.isLocalFile())
        use_photo(file.toLocalFile());
    else
        say(tr("Only a photograph that is a file on this computer can be opened."));
}

void LabSession::use_photo(const QString& file) {
    if (file.isEmpty())
        return say(tr("There is no photograph yet. Open one, or drop one on the page."));
    say(tr("Looking for faces in %1.").arg(QFileInfo(file).fileName()));
    photo_work_.ask([this, file, path = file.toStdString(), surface = settings_.surface,
                     extractor = extractor_](const std::stop_token& stop) -> NewestWork::Answer {
        auto photo = std::make_shared<LabPhoto>(read_photo(path, surface, *extractor, stop));
        return [this, photo, file] {
            if (!photo->problem.empty())
                return say(tr("%1: %2").arg(QFileInfo(file).fileName(), in_persons_language(photo->problem)));
            if (fixed())
                return;
            photo_ = file;
            use_scene(photo_scene, QFileInfo(file).fileName(), std::move(photo->flat));
            say(tr("%1: %n line(s) can be felt.", nullptr, static_cast<int>(flat_.lines.size()))
                    .arg(QFileInfo(file).fileName()));
        };
    });
}

QString LabSession::fieldWords() const {
    return tr("Force field of %1: colours and arrows from 0 to %2 newtons. The rule is 20 mm long.")
        .arg(scene_name_, QLocale().toString(parameters_.stiffness * parameters_.range, 'f', 2));
}

// --- parameters ---

QStringList LabSession::laws() const { return {tr("Exact"), tr("Published Algorithm 1")}; }

/// What a recording was begun with stays, so that it can be computed again. True, and told, where nothing may change.
bool LabSession::fixed() {
    if (recording_)
        tell(tr("Nothing can be changed during a recording. Escape ends it."));
    else if (state_ == Replaying)
        tell(tr("Nothing can be changed during a replay. Escape ends it."));
    return recording_ || state_ == Replaying;
}

template <typename Change>
void LabSession::make(const QString& what, const QString& said, Change change) {
    LabParameters wanted = parameters_;
    change(wanted);
    if (wanted == parameters_)
        return;
    if (fixed())
        return;
    // A slider that is moved on is one step, not many.
    if (history_.empty() || history_.back().what != what)
        history_.push_back({what, parameters_});
    if (history_.size() > most_steps)
        history_.erase(history_.begin());
    take(wanted);
    emit changed();
    tell(said);
}

/// These hold from now on, wherever they are used.
void LabSession::take(const LabParameters& parameters) {
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
        apply(LabEffect::scene);
    apply(of_loop ? LabEffect::loop : LabEffect::live);
}

void LabSession::apply(LabEffect effect) {
    if (effect == LabEffect::scene) {
        Result<std::unique_ptr<HapticScene>> made = felt_scene(flat_, parameters_);
        if (!made)
            return say(in_persons_language(made.error()));
        felt_ = std::move(made).value();
        field_.show(felt_);
        if (servo_ && !recording_)
            servo_->render(felt_scene(flat_, parameters_).value());
    } else if (servo_ && effect == LabEffect::live) {
        servo_->tell(allowed());
    } else if (servo_ && simulated()) {
        end_run();
        open({});
    } else if (servo_) { // nobody is pulled by a real device that was made anew unasked
        stop();
    }
}

void LabSession::chooseLaw(int index) {
    if (index >= 0 && index < laws().size())
        make(tr("the law"), laws()[index] + '.', [&](LabParameters& p) { p.law = static_cast<LawKind>(index); });
}

void LabSession::setNumber(const QString& key, double value, const QString& label) {
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

void LabSession::setSwitch(const QString& key, bool on, const QString& label) {
    if (const LabSwitch* one = lab_switch(key.toStdString()))
        make(label, on ? tr("%1: on.").arg(label) : tr("%1: off.").arg(label),
             [&](LabParameters& p) { p.*one->member = on; });
}

double LabSession::lowest(const QString& key) const {
    const LabNumber* number = lab_number(key.toStdString());
    return number == nullptr ? 0.0 : number->lowest;
}
double LabSession::highest(const QString& key) const {
    const LabNumber* number = lab_number(key.toStdString());
    return number == nullptr ? 0.0 : number->highest;
}
double LabSession::step(const QString& key) const {
    const LabNumber* number = lab_number(key.toStdString());
    return number == nullptr ? 0.0 : number->step;
}

QString LabSession::words(const QString& key, double value) const { return parameter_words(key, value); }

void LabSession::reset() {
    make(tr("the reset"), tr("Law, servo, device and faults are as they were at first."),
         [](LabParameters& p) { p = {}; });
}

void LabSession::undo() {
    if (history_.empty())
        return tell(tr("There is nothing to take back."));
    if (fixed())
        return;
    const Step last = history_.back();
    history_.pop_back();
    take(last.before);
    emit changed();
    tell(tr("Taken back: %1.").arg(last.what));
}

// --- devices and the servo ---

QStringList LabSession::devices() const {
    QStringList names{tr("Simulated: the mouse or a finger on the screen")};
    for (std::size_t i = 1; i < found_.size(); ++i)
        names << tr("%1, %2").arg(in_persons_language(found_[i].about), QString::fromStdString(found_[i].name));
    return names;
}

void LabSession::findDevices() {
    if (state_ == Opening || !settings_.find_devices)
        return;
    device_work_.ask([this, find = settings_.find_devices](const std::stop_token&) -> NewestWork::Answer {
        return [this, found = find()] {
            const std::string used = found_[static_cast<std::size_t>(device_)].name;
            found_ = {{simulated_device_name, {}, {}, {}}};
            for (const ListedDevice& one : found)
                if (one.name != simulated_device_name)
                    found_.push_back(one);
            const auto same = std::find_if(found_.begin(), found_.end(),
                                           [&](const ListedDevice& one) { return one.name == used; });
            if (same == found_.end())
                stop();
            device_ = same == found_.end() ? 0 : static_cast<int>(same - found_.begin());
            emit changed();
        };
    });
}

void LabSession::chooseDevice(int index) {
    if (index < 0 || index >= static_cast<int>(found_.size()) || index == device_)
        return;
    stop();
    device_ = index;
    emit changed();
    tell(devices()[index] + '.');
}

/// What the loop is given: on a real device never more than the person's own strongest force, and its faults are its own.
LabParameters LabSession::allowed() const {
    LabParameters parameters = parameters_;
    if (!simulated())
        parameters.max_force = std::min(parameters.max_force, preferences_.choices().max_force_n);
    return parameters;
}

void LabSession::start() {
    if (state_ == Running || state_ == Opening)
        return;
    stop();
    open({});
}

void LabSession::open(const std::filesystem::path& recording) {
    const DeviceChain::Wish wish{found_[static_cast<std::size_t>(device_)].name, recording};
    if (simulated()) {
        Result<std::shared_ptr<DeviceChain>> chain = DeviceChain::open(wish, settings_.surface, parameters_, clock_);
        if (!chain) {
            recording_ = false;
            timer_.stop();
            return become(Stopped, in_persons_language(chain.error()));
        }
        return run(*chain);
    }
    become(Opening, tr("Opening %1.").arg(devices()[device_]));
    device_work_.ask([this, wish, surface = settings_.surface, parameters = parameters_,
                      &clock = clock_](const std::stop_token&) -> NewestWork::Answer {
        auto chain = std::make_shared<Result<std::shared_ptr<DeviceChain>>>(
            DeviceChain::open(wish, surface, parameters, clock));
        return [this, chain] {
            if (chain->ok())
                return run(chain->value());
            recording_ = false;
            become(Stopped, in_persons_language(chain->error()));
        };
    });
}

void LabSession::run(const std::shared_ptr<DeviceChain>& chain) {
    const bool anew = state_ == Running; // a parameter was turned: what runs goes on
    const Capabilities& can = chain->capabilities();
    if (SimulatedDevice* device = chain->simulated())
        device->place_finger(pointer_);
    trace_.begin(can.rate, static_cast<std::size_t>(std::lround(can.delay * can.rate)));
    fault_ = told_ = Fault::none;
    servo_ = std::make_unique<LabServo>(chain, felt_scene(flat_, parameters_).value(), allowed(), clock_,
                                        settings_.time != nullptr);
    state_ = Running;
    if (settings_.time == nullptr)
        timer_.start();
    if (anew)
        emit changed();
    else
        become(Running, recording_ ? tr("Recording: %1. Escape ends it.").arg(in_persons_language(can.name))
                                   : tr("The servo runs: %1. Escape stops it.").arg(in_persons_language(can.name)));
}

void LabSession::end_run() {
    if (!servo_)
        return;
    if (RecordingDevice* recorder = servo_->chain().recorder())
        recording_whole_ = recorder->flush() && recording_whole_;
    servo_.reset();
}

void LabSession::hang() {
    FaultyDevice* faults = servo_ ? servo_->chain().faults() : nullptr;
    if (faults == nullptr)
        return tell(tr("Only a simulated device that runs can be made to hang."));
    faults->hang_once(hang_s);
    tell(tr("The device hangs for 200 milliseconds."));
}

void LabSession::touchDown(double x, double y) {
    pointer_ = to_surface({x, y});
    if (servo_ && servo_->chain().simulated() != nullptr)
        servo_->chain().simulated()->place_finger(pointer_);
    else if (state_ == Stopped)
        finger_ = pointer_;
    emit moved();
}

void LabSession::moveTo(double x, double y) {
    pointer_ = to_surface({x, y});
    if (servo_ && servo_->chain().simulated() != nullptr)
        servo_->chain().simulated()->move_pointer(pointer_);
    else if (state_ == Stopped)
        finger_ = pointer_;
    emit moved();
}

void LabSession::nudge(double dx, double dy) {
    const QPointF to = pointer() + QPointF(dx, dy);
    moveTo(to.x(), to.y());
}

void LabSession::whereAmI() {
    const Guidance guidance = felt_->law->at(finger_);
    QString sentence = tr("The finger is %1. ").arg(middle_words(finger_));
    if (guidance.contour < 0 || !(guidance.distance < felt_->profile.band()))
        sentence += tr("No line pulls there.");
    else
        sentence += tr("%1 mm from %2; the law pulls with %3 newtons.")
                        .arg(QLocale().toString(guidance.distance, 'f', 1),
                             QString::fromStdString(felt_->flat.names[static_cast<std::size_t>(guidance.contour)]),
                             QLocale().toString(length(guidance.force), 'f', 2));
    tell(sentence);
}

// --- what goes on ---

void LabSession::advance(double seconds) {
    if (servo_)
        servo_->run_for(seconds);
    else
        clock_.sleep_until(clock_.now() + seconds);
    poll();
    read_out();
    emit plotted();
}

void LabSession::poll() {
    if (state_ == Running)
        poll_run();
    else if (state_ == Replaying)
        poll_replay();
    ++polls_;
    if (polls_ % polls_a_plot == 0)
        emit plotted();
    if (polls_ % polls_a_reading == 0)
        read_out();
}

void LabSession::poll_run() {
    for (const TickSample& tick : servo_->chain().take())
        trace_.add(tick);
    if (RecordingDevice* recorder = servo_->chain().recorder())
        recording_whole_ = recorder->flush() && recording_whole_;
    const ServoSnapshot now = servo_->snapshot();
    if (now.ticks > 0) {
        finger_ = now.finger();
        force_ = now.force();
    }
    emit moved();
    watch(now.fault);
}

/// A fault is told when it comes, and not again while it flickers.
void LabSession::watch(Fault fault) {
    if (fault == fault_)
        return;
    fault_ = fault;
    if (fault == Fault::none)
        return;
    const bool same = fault == told_ && clock_.now() - told_at_ < fault_again_s;
    told_ = fault;
    told_at_ = clock_.now();
    const QString sentence = in_persons_language(std::string(tp::sentence(fault)));
    if (disables(fault)) {
        stop();
        status_ = status_ + ' ' + sentence;
        emit changed();
        narrator_.tell(status_, Priority::fault);
    } else if (!same) {
        status_ = sentence;
        emit changed();
        narrator_.tell(sentence, Priority::fault);
    }
}

void LabSession::poll_replay() {
    for (const TickSample& tick : playback_->due(clock_.now())) {
        trace_.add(tick);
        finger_ = pointer_ = tick.place;
        force_ = tick.force;
    }
    emit moved();
    if (!playback_->over())
        return;
    timer_.stop();
    playback_.reset();
    read_out();
    emit plotted();
    become(Stopped, tr("The replay has ended. %1").arg(replay_words_));
}

void LabSession::read_out() {
    readings_.clear();
    for (const Quantity quantity : {Position, Force, Energy, Lateness})
        readings_ << plot_words(trace_, static_cast<TraceQuantity>(quantity));
    emit readingsChanged();
}

void LabSession::readPlots() {
    read_out();
    tell(readings_.join(' '));
}

// --- files ---

std::string LabSession::setup() const {
    return setup_json({allowed(), scene_name_.toStdString(), flat_, !simulated()});
}

void LabSession::toggleRecording() {
    if (recording_) {
        stop();
        return;
    }
    stop();
    if (const std::string reason = files_.make_folder(); !reason.empty())
        return say(tr("The folder %1 cannot be made: %2").arg(folder(), in_persons_language(reason)));
    recording_file_ = files_.new_file(".touch");
    if (const std::string reason = replace_file(setup_file(recording_file_), setup()); !reason.empty())
        return say(tr("The recording cannot be begun: %1").arg(in_persons_language(reason)));
    recording_ = true;
    recording_whole_ = true;
    open(recording_file_);
}

QString LabSession::finish_recording() {
    recording_ = false;
    emit recordingsChanged();
    if (!recording_whole_)
        return tr("The recording is not whole, because the disk is full or this computer was too busy.");
    return tr("Recorded in %1; the parameters lie beside it.").arg(LabFiles::path_words(recording_file_));
}

void LabSession::replay(int index) {
    const QStringList names = recordings();
    if (index < 0 || index >= names.size())
        return;
    stop();
    say(tr("Reading %1.").arg(names[index]));
    replay_work_.ask([this, file = files_.recording(names[index])](const std::stop_token& stop_asked)
                         -> NewestWork::Answer {
        auto read = std::make_shared<Result<LabReplay>>(read_replay(file, stop_asked));
        return [this, read, name = QString::fromStdString(file.filename().string())] {
            if (!read->ok())
                return say(in_persons_language(read->error()));
            if (state_ != Stopped)
                return;
            LabReplay replay = std::move(*read).value();
            if (replay.ticks.empty())
                return say(tr("%1 holds nothing.").arg(name));
            replay_words_ = replay_words(replay);
            trace_.begin(replay.rate, replay.delay_ticks);
            playback_.emplace(std::move(replay.ticks), clock_.now());
            if (settings_.time == nullptr)
                timer_.start();
            become(Replaying, tr("Replaying %1. Escape ends it.").arg(name));
        };
    });
}

void LabSession::writeTable() {
    if (trace_.points().empty())
        return say(tr("There is nothing to write yet. Start the servo first."));
    if (const std::string reason = files_.make_folder(); !reason.empty())
        return say(tr("The folder %1 cannot be made: %2").arg(folder(), in_persons_language(reason)));
    const std::filesystem::path table = files_.new_file(".csv");
    std::string reason = replace_file(table, trace_.csv());
    if (reason.empty())
        reason = replace_file(setup_file(table), setup());
    if (!reason.empty())
        return say(tr("%1 cannot be written: %2").arg(LabFiles::path_words(table), in_persons_language(reason)));
    say(tr("%n row(s) are in %1; the parameters lie beside them.", nullptr, static_cast<int>(trace_.points().size()))
            .arg(LabFiles::path_words(table)));
}

} // namespace tp
