// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_setup.hpp"

#include "app/figures/study/own_experiments.hpp"
#include "app/pages/study/study_words.hpp"
#include "app/photo/study_faces/folder_faces.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/files/file_name.hpp"
#include "core/files/whole_file.hpp"
#include "core/trials/study_trial.hpp"

#include <QLocale>

#include <algorithm>
#include <string_view>
#include <utility>

namespace tp {

namespace {

constexpr int most_participants = 9999;
constexpr int most_answers = 9; ///< a key each

QString text_of(const std::filesystem::path& path) { return QString::fromStdString(name_in_utf8(path)); }

} // namespace

StudySetup::StudySetup(const StudySettings& settings, StudyFinger& finger, StudyKeeping& keeping,
                       StudyTeller& teller, Narrator& narrator)
    : settings_(settings), finger_(finger), keeping_(keeping), teller_(teller), chooser_(narrator) {
    for (const std::string_view name : own_experiments)
        if (const auto text = own_experiment(name))
            if (auto experiment = read_experiment(*text))
                experiments_.push_back(std::move(*experiment));
    own_ = experiments_.size();
    connect(&finger_, &StudyFinger::changed, this, &StudySetup::changed);
    connect(&chooser_, &FolderChooser::chosen, this, &StudySetup::take_folder);
    connect(&chooser_, &FolderChooser::cancelled, this, &StudySetup::cancel);
}

// --- which experiment ---

QStringList StudySetup::experiments() const {
    QStringList titles;
    for (const Experiment& experiment : experiments_)
        titles << StudyWords::title(experiment);
    return titles;
}

void StudySetup::choose(int index) {
    if (index < 0 || index >= static_cast<int>(experiments_.size()))
        return;
    chosen_ = static_cast<std::size_t>(index);
    folder_.clear();
    faces_.reset();
    force_allowed_ = false;
    look(true);
    read_faces();
    teller_.tell(QStringList{tr("%1.").arg(StudyWords::title(now())), force()}.join(' ').trimmed());
}

void StudySetup::openFile(const QUrl& file) {
    if (!file.isLocalFile())
        return teller_.problem(tr("Only a file on this computer can be opened."));
    const std::filesystem::path path = path_named(file.toLocalFile().toStdString());
    const auto text = read_whole(path, most_experiment_bytes);
    if (!text)
        return teller_.problem(in_persons_language(text.error()));
    auto experiment = read_experiment(*text);
    if (!experiment)
        return teller_.problem(tr("%1 cannot be used as an experiment. %2")
                                   .arg(text_of(path.filename()), in_persons_language(experiment.error())));
    if (StudyWords::answers(*experiment).size() > most_answers)
        return teller_.problem(tr("The experiment has more than 9 answers, which have no keys."));
    experiments_.resize(own_);
    experiments_.push_back(std::move(*experiment));
    choose(static_cast<int>(own_));
}

// --- where it lies, and whose turn it is ---

std::filesystem::path StudySetup::study_folder() const {
    return folder_.empty() ? settings_.folder / now().name : folder_;
}

QString StudySetup::folder() const { return text_of(study_folder()); }

void StudySetup::look(bool offer_next) {
    known_.reset();
    emit changed();
    if (experiments_.empty())
        return;
    keeping_.look(study_folder(), now(), participant_,
                  [this, offer_next, number = ++looked_](const StudyKeeping::Known& known) {
                      if (number != looked_)
                          return;
                      if (offer_next && known.problem.isEmpty() && known.next_participant != participant_) {
                          participant_ = std::min(known.next_participant, most_participants);
                          return look(false);
                      }
                      known_ = known;
                      emit changed();
                  });
}

void StudySetup::setParticipant(int number) {
    if (number < 1 || number > most_participants)
        return teller_.problem(tr("Participants have numbers from 1 to %1.").arg(most_participants));
    participant_ = number;
    look(false);
    teller_.tell(tr("Participant %1").arg(number));
}

void StudySetup::typeParticipant(const QString& number) {
    setParticipant(QLocale().toInt(number.trimmed())); // 0 where it is none
}

QString StudySetup::progress() const {
    if (!known_ || !known_->problem.isEmpty())
        return {};
    StudyProgress progress;
    progress.participant = participant_;
    progress.trials = now().trials();
    progress.done = static_cast<std::size_t>(std::ranges::count_if(
        known_->records, [](const TrialRecord& record) { return !record.training && !record.repeated; }));
    if (known_->records.empty())
        return tr("Participant %1 is new.").arg(participant_);
    return (StudyWords::so_far(progress) + ' ' + known_->notice).trimmed();
}

QString StudySetup::problem() const {
    if (experiments_.empty())
        return tr("The program's experiments are not there. Open an experiment's file.");
    if (known_ && !known_->problem.isEmpty())
        return known_->problem;
    if (needs_faces() && !faces_)
        return !faces_problem_.isEmpty() ? faces_problem_
               : faces_folder_.empty()
                   ? tr("This experiment needs faces. Choose a folder with photographs named "
                        "after person and expression, such as anna_smiling.jpg.")
                   : tr("The faces are being read.");
    return known_ ? QString() : tr("The study's folder is being read.");
}

// --- folders ---

void StudySetup::begin_choosing(Choosing what) {
    choosing_ = what;
    emit changed();
    chooser_.begin();
}

bool StudySetup::cancel() {
    if (!choosing())
        return false;
    choosing_ = Choosing::nothing;
    emit changed();
    tell_where();
    return true;
}

void StudySetup::take_folder(const QString& folder) {
    const Choosing what = std::exchange(choosing_, Choosing::nothing);
    if (what == Choosing::faces) {
        faces_folder_ = path_named(folder.toStdString());
        read_faces();
    } else if (what == Choosing::study) {
        folder_ = path_named(folder.toStdString());
        look(true);
    }
    emit changed();
    teller_.tell(what == Choosing::faces ? tr("The faces are being read.")
                                         : tr("The study lies in %1.").arg(folder));
}

bool StudySetup::needs_faces() const { return !experiments_.empty() && tp::needs_faces(now()); }

QString StudySetup::faces_words() const {
    return faces_folder_.empty() ? tr("No folder is chosen.") : text_of(faces_folder_);
}

void StudySetup::read_faces() {
    faces_.reset();
    faces_problem_.clear();
    if (!needs_faces() || faces_folder_.empty())
        return reading_.cancel();
    reading_.ask([this, folder = faces_folder_,
                  experiment = now()](const std::stop_token& stop) -> LatestTask::Answer {
        auto read = FolderFaces::read(folder, experiment, stop);
        return [this, read = std::move(read)] {
            if (read)
                faces_ = *read;
            else
                faces_problem_ = in_persons_language(read.error());
            emit changed();
            teller_.add(read ? tr("The faces are ready.") : faces_problem_);
        };
    });
}

// --- what moves the finger ---

QStringList StudySetup::hands() const {
    QStringList hands{tr("Mouse, touch or keys, with a tone")};
    if (const QString device = finger_.found(); !device.isEmpty())
        hands.prepend(device);
    return hands;
}

void StudySetup::chooseHand(int index) {
    const QStringList all = hands();
    if (index < 0 || index >= all.size())
        return;
    wants_device_ = all.size() > 1 && index == 0;
    emit changed();
    teller_.tell(tr("%1.").arg(all[index]));
}

// --- how strong it is ---

std::optional<double> StudySetup::stronger_pull_n() const {
    if (experiments_.empty())
        return std::nullopt;
    const double pull = strongest_pull_n(now());
    return pull > finger_.persons_limit_n() + 1e-9 ? std::optional(pull) : std::nullopt;
}

QString StudySetup::force() const {
    const auto pull = stronger_pull_n();
    if (!pull)
        return {};
    if (force_allowed_)
        return tr("The force may reach %1 newtons, as far as the device gives it, with your consent.")
            .arg(StudyWords::newtons(*pull));
    const double limit = finger_.persons_limit_n();
    return tr("This study asks for up to %1 newtons. The force is cut at %2 newtons, in %3 of %4 conditions, "
              "unless "
              "you consent to more. Key: L.")
        .arg(StudyWords::newtons(*pull), StudyWords::newtons(limit))
        .arg(conditions_cut_at(now(), limit))
        .arg(now().conditions());
}

void StudySetup::setForceAllowed(bool allowed) {
    if (!stronger_pull_n())
        return teller_.tell(tr("This study asks for no more force than the settings allow."));
    force_allowed_ = allowed;
    emit changed();
    teller_.tell(force());
}

void StudySetup::setShowScene(bool on) {
    if (on == show_scene_)
        return;
    show_scene_ = on;
    emit changed();
    teller_.tell(on ? tr("The scene is shown, to try it out. Nothing is kept.")
                    : tr("The scene is not shown."));
}

// --- coming and going ---

void StudySetup::enter() {
    show_scene_ = false;
    look(known_ == std::nullopt);
}

void StudySetup::leave() {
    choosing_ = Choosing::nothing;
    show_scene_ = false;
    force_allowed_ = false;
    emit changed();
}

void StudySetup::tell_where() {
    teller_.tell(tr("Studies. %1. Keys 1 to %2 choose the experiment, S starts it, F1 says more.")
                     .arg(experiments_.empty() ? problem() : StudyWords::title(now()))
                     .arg(experiments_.size()) +
                 (force().isEmpty() ? QString() : ' ' + force()));
}

std::optional<StudyPlan> StudySetup::plan() const {
    if (!problem().isEmpty())
        return std::nullopt;
    StudyPlan plan;
    plan.experiment = now();
    plan.folder = study_folder();
    plan.participant = participant_;
    plan.device = uses_device();
    plan.force_allowed = force_allowed_ && stronger_pull_n().has_value();
    plan.show_scene = show_scene_;
    plan.faces = faces_;
    return plan;
}

} // namespace tp
