// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "audio/recordings/wav_layout.hpp"
#include "byte_mutants.hpp"
#include "flac_check.hpp"
#include "owned_bytes.hpp"
#include "places.hpp"
#include "sounds.hpp"
#include "test_program.hpp"
#include "wav_check.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <sndfile.h>

namespace hostile_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 20190709;
constexpr std::size_t mutated_heads = 20'000;
constexpr std::size_t mutated_sounds = 10'000;

std::vector<Seed> wavs() { return corpus(tp::test::in_source("tests/audio/recordings/wav_corpus")); }
std::vector<Seed> flacs() { return corpus(tp::test::in_source("tests/audio/recordings/flac_corpus")); }

/// A little sound in every format that is read.
std::vector<Seed> sounds(const fs::path& folder) {
    const std::vector<std::pair<const char*, int>> formats{
        {"wav 16", SF_FORMAT_WAV | SF_FORMAT_PCM_16},
        {"wav 8", SF_FORMAT_WAV | SF_FORMAT_PCM_U8},
        {"wav 24", SF_FORMAT_WAV | SF_FORMAT_PCM_24},
        {"wav float", SF_FORMAT_WAV | SF_FORMAT_FLOAT},
        {"wav ADPCM", SF_FORMAT_WAV | SF_FORMAT_IMA_ADPCM},
        {"wav Microsoft ADPCM", SF_FORMAT_WAV | SF_FORMAT_MS_ADPCM},
        {"wav A-law", SF_FORMAT_WAV | SF_FORMAT_ALAW},
        {"extensible", SF_FORMAT_WAVEX | SF_FORMAT_PCM_16},
        {"rf64", SF_FORMAT_RF64 | SF_FORMAT_PCM_16},
        {"w64", SF_FORMAT_W64 | SF_FORMAT_PCM_16},
        {"aiff", SF_FORMAT_AIFF | SF_FORMAT_PCM_16},
        {"au", SF_FORMAT_AU | SF_FORMAT_PCM_16},
        {"caf", SF_FORMAT_CAF | SF_FORMAT_PCM_16},
        {"caf ALAC", SF_FORMAT_CAF | SF_FORMAT_ALAC_16},
        {"flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16},
        {"flac 24", SF_FORMAT_FLAC | SF_FORMAT_PCM_24},
        {"ogg Vorbis", SF_FORMAT_OGG | SF_FORMAT_VORBIS},
        {"ogg Opus", SF_FORMAT_OGG | SF_FORMAT_OPUS},
        {"mp3", SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III}};
    std::vector<Seed> result;
    for (const auto& [name, format] : formats) {
        SF_INFO info{};
        info.samplerate = 48'000;
        info.channels = 1;
        info.format = format;
        const fs::path file = folder / name;
        SNDFILE* const out = sf_open(file.c_str(), SFM_WRITE, &info);
        if (out == nullptr)
            continue; // this libsndfile was built without
        const auto sound = noise(4'800);
        sf_set_string(out, SF_STR_ARTIST, "Opa");
        sf_write_short(out, sound.data(), static_cast<sf_count_t>(sound.size()));
        sf_close(out);
        result.push_back({name, bytes_of(file)});
    }
    return result;
}

/// Reads all there is; frames that were read, or what does not hold.
Result<std::uint64_t> heard(const std::string& bytes) {
    constexpr std::uint64_t enough = 1'000'000;
    auto reader = SoundReader::open(std::make_unique<OwnedBytes>(bytes));
    if (!reader) {
        if (reader.error().size() < 10 || !reader.error().ends_with('.'))
            return Error{"refused without words: " + reader.error()};
        return std::uint64_t{0};
    }
    if (reader->format().channels < 1 || reader->format().rate < 1 || reader->frames() == 0 ||
        reader->frames() > longest_recording_s * static_cast<std::uint64_t>(reader->format().rate))
        return Error{"a sound that none is"};
    std::vector<std::int32_t> block(4'096);
    std::uint64_t total = 0;
    while (const std::size_t frames = reader->read(block)) {
        if (frames * static_cast<std::size_t>(reader->format().channels) > block.size())
            return Error{"more frames than asked for"};
        total += frames;
        if (total > enough)
            break;
    }
    reader->seek(reader->frames() / 2);
    reader->read(block);
    return total;
}

} // namespace

class HostileRecordings : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;

private slots:
    void wav_corpus() {
        QVERIFY(wavs().size() >= 10);
        for (const Seed& input : wavs())
            QVERIFY2(complaint_about_wav(input.text).empty(), input.name.c_str());
    }

    void flac_corpus() {
        QVERIFY(flacs().size() >= 10);
        for (const Seed& input : flacs())
            QVERIFY2(complaint_about_flac(input.text).empty(), input.name.c_str());
    }

    void mutated_wavs() {
        const std::vector<Seed> seeds = wavs();
        ByteMutator mutator(seed);
        std::size_t read = 0;
        for (std::size_t i = 0; i < mutated_heads; ++i) {
            const std::string bytes = mutator.mutant(seeds);
            const std::string complaint = complaint_about_wav(bytes);
            QVERIFY2(complaint.empty(), (std::to_string(i) + ": " + complaint).c_str());
            read += wav_layout(MemoryBytes(bytes)).ok() ? 1 : 0;
        }
        // Mutants that are all refused would test nothing but the refusal.
        QVERIFY2(read > mutated_heads / 10, std::to_string(read).c_str());
    }

    void mutated_flacs() {
        const std::vector<Seed> seeds = flacs();
        ByteMutator mutator(seed);
        std::size_t read = 0;
        for (std::size_t i = 0; i < mutated_heads; ++i) {
            const std::string bytes = mutator.mutant(seeds);
            const std::string complaint = complaint_about_flac(bytes);
            QVERIFY2(complaint.empty(), (std::to_string(i) + ": " + complaint).c_str());
            read += flac_head(MemoryBytes(bytes)).ok() ? 1 : 0;
        }
        QVERIFY2(read > mutated_heads / 10, std::to_string(read).c_str());
    }

    void every_format_is_heard() {
        const std::vector<Seed> seeds = sounds(dir_.path().toStdString());
        QVERIFY(seeds.size() >= 10);
        for (const Seed& input : seeds) {
            const auto frames = heard(input.text);
            QVERIFY2(frames.ok() && *frames >= 4'800, (input.name + frames.error()).c_str());
        }
    }

    void mutated_sounds_of_every_format() {
        const std::vector<Seed> seeds = sounds(dir_.path().toStdString());
        ByteMutator mutator(seed);
        std::size_t read = 0;
        for (std::size_t i = 0; i < mutated_sounds; ++i) {
            const auto frames = heard(mutator.mutant(seeds));
            QVERIFY2(frames.ok(), (std::to_string(i) + ": " + frames.error()).c_str());
            read += *frames > 0 ? 1 : 0;
        }
        QVERIFY2(read > mutated_sounds / 10, std::to_string(read).c_str());
    }
};

} // namespace hostile_test

TP_TEST(hostile_test, HostileRecordings, event_loop)
#include "hostile_test.moc"
