// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command_line.hpp"
#include "app/cli/stop_signal.hpp"

#include <QString>

#include <filesystem>
#include <span>
#include <stop_token>
#include <string>

namespace tp {

/// A path as the shell gave it, absolute and without dots.
std::filesystem::path path_given(const QString& word);

/// A verb that other verbs follow.
struct SubVerb {
    const char* name;
    const char* about;
    int (*run)(const QStringList& words);
};
/// Runs the one that the words begin with, or shows the list.
int run_sub_verb(const char* verb, std::span<const SubVerb> verbs, const QStringList& words);

/// Asks for a stop as soon as the signal came; to be called now and then.
class StopOnSignal {
public:
    void look() {
        if (signal_.asked())
            source_.request_stop();
    }
    std::stop_token token() const { return source_.get_token(); }
    int exit_code() const { return signal_.exit_code(); }

private:
    StopSignal signal_;
    std::stop_source source_;
};

} // namespace tp
