// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/extraction_words.hpp"

#include "app/pages/explore/feature_labels.hpp"
#include "audio/sentences/sentences.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <string>
#include <string_view>

namespace tp {

namespace {

struct ExtractionWords {
    Q_DECLARE_TR_FUNCTIONS(tp::ExtractionWords)
};

bool any_has(const Extraction& extraction, std::string_view name) {
    return std::any_of(extraction.faces.begin(), extraction.faces.end(), [&](const Face& face) {
        return std::any_of(face.contours.begin(), face.contours.end(),
                           [&](const Contour& contour) { return contour.name == name; });
    });
}

QString faces_in_words(std::size_t count) {
    switch (count) {
    case 1:
        return ExtractionWords::tr("One face.");
    case 2:
        return ExtractionWords::tr("Two faces.");
    case 3:
        return ExtractionWords::tr("Three faces.");
    case 4:
        return ExtractionWords::tr("Four faces.");
    default:
        return ExtractionWords::tr("%n face(s).", nullptr, static_cast<int>(count));
    }
}

} // namespace

QString listed(QStringList items) {
    if (items.size() < 2)
        return items.join("");
    const QString last = items.takeLast();
    return ExtractionWords::tr("%1 and %2", "the end of a list").arg(items.join(ExtractionWords::tr(", ")), last);
}

QString describe(const Extraction& extraction, const std::vector<QString>& names) {
    if (extraction.faces.empty())
        return in_persons_language(extraction.problem.empty() ? std::string("No face was found in this picture.") : extraction.problem);
    QStringList can_be_felt;
    if (any_has(extraction, feature::left_eye) || any_has(extraction, feature::right_eye))
        can_be_felt << ExtractionWords::tr("eyes");
    if (any_has(extraction, feature::outer_lip) || any_has(extraction, feature::inner_lip))
        can_be_felt << ExtractionWords::tr("mouth");
    if (any_has(extraction, feature::outline))
        can_be_felt << ExtractionWords::tr("outline");
    if (any_has(extraction, feature::left_brow) || any_has(extraction, feature::right_brow))
        can_be_felt << ExtractionWords::tr("brows");
    if (any_has(extraction, feature::nose))
        can_be_felt << ExtractionWords::tr("nose");
    if (any_has(extraction, feature::left_iris) || any_has(extraction, feature::right_iris))
        can_be_felt << ExtractionWords::tr("irises");

    const std::size_t count = extraction.faces.size();
    QStringList people(names.begin(), names.end());
    people.removeAll(QString());
    QStringList sentences;
    if (!people.isEmpty())
        sentences << ExtractionWords::tr("%1.", "who is on the picture").arg(listed(people));
    sentences << faces_in_words(count);
    if (!can_be_felt.isEmpty()) {
        const QString list = at_the_start(listed(can_be_felt));
        sentences << (count == 1 ? ExtractionWords::tr("%1 can be felt.").arg(list)
                                 : ExtractionWords::tr("%1 of each can be felt.").arg(list));
    }
    if (!extraction.problem.empty())
        sentences << in_persons_language(extraction.problem);
    if (count == 1 && !extraction.faces.front().problem.empty() &&
        extraction.faces.front().problem != extraction.problem)
        sentences << in_persons_language(extraction.faces.front().problem);
    return sentences.join(" ");
}

} // namespace tp
