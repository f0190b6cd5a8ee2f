// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_history.hpp"

#include <utility>

namespace tp {

MendHistory::MendHistory(MendedPhoto& photo, const MendSelection& selection, Narrator& narrator)
    : photo_(photo), narrator_(narrator) {
    connect(&photo, &MendedPhoto::replaced, this, [this] {
        steps_.clear();
        undone_.clear();
        run_.clear();
        emit changed();
    });
    connect(&selection, &MendSelection::leavingPoint, this, &MendHistory::end_run);
}

void MendHistory::step(const QString& what, const std::function<void(MendWork&)>& change,
                       const QString& run) {
    undone_.clear();
    if (run.isEmpty() || run != run_) {
        run_ = run;
        steps_.push_back({what, photo_.work()});
        if (steps_.size() > most_steps)
            steps_.pop_front();
    }
    photo_.change(change);
    emit changed();
}

void MendHistory::replace(const QString& what, const MendWork& work) {
    emit turning();
    step(what, [&work](MendWork& now) { now = work; });
}

/// The newest step of `from` is done backwards, and can be done again from `to`. Its words; empty where there
/// is none.
QString MendHistory::turn(std::deque<Step>& from, std::deque<Step>& to) {
    run_.clear();
    if (from.empty())
        return {};
    Step step = std::move(from.back());
    from.pop_back();
    photo_.change([&step](MendWork& work) { std::swap(step.work, work); });
    const QString what = step.what;
    to.push_back(std::move(step));
    emit changed();
    return what;
}

void MendHistory::undo() {
    emit turning();
    const QString what = turn(steps_, undone_);
    narrator_.tell(what.isEmpty() ? tr("There is nothing to undo.") : tr("Undone: %1.").arg(what),
                   Priority::touch);
}

void MendHistory::redo() {
    emit turning();
    const QString what = turn(undone_, steps_);
    narrator_.tell(what.isEmpty() ? tr("There is nothing to redo.") : tr("Redone: %1.").arg(what),
                   Priority::touch);
}

void MendHistory::forget_newest() {
    turn(steps_, undone_);
    undone_.clear();
    emit changed();
}

} // namespace tp
