// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_history.hpp"

#include <utility>

namespace tp {

void MendHistory::before(const MendWork& work, const QString& what, const QString& run) {
    undone_.clear();
    if (runs(run))
        return;
    run_ = run;
    steps_.push_back({what, work});
    if (steps_.size() > most_steps)
        steps_.pop_front();
}

void MendHistory::clear() {
    steps_.clear();
    undone_.clear();
    run_.clear();
}

QString MendHistory::undo(MendWork& work) {
    run_.clear();
    if (steps_.empty())
        return {};
    Step step = std::move(steps_.back());
    steps_.pop_back();
    std::swap(step.work, work);
    undone_.push_back(step);
    return step.what;
}

void MendHistory::take_back(MendWork& work) {
    undo(work);
    undone_.clear();
}

QString MendHistory::redo(MendWork& work) {
    run_.clear();
    if (undone_.empty())
        return {};
    Step step = std::move(undone_.back());
    undone_.pop_back();
    std::swap(step.work, work);
    steps_.push_back(step);
    return step.what;
}

} // namespace tp
