// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/wav_layout.hpp"
#include "audio/recordings/wav_part.hpp"
#include "sounds.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <csignal>
#include <cstring>
#include <sys/resource.h>
#include <sys/stat.h>

namespace wav_part_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

std::string as_bytes(std::span<const std::int16_t> samples) {
    return {reinterpret_cast<const char*>(samples.data()), samples.size() * 2};
}

std::string number(std::uint64_t value, std::size_t bytes) {
    return {reinterpret_cast<const char*>(&value), bytes};
}

std::string chunk(const std::string& name, const std::string& body) {
    return name + number(body.size(), 4) + body + std::string(body.size() & 1, '\0');
}

std::string fmt(unsigned channels = 1, unsigned rate = 48'000, unsigned tag = 1, unsigned bits = 16) {
    return chunk("fmt ", number(tag, 2) + number(channels, 2) + number(rate, 4) +
                             number(rate * channels * bits / 8, 4) + number(channels * bits / 8, 2) +
                             number(bits, 2));
}

std::string riff(const std::string& chunks) {
    return "RIFF" + number(chunks.size() + 4, 4) + "WAVE" + chunks;
}

std::string data(std::uint32_t claim, const std::string& bytes) { return "data" + number(claim, 4) + bytes; }

} // namespace

class WavPartTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }

    void what_is_left_by_a_crash_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<qint64>("frames"); // -1: refused
        const std::string sound = as_bytes(noise(1000));
        const std::string header = open_ended_wav_header({}, "");
        const auto row = [](const char* name, const std::string& file, qint64 frames) {
            QTest::newRow(name) << QByteArray::fromStdString(file) << frames;
        };
        row("ours", header + sound, 1000);
        row("ours, in the middle of a sample", header + sound.substr(0, 1001), 500);
        row("ours, no sample yet", header, 0);
        row("nothing at all", "", 0);
        for (const std::size_t cut : {1u, 4u, 11u, 12u, 19u, 30u, 43u})
            row(("header cut after " + std::to_string(cut)).c_str(), header.substr(0, cut), 0);
        row("size 0", riff(fmt() + data(0, sound)), 1000);
        row("size too small", riff(fmt() + data(10, sound)), 1000);
        row("size too large", riff(fmt() + data(0x7FFFFFF0, sound)), 1000);
        row("size right", riff(fmt() + data(2000, sound)), 1000);
        row("a chunk after the samples",
            riff(fmt() + data(2000, sound) + chunk("LIST", "INFO") + chunk("abcd", "x")), 1000);
        row("half a chunk after the samples", riff(fmt() + data(2000, sound) + "LIST\x20"), 1002);
        row("foreign chunks before",
            riff(chunk("bext", std::string(602, 'b')) + chunk("odd ", "xyz") + fmt() + chunk("fact", "1234") +
                 data(0, sound)),
            1000);
        row("an odd chunk that is not padded", riff("odd " + number(3, 4) + "xyz" + fmt() + data(0, sound)),
            1000);
        row("a chunk larger than the file", riff(fmt() + "JUNK" + number(0xFFFFFFF0, 4) + data(0, sound)),
            -1);
        row("RF64",
            "RF64" + number(0xFFFFFFFF, 4) + "WAVE" + chunk("ds64", number(0, 8) + number(2000, 8)) + fmt() +
                data(0xFFFFFFFF, sound + chunk("LIST", "INFO")),
            1000);
        row("RF64 that claims 2^63",
            "RF64" + number(0xFFFFFFFF, 4) + "WAVE" + chunk("ds64", number(0, 8) + number(1ull << 63, 8)) +
                fmt() + data(0xFFFFFFFF, sound),
            1000);
        row("stereo", riff(fmt(2) + data(0, sound)), 500);
        row("extensible",
            riff(chunk("fmt ", number(0xFFFE, 2) + number(1, 2) + number(48'000, 4) + number(96'000, 4) +
                                   number(2, 2) + number(16, 2) + number(22, 2) + number(16, 2) +
                                   number(4, 4) + number(1, 2) + std::string(14, 'g')) +
                 data(0, sound)),
            1000);
        row("samples before their format", riff(data(0, sound)), -1);
        row("24 bit", riff(fmt(1, 48'000, 1, 24) + data(0, sound)), -1);
        row("floating point", riff(fmt(1, 48'000, 3, 16) + data(0, sound)), -1);
        row("no channel", riff(fmt(0) + data(0, sound)), -1);
        row("three channels", riff(fmt(3) + data(0, sound)), -1);
        row("no rate", riff(fmt(1, 0) + data(0, sound)), -1);
        row("zeros", std::string(5000, '\0'), -1);
        row("not a WAV", "fLaC" + sound, -1);
        row("RIFF of something else", "RIFF" + number(100, 4) + "AVI " + sound, -1);
    }

    void what_is_left_by_a_crash() {
        QFETCH(QByteArray, file);
        QFETCH(qint64, frames);
        const std::string bytes = file.toStdString();
        const auto layout = wav_layout(MemoryBytes(bytes));
        if (frames < 0) {
            QVERIFY(!layout.ok());
            QVERIFY2(layout.error().ends_with('.'), layout.error().c_str());
            return;
        }
        QVERIFY2(layout.ok(), layout.error().c_str());
        QCOMPARE(static_cast<qint64>(layout->frames), frames);
        std::vector<std::int16_t> read(3000);
        const std::size_t count = read_frames(MemoryBytes(bytes), *layout, 0, read);
        QCOMPARE(static_cast<qint64>(count), frames);
        const std::size_t same =
            std::min<std::size_t>(2000, count * 2 * static_cast<std::size_t>(layout->format.channels));
        QVERIFY(std::memcmp(read.data(), noise(1000).data(), same) == 0);
    }

    void what_was_appended_is_in_the_file() {
        const fs::path place = root_ / "a.wav.part";
        RecordingNotes notes;
        notes.label = {RecordingKind::person,       "Anna",          "Opa", "de-AT",
                       "2026-05-01T10:15:00+02:00", "Das ist\nAnna."};
        const auto samples = noise(3 * 44'100);
        {
            auto part = WavPart::create(place, {44'100, 1}, notes);
            QVERIFY2(part.ok(), part.error().c_str());
            QCOMPARE(part->append(std::span(samples).first(44'099)), std::string());
            QCOMPARE(part->frames_synced(), std::uint64_t{0});
            QCOMPARE(part->append(std::span(samples).subspan(44'099)), std::string());
            QCOMPARE(part->frames(), std::uint64_t{3 * 44'100});
            QCOMPARE(part->frames_synced(), part->frames());
        }
        struct stat about {};
        QCOMPARE(::stat(place.c_str(), &about), 0);
        QCOMPARE(about.st_mode & 0777u, 0600u);
        QCOMPARE(names_in(root_), std::string("a.wav.part"));
        const std::string bytes = bytes_of(place);
        const auto layout = wav_layout(MemoryBytes(bytes));
        QVERIFY2(layout.ok(), layout.error().c_str());
        QVERIFY(layout->format == (SoundFormat{44'100, 1}));
        const auto carried = vorbis_comments(layout->notes);
        QVERIFY(carried.ok());
        QVERIFY(notes_in(*carried) == notes);
        std::vector<std::int16_t> read(samples.size() + 1);
        QCOMPARE(read_frames(MemoryBytes(bytes), *layout, 0, read), samples.size());
        read.pop_back();
        QVERIFY(read == samples);
    }

    void libsndfile_can_play_it() {
        auto part = WavPart::create(root_ / "a.wav.part", {}, {});
        QVERIFY(part.ok());
        QCOMPARE(part->append(noise(48'000)), std::string());
        QVERIFY(samples_of(part->place()) == widened(noise(48'000)));
    }

    void more_than_4_gigabytes() {
        const fs::path place = root_ / "a.wav.part";
        const std::string header = open_ended_wav_header({}, "");
        const std::uint64_t frames = 3ull << 30;
        write_bytes(place, header);
        fs::resize_file(place, header.size() + 2 * (frames - 2)); // a hole
        std::ofstream(place, std::ios::binary | std::ios::app) << "abcd";
        const auto file = FileBytes::open(place);
        const auto layout = wav_layout(**file);
        QCOMPARE(layout->frames, frames);
        std::array<std::int16_t, 3> last{};
        QCOMPARE(read_frames(**file, *layout, frames - 2, last), std::size_t{2});
        QVERIFY(std::memcmp(last.data(), "abcd", 4) == 0);
    }

    void a_name_that_is_taken_is_refused() {
        auto first = WavPart::create(root_ / "a.wav.part", {}, {});
        QVERIFY(first.ok());
        QCOMPARE(first->append(noise(10)), std::string());
        const auto second = WavPart::create(root_ / "a.wav.part", {}, {});
        QVERIFY2(second.error().find("already") != std::string::npos, second.error().c_str());
        QCOMPARE(names_in(root_), std::string("a.wav.part"));
    }

    void formats_that_no_recording_has() {
        for (const SoundFormat format :
             {SoundFormat{48'000, 0}, {48'000, 3}, {7'999, 1}, {192'001, 1}, {-1, 1}})
            QVERIFY(!WavPart::create(root_ / "a.wav.part", format, {}).ok());
        RecordingNotes endless;
        endless.label.transcript.assign(most_wav_notes, 'x');
        QVERIFY(!WavPart::create(root_ / "a.wav.part", {}, endless).ok());
        QVERIFY(!WavPart::create(root_ / "missing" / "a.wav.part", {}, {}).ok());
        QCOMPARE(names_in(root_), std::string());
    }

    void the_lock_is_held_as_long_as_the_part() {
        const fs::path place = root_ / "a.wav.part";
        {
            const auto part = WavPart::create(place, {}, {});
            QVERIFY(part.ok());
            const auto lock = PartLock::take(place);
            QVERIFY(lock.ok() && !*lock);
        }
        const auto lock = PartLock::take(place);
        QVERIFY(lock.ok() && *lock);
        const auto again = PartLock::take(place);
        QVERIFY(again.ok() && !*again);
        const auto gone = PartLock::take(root_ / "missing");
        QVERIFY(gone.ok() && !*gone);
        QVERIFY(!PartLock::take(root_).ok());
    }

    /// A limit on the size of files stands in for a disk that fills up.
    void a_full_disk_is_said_and_what_fitted_is_kept() {
        auto part = WavPart::create(root_ / "a.wav.part", {48'000, 2}, {});
        QVERIFY(part.ok());
        const auto samples = noise(20'000);
        QCOMPARE(part->append(std::span(samples).first(2'000)), std::string());
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 10'001, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const std::string reason = part->append(std::span(samples).subspan(2'000));
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY(reason.ends_with('.'));
        const std::uint64_t kept = part->frames();
        QVERIFY(kept > 2'000 && kept < 10'000);
        QCOMPARE(part->append(std::span(samples).subspan(kept * 2)), std::string()); // there is room again
        QCOMPARE(part->sync(), std::string());
        const std::string bytes = bytes_of(root_ / "a.wav.part");
        const auto layout = wav_layout(MemoryBytes(bytes));
        std::vector<std::int16_t> read(20'000);
        QCOMPARE(read_frames(MemoryBytes(bytes), *layout, 0, read), std::size_t{10'000});
        QVERIFY(read == samples);
    }
};

} // namespace wav_part_test

TP_TEST(wav_part_test, WavPartTest, event_loop)
#include "wav_part_test.moc"
