// SPDX-License-Identifier: Apache-2.0
// Answers about metadata of a decoder that a file has taken over.
#include "byte_mutants.hpp"
#include "core/processes/shared_memory.hpp"
#include "faces/exiv2/metadata_messages.hpp"
#include "metadata_answer_check.hpp"
#include "places.hpp"

#include <QTest>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

std::vector<Seed> answers() { return corpus(in_source("tests/faces/exiv2/answer_corpus")); }

std::string named(const char* name) {
    for (const Seed& seed : answers())
        if (seed.name == name)
            return seed.text;
    return "there is none of that name";
}

/// What make_answers.py writes as "all".
StatedMetadata all() {
    StatedMetadata stated;
    stated.width = 400;
    stated.height = 300;
    stated.orientation = 6;
    stated.latitude = -48.5;
    stated.longitude = 16.25;
    stated.taken = "2026:05:01 10:15:00";
    stated.taken_offset = "+02:00";
    stated.date = "2026-05-01";
    stated.time = "10:15:00+02:00";
    stated.caption = "Gr\xFC\xDF"
                     "e";
    stated.xmp = "<x:xmpmeta/>";
    stated.keywords = {"sea", "snow"};
    stated.places = {"Graz", "Austria"};
    stated.xmp_is_damaged = true;
    return stated;
}

std::string bytes_of(const Message& message) { return {message.bytes.begin(), message.bytes.end()}; }

Message in_memory(std::size_t told, std::size_t there) {
    const auto memory = SharedMemory::make(there);
    return MessageWriter().add(static_cast<std::int64_t>(told)).hand_over(memory->another()).take();
}

} // namespace

class MetadataAnswersTest : public QObject {
    Q_OBJECT

private slots:
    void right_ones_of_the_corpus_are_what_a_decoder_writes() {
        QVERIFY(bytes_of(message_of(all())) == named("all"));
        QVERIFY(bytes_of(message_of(StatedMetadata{})) == named("nothing_stated"));
        QVERIFY(bytes_of(message_of(std::nullopt)) == named("nothing_carried"));
    }

    void right_ones_are_read_as_they_were() {
        QVERIFY(stated_in_message(named("all")) == all());
        QVERIFY(stated_in_message(named("nothing_stated")) == StatedMetadata{});
    }

    void only_what_can_be_is_read() {
        int wrong = 0;
        for (const Seed& seed : answers()) {
            QCOMPARE(complaint_about_metadata_answer(seed.text), std::string());
            const bool is_right = seed.name == "all" || seed.name == "nothing_stated" ||
                                  seed.name == "an_orientation_of_nine"; // which is left out
            QVERIFY2(stated_in_message(seed.text).has_value() == is_right, seed.name.c_str());
            wrong += is_right ? 0 : 1;
        }
        QVERIFY(wrong >= 10);
        QVERIFY(!stated_in_message(named("an_orientation_of_nine"))->orientation);
    }

    void what_is_too_long_for_a_message_comes_in_memory() {
        StatedMetadata stated = all();
        stated.xmp = "<x>" + std::string(3'000'000, 'a') + "</x>";
        Message message = message_of(stated);
        QVERIFY(message.bytes.size() < 100);
        QCOMPARE(message.descriptors.size(), std::size_t{1});
        QVERIFY(metadata_in(message) == stated);
    }

    /// Both sides of the border between the two.
    void as_long_as_a_message_may_be() {
        const std::size_t rest = bytes_of(message_of(all())).size() - all().xmp.size();
        for (std::size_t size = longest_message - rest - 70; size < longest_message - rest + 10; ++size) {
            StatedMetadata stated = all();
            stated.xmp = std::string(size, 'a');
            Message message = message_of(stated);
            QVERIFY(message.bytes.size() <= longest_message);
            QVERIFY(metadata_in(message) == stated);
        }
    }

    void memory_that_cannot_be_is_refused_data() {
        QTest::addColumn<quint64>("told");
        QTest::newRow("less than is there") << quint64{10};
        QTest::newRow("more than is there") << quint64{1'000'000};
        QTest::newRow("more than any photograph says") << (quint64{1} << 40);
        QTest::newRow("less than nothing") << std::numeric_limits<quint64>::max();
    }
    void memory_that_cannot_be_is_refused() {
        QFETCH(quint64, told);
        Message message = in_memory(static_cast<std::size_t>(told), 5'000);
        QVERIFY(!metadata_in(message));
    }

    void whatever_is_answered() {
        const std::vector<Seed> seeds = answers();
        ByteMutator mutator(1);
        for (int i = 0; i < 3000; ++i) {
            const std::string complaint = complaint_about_metadata_answer(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(MetadataAnswersTest)
#include "metadata_answers_test.moc"
