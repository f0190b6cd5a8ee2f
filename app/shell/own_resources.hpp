// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QQmlEngine>

namespace tp {

/// From then on pages fetch the program's own resources, pictures that the program holds or spells out, and the QML of
/// Qt's own modules. Everything else is refused, whoever asks for it: another machine, and pictures among the files of
/// this one. For an engine that has loaded nothing yet.
void keep_to_own_resources(QQmlEngine& engine);

} // namespace tp
