// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command_line.hpp"

#include <QString>

#include <span>

namespace tp {

/// A verb that other verbs follow.
struct SubVerb {
    const char* name;
    const char* about;
    int (*run)(const QStringList& words);
};
/// Runs the one that the words begin with, or shows the list.
int run_sub_verb(const char* verb, std::span<const SubVerb> verbs, const QStringList& words);

} // namespace tp
