// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/undo_history.hpp"

#include <utility>

namespace tp {

void UndoHistory::done(Step step) {
    undone_.clear();
    steps_.push_back(std::move(step));
    if (steps_.size() > most_steps)
        steps_.pop_front();
}

void UndoHistory::join(std::string what) {
    Step second = std::move(steps_.back());
    steps_.pop_back();
    Step first = std::move(steps_.back());
    const auto both = [](const Action& one, const Action& one_back, const Action& other) -> Action {
        return [one, one_back, other] {
            if (std::string problem = one(); !problem.empty())
                return problem;
            std::string problem = other();
            if (!problem.empty())
                one_back();
            return problem;
        };
    };
    steps_.back() = {std::move(what), both(second.undo, second.redo, first.undo),
                     both(first.redo, first.undo, second.redo)};
}

std::string UndoHistory::undo() {
    if (steps_.empty())
        return "There is nothing to undo.";
    if (std::string problem = steps_.back().undo(); !problem.empty())
        return problem;
    undone_.push_back(std::move(steps_.back()));
    steps_.pop_back();
    return {};
}

std::string UndoHistory::redo() {
    if (undone_.empty())
        return "There is nothing to redo.";
    if (std::string problem = undone_.back().redo(); !problem.empty())
        return problem;
    steps_.push_back(std::move(undone_.back()));
    undone_.pop_back();
    return {};
}

} // namespace tp
