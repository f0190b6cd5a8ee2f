// SPDX-License-Identifier: Apache-2.0
#include "app/pages/start/questions.hpp"

#include <QCoreApplication>

#include <array>
#include <cstddef>

namespace tp {

namespace {

class Words {
    Q_DECLARE_TR_FUNCTIONS(tp::Questions)
};

constexpr std::array voice_answers{Choices::Voice::program, Choices::Voice::off,
                                   Choices::Voice::screen_reader};

} // namespace

QString words_of(Question question, const QuestionFacts& facts) {
    switch (question) {
    case Question::voice:
        return Words::tr("Should TouchPhoto speak?");
    case Question::rate:
        return Words::tr("How fast should it speak?");
    case Question::user:
        return Words::tr("Who uses this tablet most?");
    case Question::device:
        if (facts.looking_for_device)
            return Words::tr("Looking for a force device.");
        return facts.device.isEmpty()
                   ? Words::tr(
                         "No force device was found. A finger on the screen is guided by sound instead.")
                   : Words::tr("A force device was found: %1.").arg(facts.device);
    case Question::photos:
        return Words::tr("Where are your photographs?");
    }
    return {};
}

QStringList answers_of(Question question, const QuestionFacts& facts) {
    switch (question) {
    case Question::voice:
        return {Words::tr("Yes"), Words::tr("No, the words on the screen are enough"),
                Words::tr("No, my screen reader speaks")};
    case Question::rate:
        return {Words::tr("Very slowly"), Words::tr("Slowly"), Words::tr("At the usual speed"),
                Words::tr("Fast"), Words::tr("Very fast")};
    case Question::user:
        return {Words::tr("Somebody who listens and feels"), Words::tr("Somebody who looks after the album")};
    case Question::device:
        return {facts.device.isEmpty() ? Words::tr("Continue without a device")
                                       : Words::tr("Use this device"),
                Words::tr("Look again")};
    case Question::photos: {
        QStringList answers;
        if (!facts.pictures.isEmpty())
            answers << Words::tr("In the folder %1").arg(facts.pictures);
        return answers << Words::tr("In another folder") << Words::tr("Ask me later");
    }
    }
    return {};
}

QString spoken(Question question, const QuestionFacts& facts) {
    QString text = Words::tr("Question %1 of %2. %3")
                       .arg(static_cast<int>(question) + 1)
                       .arg(question_count)
                       .arg(words_of(question, facts));
    const QStringList answers = answers_of(question, facts);
    for (int i = 0; i < answers.size(); ++i)
        text += ' ' + Words::tr("%1: %2.").arg(i + 1).arg(answers[i]);
    return text;
}

int answer_in(Question question, const Choices& choices) {
    if (question == Question::voice)
        for (std::size_t i = 0; i < voice_answers.size(); ++i)
            if (voice_answers[i] == choices.voice)
                return static_cast<int>(i);
    if (question == Question::rate)
        return static_cast<int>(choices.rate);
    if (question == Question::user)
        return static_cast<int>(choices.user);
    return -1;
}

void take_answer(Question question, int answer, Choices& choices) {
    if (question == Question::voice)
        choices.voice = voice_answers.at(static_cast<std::size_t>(answer));
    else if (question == Question::rate)
        choices.rate = static_cast<Choices::Rate>(answer);
    else if (question == Question::user)
        choices.user = static_cast<Choices::User>(answer);
}

} // namespace tp
