// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_work.hpp"

#include <QString>

#include <cstddef>
#include <deque>

namespace tp {

/// What a person did to the contours and can take back: whole states, so that one that comes back is what it
/// was to the last bit. A step that goes on with the one before (`run`, such as keys that move one point) is
/// taken back with it.
class MendHistory {
public:
    static constexpr std::size_t most_steps = 200;

    /// Remembers the state before a step. `what`: in words that follow "Undone:"; `run` empty: a step of its
    /// own.
    void before(const MendWork& work, const QString& what, const QString& run = {});
    /// Whether the state before a step of that run is remembered already.
    bool runs(const QString& run) const { return !run.isEmpty() && run == run_; }
    /// The next step is one of its own.
    void end_run() { run_.clear(); }
    void clear();

    /// Puts `work` one step back or forth; the step's words, empty where there is none.
    QString undo(MendWork& work);
    QString redo(MendWork& work);
    /// Puts `work` back to before the newest step, as if that had never been done.
    void take_back(MendWork& work);
    bool can_undo() const { return !steps_.empty(); }
    bool can_redo() const { return !undone_.empty(); }

private:
    struct Step {
        QString what;
        MendWork work;
    };
    std::deque<Step> steps_, undone_;
    QString run_;
};

} // namespace tp
