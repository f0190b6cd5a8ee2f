// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/preferences/choices.hpp"

#include <QString>
#include <QStringList>

namespace tp {

/// What the first start asks, in this order.
enum class Question { voice, rate, user, device, photos };
inline constexpr int question_count = 5;

/// What is known while the questions are asked.
struct QuestionFacts {
    bool looking_for_device = false;
    QString device;   ///< what was found, as a person is told; empty: nothing
    QString pictures; ///< the user's folder of pictures; empty: there is none
};

/// The question in words, without its answers.
QString words_of(Question question, const QuestionFacts& facts);

/// Its answers, each for the key of its number, from 1.
QStringList answers_of(Question question, const QuestionFacts& facts);

/// The question with its number and its answers with theirs: what is spoken.
QString spoken(Question question, const QuestionFacts& facts);

/// What a choice of these says now, an index into answers_of; -1 where the choices do not say.
int answer_in(Question question, const Choices& choices);

/// Writes an answer to one of the first three questions into the choices.
void take_answer(Question question, int answer, Choices& choices);

} // namespace tp
