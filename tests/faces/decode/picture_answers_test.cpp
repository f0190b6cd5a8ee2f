// SPDX-License-Identifier: Apache-2.0
// Answers of a decoder that a file has taken over: a picture of the memory that is there, or a sentence.
#include "byte_mutants.hpp"
#include "faces/decode/picture_messages.hpp"
#include "picture_answer_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <set>
#include <string>
#include <vector>

namespace picture_answers_test {

using namespace tp;
using namespace tp::test;

namespace {

std::vector<Seed> answers() { return corpus(in_source("tests/faces/decode/answer_corpus")); }

/// As our own decoder writes it.
std::string written(const Result<PictureAnswer>& answer) {
    PixelTray tray;
    const Message message = message_of(answer, tray);
    return {message.bytes.begin(), message.bytes.end()};
}

PictureAnswer shrunk(int side, int shrink) {
    return {cv::Mat(side, side, CV_8UC3, cv::Scalar(1, 2, 3)), cv::Size(side * shrink, side * shrink), shrink,
            true};
}

} // namespace

class PictureAnswersTest : public QObject {
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
        QCOMPARE(of_corpus("whole"), written(PictureAnswer{shrunk(answered_side, 1)}));
        QCOMPARE(of_corpus("shrunk"), written(PictureAnswer{shrunk(answered_side, 8)}));
        QCOMPARE(of_corpus("sentence"), written(Error{"The JPEG file is damaged."}));
    }

    void only_what_can_be_true_is_believed() {
        const std::set<std::string> true_ones{"whole", "shrunk"};
        const std::vector<Seed> seeds = answers();
        QVERIFY(seeds.size() >= 12);
        for (const Seed& seed : seeds) {
            QVERIFY2(complaint_about_picture_answer(seed.text).empty(), seed.name.c_str());
            QVERIFY2(is_picture_answer(seed.text) == true_ones.contains(seed.name), seed.name.c_str());
        }
    }

    void whatever_is_answered() {
        const std::vector<Seed> seeds = answers();
        ByteMutator mutator(1);
        for (int i = 0; i < 3000; ++i) {
            const std::string complaint = complaint_about_picture_answer(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
    }
};

} // namespace picture_answers_test

TP_TEST(picture_answers_test, PictureAnswersTest, nothing)
#include "picture_answers_test.moc"
