// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/touch/touch_output.hpp"
#include "device/touch_output/drawn/drawn_touch.hpp"
#include "device/touch_output/touch_registry.hpp"

#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// How pages come to outputs for a bare finger. One without a list has none; a test brings outputs of its own. Both functions
/// are called on a thread that may wait.
struct TouchAccess {
    std::function<std::vector<ListedTouchOutput>()> list;
    std::function<Result<std::unique_ptr<TouchOutput>>(const std::string& name)> make;
    int look_every_ms = 2000; ///< how soon one that is plugged in is found where nothing tells of it
    /// Calls on any thread when something was plugged in or out, for as long as what it returns lives; empty: nothing tells.
    std::function<std::shared_ptr<void>(std::function<void()> changed)> on_plug = {};

    /// Those of this computer, as app/parts/feedbackd/touch_outputs.hpp has them, and last the drawn one, on a surface of that
    /// size (mm), whose ticks `listener` is told of.
    static TouchAccess of_this_computer(double width_mm, double height_mm,
                                        const std::shared_ptr<TickListener>& listener);
    /// The same and, before them, a motor that is a file (device/touch_output/force_feedback/motor_file.hpp).
    TouchAccess with_motor_file(const std::filesystem::path& file) const;
};

/// What a person who starts the program calls an output that is to be there too: the file of "simulated:FILE"; none of anything
/// else.
std::optional<std::filesystem::path> motor_file_named(const std::string& wish);

/// The drawn output's name.
inline constexpr const char* drawn_touch_name = "drawn";

/// What the choice of an output is remembered by: its serial number, or its name where it has none.
QString key_of(const ListedTouchOutput& output);

/// The one of these that serves a person who chose `key`: that one; where it is not there or nothing was chosen, the first.
/// Null for none.
const ListedTouchOutput* touch_for(const std::vector<ListedTouchOutput>& there, const QString& key);

} // namespace tp
