// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/advice.hpp"
#include "core/aiming/aim.hpp"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace tp {

/// What is said while one aims.
class AimWords {
    Q_DECLARE_TR_FUNCTIONS(AimWords)
public:
    /// "A little left." Of few words, because the hand waits for it. `whole`: "Move the tablet: a little left." for whoever
    /// hears it for the first time.
    static QString instruction(const AimInstruction& instruction, bool whole);
    /// Instead of that all is well, where that was so when the last photograph was taken.
    static QString another();
    /// It says where the hand is to go.
    static bool is_way(Advice advice) {
        return advice >= Advice::move_left && advice <= Advice::turn_anticlockwise;
    }
    /// "Anna.", "Anna and Ben.", "Anna and 1 more face.", "2 faces."; empty where nobody is seen.
    static QString people(const AimInstruction& instruction);
    /// Where a face reaches over the edge: "Cut off at the left edge."; empty where none does.
    static QString cut(AimEdge edge);
    /// All aims, in their order: "One face in the middle", …
    static QStringList aims();
};

} // namespace tp
