// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_words.hpp"

#include <QLocale>

#include <algorithm>
#include <string>

namespace tp {

namespace {

/// The titles of resources/studies, for translators.
[[maybe_unused]] constexpr const char* titles[]{
    QT_TRANSLATE_NOOP("StudyWords", "Following contours, by stiffness and range"),
    QT_TRANSLATE_NOOP("StudyWords", "Naming shapes of three sizes"),
    QT_TRANSLATE_NOOP("StudyWords", "Naming the expressions of faces"),
    QT_TRANSLATE_NOOP("StudyWords", "Following contours by the exact and the published law"),
    QT_TRANSLATE_NOOP("StudyWords", "Naming expressions by the exact and the published law")};

const StudyFactor* asked_for(const Experiment& experiment) {
    const auto found = std::ranges::find_if(
        experiment.factors, [&](const StudyFactor& factor) { return factor.parameter == experiment.answer; });
    return found == experiment.factors.end() ? nullptr : &*found;
}

} // namespace

QString StudyWords::title(const Experiment& experiment) {
    const std::string& title = experiment.title.empty() ? experiment.name : experiment.title;
    return tr(title.c_str()); // a title that no catalogue has stays as it is
}

QString StudyWords::task(const Experiment& experiment) {
    if (experiment.task == StudyTask::follow)
        return tr(
            "Follow a line with your finger from its start to its end, as exactly and as fast as you can; a "
            "closed line once round. The trial ends by itself at the end of the line. If you think that you "
            "are there and nothing happens, press Space.");
    if (experiment.answer == StudyParameter::expression)
        return tr(
            "Feel a face until you know how it looks. Then press Space, and the number of your answer.");
    return tr("Feel a shape until you know which it is. Then press Space, and the number of your answer.");
}

QString StudyWords::so_far(const StudyProgress& progress) {
    const QString who = tr("Participant %1").arg(progress.participant);
    if (progress.done >= progress.trials)
        return tr("%1 has done all %2 trials.").arg(who).arg(progress.trials);
    return tr("%1 has done %2 of %3 trials.").arg(who).arg(progress.done).arg(progress.trials);
}

QString StudyWords::trial(const StudyProgress& progress) {
    if (progress.training > 0)
        return tr("Training %1 of %2").arg(progress.training).arg(progress.trainings);
    return tr("Trial %1 of %2").arg(std::min(progress.done + 1, progress.trials)).arg(progress.trials);
}

QString StudyWords::ready(const Experiment& experiment, const StudyProgress& progress, bool asks) {
    const QString which = progress.again ? tr("%1, once more").arg(trial(progress)) : trial(progress);
    QString what = tr("Feel the shape.");
    if (experiment.task == StudyTask::follow)
        what = tr("Follow the line.");
    else if (!asks)
        what = tr("Feel the line; nothing is asked.");
    else if (experiment.answer == StudyParameter::expression)
        what = tr("Feel the face.");
    return tr("%1. %2 Press Space to start.").arg(which, what);
}

QStringList StudyWords::answers(const Experiment& experiment) {
    QStringList words;
    const StudyFactor* const asked = asked_for(experiment);
    if (asked == nullptr)
        return words;
    for (std::size_t level = 0; level < asked->levels.size(); ++level) {
        const std::string& value = asked->levels[level];
        const QString known = value == "circle"      ? tr("circle")
                              : value == "triangle"  ? tr("triangle")
                              : value == "square"    ? tr("square")
                              : value == "pentagon"  ? tr("pentagon")
                              : value == "hexagon"   ? tr("hexagon")
                              : value == "curve"     ? tr("curve")
                              : value == "smiling"   ? tr("smiling")
                              : value == "surprised" ? tr("surprised")
                              : value == "sad"       ? tr("sad")
                              : value == "angry"     ? tr("angry")
                                                     : QString();
        words << (known.isEmpty() ? QString::fromStdString(level_words(*asked, level)) : known);
    }
    return words;
}

QString StudyWords::question(const Experiment& experiment, bool out_of_time) {
    QStringList keys;
    for (const QString& answer : answers(experiment))
        keys << tr("%1: %2.").arg(keys.size() + 1).arg(answer);
    const QString asked =
        experiment.answer == StudyParameter::expression ? tr("How did the face look?") : tr("Which was it?");
    const QString question = asked + ' ' + keys.join(' ');
    return out_of_time ? tr("The time is over. %1").arg(question) : question;
}

QString StudyWords::summary(const StudySummary& summary) {
    QStringList words{tr("Participants: %1.").arg(summary.participants),
                      tr("Trials that count: %1.").arg(summary.trials),
                      tr("Trials done again: %1.").arg(summary.repeated)};
    const QLocale locale;
    if (summary.error_mm)
        words << tr("Mean tracking error: %1 millimetres.").arg(locale.toString(*summary.error_mm, 'f', 1));
    if (summary.right)
        words << tr("Named rightly: %1 percent.").arg(locale.toString(100.0 * *summary.right, 'f', 0));
    if (summary.time_s)
        words << tr("Mean time: %1 seconds.").arg(locale.toString(*summary.time_s, 'f', 1));
    return words.join(' ');
}

QString StudyWords::newtons(double force_n) { return QLocale().toString(force_n, 'f', 1); }

QString StudyWords::cut(double limit_n, double pull_n) {
    return tr("The pull is cut at %1 newtons; the study asks for %2.").arg(newtons(limit_n), newtons(pull_n));
}

QString StudyWords::consent(const Experiment& experiment, int participant, std::optional<double> raised_n) {
    const QString force =
        raised_n ? tr("The force may be stronger than this program usually allows, up to %1 newtons.")
                           .arg(newtons(*raised_n)) +
                       ' '
                 : QString();
    return force +
           tr("You are asked to take part in a study: %1. It has %3 trials. What is kept is the way of your "
              "finger, "
              "the force on it, times and answers, on this computer only, under the number %2 and without "
              "your name. "
              "You may pause at any time with P and stop with Escape, without giving a reason; the force is "
              "then off "
              "at once. Nothing has been kept so far. If you agree, press Enter. If you do not, press "
              "Escape.")
               .arg(title(experiment))
               .arg(participant)
               .arg(experiment.trials());
}

} // namespace tp
