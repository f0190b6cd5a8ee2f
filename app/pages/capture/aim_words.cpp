// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/aim_words.hpp"

#include <QLocale>

#include <algorithm>
#include <cstddef>

namespace tp {

namespace {

constexpr std::size_t most_names = 3; ///< while the hand waits

QString by_step(AimStep step, const QString& little, const QString& some, const QString& much) {
    return step == AimStep::little ? little : step == AimStep::some ? some : much;
}

QString begun_large(QString words) {
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

} // namespace

QString AimWords::instruction(const AimInstruction& instruction, bool whole) {
    const AimStep step = instruction.step;
    QString way;
    switch (instruction.advice) {
    case Advice::look_left:
        return tr("Nobody is in view. Turn slowly to the left.");
    case Advice::look_right:
        return tr("Nobody is in view. Turn slowly to the right.");
    case Advice::look_up:
        return tr("Nobody is in view. Tilt slowly up.");
    case Advice::look_down:
        return tr("Nobody is in view. Tilt slowly down.");
    case Advice::move_left:
        way = by_step(step, tr("a little left"), tr("left"), tr("far left"));
        break;
    case Advice::move_right:
        way = by_step(step, tr("a little right"), tr("right"), tr("far right"));
        break;
    case Advice::move_up:
        way = by_step(step, tr("a little up"), tr("up"), tr("far up"));
        break;
    case Advice::move_down:
        way = by_step(step, tr("a little down"), tr("down"), tr("far down"));
        break;
    case Advice::closer:
        way = by_step(step, tr("a little closer"), tr("closer"), tr("much closer"));
        break;
    case Advice::farther:
        way = by_step(step, tr("a little back"), tr("back"), tr("far back"));
        break;
    case Advice::turn_clockwise:
        way = by_step(step, tr("a little clockwise"), tr("clockwise"), tr("far clockwise"));
        break;
    case Advice::turn_anticlockwise:
        way = by_step(step, tr("a little anticlockwise"), tr("anticlockwise"), tr("far anticlockwise"));
        break;
    case Advice::more_light:
        return tr("Too dark. More light on the face.");
    case Advice::light_behind_them:
        return tr("The light is behind them.");
    case Advice::keep_still:
        return tr("Keep still.");
    case Advice::eyes_shut:
        return tr("Eyes are shut.");
    case Advice::ready:
        return tr("Good. Hold still.");
    }
    return whole ? tr("Move the tablet: %1.").arg(way) : tr("%1.").arg(begun_large(way));
}

QString AimWords::another() { return tr("All is well. Press Space to take another photograph."); }

QString AimWords::people(const AimInstruction& instruction) {
    if (instruction.faces == 0)
        return {};
    if (instruction.names.empty())
        return tr("%n face(s).", nullptr, instruction.faces);
    QStringList who;
    for (std::size_t i = 0; i < std::min(instruction.names.size(), most_names); ++i)
        who << QString::fromStdString(instruction.names[i]);
    if (const int others = instruction.faces - static_cast<int>(who.size()); others > 0)
        who << tr("%n more face(s)", "at the end of a list of names", others);
    return tr("%1.").arg(QLocale().createSeparatedList(who));
}

QString AimWords::cut(AimEdge edge) {
    switch (edge) {
    case AimEdge::left:
        return tr("Cut off at the left edge.");
    case AimEdge::right:
        return tr("Cut off at the right edge.");
    case AimEdge::top:
        return tr("Cut off at the upper edge.");
    case AimEdge::bottom:
        return tr("Cut off at the lower edge.");
    case AimEdge::none:
        break;
    }
    return {};
}

QStringList AimWords::aims() {
    return {tr("One face in the middle"), tr("One face by thirds"), tr("Head and shoulders"),
            tr("Everybody in view")};
}

} // namespace tp
