// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace tp {

/// `devices calibrate`: where a device lies on the screen. Its words; the exit status.
int calibrate_device(const QStringList& words);
/// `devices measure`: how strong a force stick is, and which way it pulls.
int measure_joystick(const QStringList& words);

} // namespace tp
