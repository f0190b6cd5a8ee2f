// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/words/photo_view.hpp"

#include <QLocale>
#include <QString>

namespace tp {

enum class DescriptionOrder { people_first, place_first };

/// A language's way to say what is on a photograph: by its grammar, not by texts with gaps. Without full stops and
/// beginning small, where the language does so; empty where there is nothing to say.
class DescriptionGrammar {
public:
    DescriptionGrammar() = default;
    DescriptionGrammar(const DescriptionGrammar&) = delete;
    DescriptionGrammar& operator=(const DescriptionGrammar&) = delete;
    virtual ~DescriptionGrammar() = default;

    /// "Anna and two more people, all smiling"
    virtual QString people_in_short(const PhotoView& view) const = 0;
    /// "three people: Anna at the left, smiling; one in the middle; one at the right, cut off by the edge"
    virtual QString people(const PhotoView& view) const = 0;
    /// "taken: Anna in the middle, smiling, eyes open": what a person who did not see it wants to know at once
    virtual QString taken(const PhotoView& view) const = 0;
    /// "blurred, a little dark": what could be done better the next time
    virtual QString faults(const PhotoView& view) const = 0;
    /// "an upright picture, head and shoulders, black and white"
    virtual QString picture(const PhotoView& view) const = 0;
    /// "May 2019"
    virtual QString month(const PhotoView& view) const = 0;
    /// "a Sunday evening in May 2019"
    virtual QString when(const PhotoView& view) const = 0;
    /// "in Vienna", "near Vienna", "about 60 km from Vienna"
    virtual QString where(const PhotoView& view) const = 0;
};

/// English where the language has no grammar here.
const DescriptionGrammar& grammar_of(QLocale::Language language);

/// "Anna and two more people, all smiling, May 2019, Vienna": no full stop. Empty where nothing is known.
QString short_description(const PhotoView& view, QLocale::Language language,
                          DescriptionOrder order = DescriptionOrder::people_first);
/// Whole sentences. Empty where nothing is known.
QString full_description(const PhotoView& view, QLocale::Language language,
                         DescriptionOrder order = DescriptionOrder::people_first);

/// What was taken just now, in whole sentences: "Taken: Anna in the middle, smiling, eyes open. A little dark."
QString taken_words(const PhotoView& view, QLocale::Language language);

} // namespace tp
