// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <span>
#include <string_view>

namespace tp {

/// A contour's name (as in `feature`) in the person's language: "left eye", "lips".
QString feature_word(std::string_view contour_name);

/// With its owner: "left eye of Anna", "left eye of face 2"; without one the word alone. `number` counts from 1; 0
/// where there is nothing to tell apart.
QString feature_label(std::string_view contour_name, const QString& person, int number);

/// The same words at the beginning of a sentence.
QString at_the_start(QString words);

/// What feature_word translates: every word that app/photo/scene has for a contour of ours.
std::span<const char* const> translatable_features();

} // namespace tp
