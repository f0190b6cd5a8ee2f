// SPDX-License-Identifier: Apache-2.0
// Answers of a decoder of videos that a file has taken over: a picture of the memory that is there, the end, or a sentence.
#include "audio/video/film_messages.hpp"
#include "byte_mutants.hpp"
#include "film_answer_check.hpp"
#include "places.hpp"

#include <QTest>

#include <optional>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

std::vector<Seed> answers() { return corpus(in_source("tests/audio/video/answer_corpus")); }

/// As our own decoder writes it.
std::string written(const Result<std::optional<FilmPicture>>& picture) {
    FilmTray tray;
    const Message message = tray.message_of(picture);
    return {message.bytes.begin(), message.bytes.end()};
}

} // namespace

class FilmAnswersTest : public QObject {
    Q_OBJECT

private slots:
    void right_ones_of_the_corpus_are_what_a_decoder_writes() {
        const std::vector<Seed> seeds = answers();
        const auto of_corpus = [&](const char* name) {
            for (const Seed& seed : seeds)
                if (seed.name == name)
                    return seed.text;
            return std::string("there is none of that name");
        };
        FilmPicture picture{1.5, answered_side, answered_side, 90, {}};
        picture.planes.resize(film_bytes(answered_side, answered_side), 128);
        QCOMPARE(of_corpus("picture"), written(std::optional(picture)));
        QCOMPARE(of_corpus("end"), written(std::optional<FilmPicture>()));
        QCOMPARE(of_corpus("sentence"), written(Error{"it is damaged."}));
    }

    void only_what_can_be_true_is_believed() {
        const std::vector<Seed> seeds = answers();
        QVERIFY(seeds.size() >= 12);
        for (const Seed& seed : seeds) {
            QVERIFY2(complaint_about_film_answer(seed.text).empty(), seed.name.c_str());
            const bool right = seed.name == "picture" || seed.name == "end";
            QCOMPARE(kind_of_film_answer(seed.text), right ? seed.name : std::string("sentence"));
        }
    }

    void whatever_is_answered() {
        const std::vector<Seed> seeds = answers();
        ByteMutator mutator(1);
        for (int i = 0; i < 3000; ++i) {
            const std::string complaint = complaint_about_film_answer(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(FilmAnswersTest)
#include "film_answers_test.moc"
