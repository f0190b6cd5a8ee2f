// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/sound_words.hpp"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

QString counted(long long count, const char* unit) {
    return QString("%1 %2%3").arg(count).arg(unit, count == 1 ? "" : "s");
}

} // namespace

QString duration_words(double seconds) {
    const long long exact = std::llround(std::max(seconds, 0.0));
    const long long whole = exact < 600 ? exact : (exact + 30) / 60 * 60;
    QStringList words;
    if (whole >= 3600)
        words << counted(whole / 3600, "hour");
    if (whole / 60 % 60 > 0)
        words << counted(whole / 60 % 60, "minute");
    if (whole % 60 > 0 || words.isEmpty())
        words << counted(whole % 60, "second");
    return words.join(' ');
}

} // namespace tp
