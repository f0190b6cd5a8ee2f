// SPDX-License-Identifier: Apache-2.0
#include "app/explore/problem_words.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace tp {

namespace {

/// The sentences of the room faces, word for word.
constexpr std::array problem_sources{
    QT_TRANSLATE_NOOP("tp::Problems", "No face was found in this picture."),
    QT_TRANSLATE_NOOP("tp::Problems", "The picture is empty."),
    QT_TRANSLATE_NOOP("tp::Problems", "The picture is not in 8-bit colour."),
    QT_TRANSLATE_NOOP("tp::Problems", "The search for faces was stopped."),
    QT_TRANSLATE_NOOP("tp::Problems", "The face is cut off at the left edge of the picture."),
    QT_TRANSLATE_NOOP("tp::Problems", "The face is cut off at the right edge of the picture."),
    QT_TRANSLATE_NOOP("tp::Problems", "The face is cut off at the top edge of the picture."),
    QT_TRANSLATE_NOOP("tp::Problems", "The face is cut off at the bottom edge of the picture."),
    QT_TRANSLATE_NOOP("tp::Problems", "The right eye may be covered, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The left eye may be covered, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The mouth may be covered, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The outline may be covered, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The edge of the right eye is faint, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The edge of the left eye is faint, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The edge of the mouth is faint, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems", "The edge of the outline is faint, so its contour may be wrong."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "This picture could not be worked on. It may be too large for this computer."),
};

} // namespace

QString problem_words(const std::string& problem) {
    return problem.empty() ? QString() : QCoreApplication::translate("tp::Problems", problem.c_str());
}

bool is_translatable(const QString& sentence) {
    return std::ranges::any_of(problem_sources,
                               [&](const char* source) { return sentence == QString::fromUtf8(source); });
}

} // namespace tp
