// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <vector>

namespace tp {

/// A part of a text that one voice can read.
struct LanguageRun {
    QString text;
    QString language; ///< BCP 47
};

/// The parts of `text`, a sentence in `language` with the names that people have given: a name in another script, such as
/// Иван in a German sentence, keeps a language of its own, since a voice spells the letters that it does not know. Letters
/// that every voice reads (Latin) stay in the sentence, and so do spaces and marks after a name. Together they are the text.
///
/// A script tells its commonest language (Unicode Standard, annex 24, for the scripts): Ukrainian, Persian and Chinese are
/// told from Russian, Arabic and Japanese by letters that the others lack.
std::vector<LanguageRun> language_runs(const QString& text, const QString& language);

} // namespace tp
