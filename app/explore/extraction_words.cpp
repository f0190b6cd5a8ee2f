// SPDX-License-Identifier: Apache-2.0
#include "app/explore/extraction_words.hpp"

#include <QStringList>

#include <algorithm>
#include <string_view>

namespace tp {

namespace {

bool any_has(const Extraction& extraction, std::string_view name) {
    return std::any_of(extraction.faces.begin(), extraction.faces.end(), [&](const Face& face) {
        return std::any_of(face.contours.begin(), face.contours.end(),
                           [&](const Contour& contour) { return contour.name == name; });
    });
}

QString in_words(std::size_t count) {
    static const QStringList words{"No",    "One",   "Two",  "Three", "Four",   "Five",  "Six",
                                   "Seven", "Eight", "Nine", "Ten",   "Eleven", "Twelve"};
    return count < static_cast<std::size_t>(words.size()) ? words[static_cast<qsizetype>(count)]
                                                          : QString::number(count);
}

QString listed(QStringList items) {
    if (items.size() < 2)
        return items.join("");
    const QString last = items.takeLast();
    return items.join(", ") + " and " + last;
}

} // namespace

QString describe(const Extraction& extraction) {
    if (extraction.faces.empty())
        return extraction.problem.empty() ? QString("No face was found in this picture.")
                                          : QString::fromStdString(extraction.problem);
    QStringList can_be_felt;
    if (any_has(extraction, feature::left_eye) || any_has(extraction, feature::right_eye))
        can_be_felt << "eyes";
    if (any_has(extraction, feature::outer_lip) || any_has(extraction, feature::inner_lip))
        can_be_felt << "mouth";
    if (any_has(extraction, feature::outline))
        can_be_felt << "outline";
    if (any_has(extraction, feature::left_brow) || any_has(extraction, feature::right_brow))
        can_be_felt << "brows";
    if (any_has(extraction, feature::nose))
        can_be_felt << "nose";
    if (any_has(extraction, feature::left_iris) || any_has(extraction, feature::right_iris))
        can_be_felt << "irises";

    const std::size_t count = extraction.faces.size();
    QStringList sentences{in_words(count) + (count == 1 ? " face." : " faces.")};
    if (!can_be_felt.isEmpty()) {
        QString list = listed(can_be_felt);
        list[0] = list[0].toUpper();
        sentences << list + (count == 1 ? " can be felt." : " of each can be felt.");
    }
    if (!extraction.problem.empty())
        sentences << QString::fromStdString(extraction.problem);
    if (count == 1 && !extraction.faces.front().problem.empty())
        sentences << QString::fromStdString(extraction.faces.front().problem);
    return sentences.join(" ");
}

} // namespace tp
