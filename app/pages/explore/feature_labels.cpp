// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/feature_labels.hpp"

#include "app/photo/scene/feature_words.hpp"

#include <QCoreApplication>

#include <array>
#include <string>

namespace tp {

namespace {

constexpr std::array feature_sources{
    QT_TRANSLATE_NOOP("tp::FeatureLabels", "left eye"),      QT_TRANSLATE_NOOP("tp::FeatureLabels", "right eye"),
    QT_TRANSLATE_NOOP("tp::FeatureLabels", "lips"),          QT_TRANSLATE_NOOP("tp::FeatureLabels", "mouth opening"),
    QT_TRANSLATE_NOOP("tp::FeatureLabels", "face outline"),  QT_TRANSLATE_NOOP("tp::FeatureLabels", "left brow"),
    QT_TRANSLATE_NOOP("tp::FeatureLabels", "right brow"),    QT_TRANSLATE_NOOP("tp::FeatureLabels", "nose"),
    QT_TRANSLATE_NOOP("tp::FeatureLabels", "left iris"),     QT_TRANSLATE_NOOP("tp::FeatureLabels", "right iris"),
};

} // namespace

std::span<const char* const> translatable_features() { return feature_sources; }

QString feature_word(std::string_view contour_name) {
    return QCoreApplication::translate("tp::FeatureLabels", spoken_feature(contour_name).c_str());
}

QString feature_label(std::string_view contour_name, const QString& person, int number) {
    const QString word = feature_word(contour_name);
    if (!person.isEmpty())
        return QCoreApplication::translate("tp::FeatureLabels", "%1 of %2", "left eye of Anna").arg(word, person);
    if (number > 0)
        return QCoreApplication::translate("tp::FeatureLabels", "%1 of face %2", "left eye of face 2")
            .arg(word)
            .arg(number);
    return word;
}

QString at_the_start(QString words) {
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

} // namespace tp
