// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>

#include <string>

namespace tp {

/// "1 hour 20 minutes", "3 minutes", "1 minute 5 seconds", "12 seconds"; seconds only below ten minutes.
QString duration_words(double seconds);

/// What a label says of a time: ISO 8601 with its offset; empty where the time is not known.
std::string time_text(const QDateTime& time);

} // namespace tp
