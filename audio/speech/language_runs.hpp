// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/spoken_names.hpp"

#include <QString>

#include <vector>

namespace tp {

/// A part of a text that one voice can read.
struct LanguageRun {
    QString text;
    QString language; ///< BCP 47
};

/// The parts of `text`, a sentence in `language` with the names that people have given. Together they are the text.
///
/// One of `names` that stands there as a whole word is a part of its own language, where that is another one than the
/// sentence's; of several that begin at one place the longest. Letter case counts. A word ends where no letter, digit or
/// accent follows, or a letter of another script, as of Korean behind Anna; an apostrophe between letters does not end it.
///
/// What is left: a name in another script, such as Иван in a German sentence, keeps a language of its own, since a voice
/// spells the letters that it does not know. Letters that every voice reads (Latin) stay in the sentence. Spaces and marks
/// after a name stay with it.
///
/// A script tells its commonest language (Unicode Standard, annex 24, for the scripts): Ukrainian, Persian and Chinese are
/// told from Russian, Arabic and Japanese by letters that the others lack.
std::vector<LanguageRun> language_runs(const QString& text, const QString& language,
                                       const SpokenNames& names = {});

} // namespace tp
