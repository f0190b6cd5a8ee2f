// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <string>

namespace tp {

/// What the search for faces says of a picture or a face, in the person's language where it is a sentence without a
/// number or a name in it; others stay as they are.
QString problem_words(const std::string& problem);

/// Whether there is something for a translator to translate it from.
bool is_translatable(const QString& sentence);

} // namespace tp
