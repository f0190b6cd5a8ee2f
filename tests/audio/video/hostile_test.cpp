// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/sound_reader.hpp"
#include "audio/video/video_sound.hpp"
#include "byte_mutants.hpp"
#include "places.hpp"
#include "sound_check.hpp"

#include <QTest>

#include <memory>
#include <string>

using namespace tp::test;

namespace {

constexpr std::uint64_t seed = 20260501;
constexpr std::size_t mutated_sounds = 1'000;

std::vector<Seed> sounds() { return corpus(in_source("tests/audio/video/corpus")); }

} // namespace

class HostileSounds : public QObject {
    Q_OBJECT

private slots:
    void sound_corpus() {
        QVERIFY(sounds().size() >= 8);
        for (const Seed& input : sounds()) {
            const std::string complaint = complaint_about_sound(input.text);
            QVERIFY2(complaint.empty(), (input.name + ": " + complaint).c_str());
            const bool video =
                input.name.find("_mp4") != std::string::npos || input.name.find("_mov") != std::string::npos;
            QVERIFY2(video ? tp::VideoSound::open(std::make_unique<tp::MemoryBytes>(input.text)).ok()
                           : tp::SoundReader::open(std::make_unique<tp::MemoryBytes>(input.text)).ok(),
                     input.name.c_str());
        }
    }

    void mutated_sounds_are_refused_or_heard() {
        const std::vector<Seed> seeds = sounds();
        ByteMutator mutator(seed);
        for (std::size_t i = 0; i < mutated_sounds; ++i) {
            const std::string complaint = complaint_about_sound(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), (std::to_string(i) + ": " + complaint).c_str());
        }
    }
};

QTEST_GUILESS_MAIN(HostileSounds)
#include "hostile_test.moc"
