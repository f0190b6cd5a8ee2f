// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>

namespace tp {

/// What a person did and can take back, newest first. Knows nothing of what the steps do.
class UndoHistory {
public:
    /// Empty when done; else the sentence that says why not, and everything is as it was.
    using Action = std::function<std::string()>;
    struct Step {
        std::string what; ///< in words that follow "Undone:", such as "the memo of Anna was deleted"
        Action undo;
        Action redo;
    };
    static constexpr std::size_t most_steps = 200;

    /// Remembers a step that was just done; what had been undone can no longer be done again.
    void done(Step step);
    /// From now on the newest two steps are one, called `what`. To be called where there are two.
    void join(std::string what);
    /// Takes the newest step back, or does the last undone one again. Empty when done; else the sentence that
    /// says why not, and the step stays where it was.
    std::string undo();
    std::string redo();

    /// What the next undo() or redo() is about; empty where there is none.
    std::string next_undo() const { return steps_.empty() ? std::string{} : steps_.back().what; }
    std::string next_redo() const { return undone_.empty() ? std::string{} : undone_.back().what; }
    std::size_t steps() const { return steps_.size(); }

private:
    std::deque<Step> steps_;
    std::deque<Step> undone_;
};

} // namespace tp
