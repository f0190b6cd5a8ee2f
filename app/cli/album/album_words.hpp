// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command_line.hpp"

#include <QString>

#include <filesystem>
#include <span>

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

} // namespace tp
