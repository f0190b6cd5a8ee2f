// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/sound_words.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

QString in_language(const char* source) { return QCoreApplication::translate("Duration", source); }

QString hour_words(long long count) {
    return count == 1 ? in_language(QT_TRANSLATE_NOOP("Duration", "1 hour"))
                      : in_language(QT_TRANSLATE_NOOP("Duration", "%1 hours")).arg(count);
}

QString minute_words(long long count) {
    return count == 1 ? in_language(QT_TRANSLATE_NOOP("Duration", "1 minute"))
                      : in_language(QT_TRANSLATE_NOOP("Duration", "%1 minutes")).arg(count);
}

QString second_words(long long count) {
    return count == 1 ? in_language(QT_TRANSLATE_NOOP("Duration", "1 second"))
                      : in_language(QT_TRANSLATE_NOOP("Duration", "%1 seconds")).arg(count);
}

} // namespace

QString duration_words(double seconds) {
    const long long exact = std::llround(std::max(seconds, 0.0));
    const long long whole = exact < 600 ? exact : (exact + 30) / 60 * 60;
    QStringList parts;
    if (whole >= 3600)
        parts << hour_words(whole / 3600);
    if (whole / 60 % 60 > 0)
        parts << minute_words(whole / 60 % 60);
    if (whole % 60 > 0 || parts.isEmpty())
        parts << second_words(whole % 60);
    return parts.join(' ');
}

std::string time_text(const QDateTime& time) {
    return time.isValid() ? time.toOffsetFromUtc(time.offsetFromUtc()).toString(Qt::ISODate).toStdString()
                          : std::string();
}

} // namespace tp
