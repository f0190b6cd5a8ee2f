// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/camera_sound.hpp"
#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/import_sound.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/trim.hpp"
#include "sounds.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sndfile.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace import_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

/// Writes 32-bit samples in any format of libsndfile; whether it can.
bool write_sound(const fs::path& file, int format, const std::vector<std::int32_t>& samples,
                 SoundFormat sound = {}) {
    SF_INFO info{};
    info.samplerate = sound.rate;
    info.channels = sound.channels;
    info.format = format;
    SNDFILE* const out = sf_open(file.c_str(), SFM_WRITE, &info);
    if (out == nullptr)
        return false;
    sf_set_string(out, SF_STR_ARTIST, "Opa");
    sf_command(out, SFC_SET_SCALE_INT_FLOAT_WRITE, nullptr, SF_TRUE);
    const auto count = static_cast<sf_count_t>(samples.size());
    const bool done = sf_write_int(out, samples.data(), count) == count;
    return sf_close(out) == 0 && done;
}

std::vector<std::int32_t> at_depth(std::vector<std::int32_t> samples, int bits) {
    for (std::int32_t& sample : samples)
        sample = static_cast<std::int32_t>(static_cast<std::uint32_t>(sample) & ~0u << (32 - bits));
    return samples;
}

std::vector<std::int32_t> wide_noise(std::size_t count) {
    std::mt19937 random(3);
    std::vector<std::int32_t> result(count);
    for (std::int32_t& sample : result)
        sample = static_cast<std::int32_t>(static_cast<std::uint32_t>(random()));
    return result;
}

RecordingNotes memo_of_opa() {
    RecordingNotes notes;
    notes.label.speaker = "Opa";
    notes.label.recorded = "2026-05-01T10:15:00+02:00";
    return notes;
}

std::string number(std::uint64_t value, std::size_t bytes) {
    return {reinterpret_cast<const char*>(&value), bytes};
}

/// The format chunk of a WAV file: 48 kHz, mono, 16 bit.
const std::string fmt = "fmt " + number(16, 4) + number(1, 2) + number(1, 2) + number(48'000, 4) +
                        number(96'000, 4) + number(2, 2) + number(16, 2);

/// The bytes after the metadata.
std::string sound_bytes(const fs::path& flac) {
    const auto bytes = FileBytes::open(flac);
    return bytes_of(flac).substr(flac_head(**bytes)->sound_begin);
}

} // namespace

class ImportTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;
    fs::path tags_;

    /// A FLAC of 16 bit that another program made.
    fs::path foreign_flac(const std::vector<std::int32_t>& samples) const {
        const fs::path file = root_ / "foreign.flac";
        write_sound(file, SF_FORMAT_FLAC | SF_FORMAT_PCM_16, samples);
        return file;
    }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
        tags_ = root_ / "IMG_1.jpg.tags";
    }
    void cleanup() { fs::remove_all(root_); }

    void without_loss_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("bits");
        QTest::newRow("WAV 16") << (SF_FORMAT_WAV | SF_FORMAT_PCM_16) << 16;
        QTest::newRow("WAV 8") << (SF_FORMAT_WAV | SF_FORMAT_PCM_U8) << 8;
        QTest::newRow("WAV 24") << (SF_FORMAT_WAV | SF_FORMAT_PCM_24) << 24;
        QTest::newRow("AIFF 24") << (SF_FORMAT_AIFF | SF_FORMAT_PCM_24) << 24;
        QTest::newRow("FLAC 16") << (SF_FORMAT_FLAC | SF_FORMAT_PCM_16) << 16;
        QTest::newRow("FLAC 24") << (SF_FORMAT_FLAC | SF_FORMAT_PCM_24) << 24;
        QTest::newRow("Apple Lossless") << (SF_FORMAT_CAF | SF_FORMAT_ALAC_24) << 24;
        QTest::newRow("WAV 32, its upper 24") << (SF_FORMAT_WAV | SF_FORMAT_PCM_32) << 24;
    }
    void without_loss() {
        QFETCH(int, format);
        QFETCH(int, bits);
        // libsndfile 1.2 spoils noise when it writes Apple Lossless
        const bool apple = (format & SF_FORMAT_SUBMASK) == SF_FORMAT_ALAC_24;
        const auto sound = apple ? tone(0.5, 1.0) : wide_noise(60'000);
        QVERIFY(write_sound(root_ / "from", format, sound, {44'100, 2}));
        const std::string before = bytes_of(root_ / "from");
        const auto imported = import_sound(root_ / "from", tags_, memo_of_opa());
        QVERIFY2(imported.ok(), imported.error().c_str());
        QCOMPARE(imported->warning, std::string());
        QCOMPARE(imported->file.filename().string(), std::string("2026-05-01T101500-memo.flac"));
        QVERIFY(at_depth(samples_of(imported->file), bits) == at_depth(sound, bits));
        QVERIFY(about_recording(imported->file)->notes == memo_of_opa());
        QVERIFY(about_recording(imported->file)->format == (SoundFormat{44'100, 2}));
        QVERIFY(bytes_of(root_ / "from") == before);
        if (has_program("flac"))
            QCOMPARE(run("flac", {"-t", "-s", QString::fromStdString(imported->file)}).status, 0);
    }

    void compressed_with_loss_data() {
        QTest::addColumn<int>("format");
        QTest::newRow("MP3") << (SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III);
        QTest::newRow("Ogg Vorbis") << (SF_FORMAT_OGG | SF_FORMAT_VORBIS);
        QTest::newRow("Opus") << (SF_FORMAT_OGG | SF_FORMAT_OPUS);
        QTest::newRow("floating point") << (SF_FORMAT_WAV | SF_FORMAT_FLOAT);
        QTest::newRow("A-law") << (SF_FORMAT_WAV | SF_FORMAT_ALAW);
        QTest::newRow("ADPCM") << (SF_FORMAT_WAV | SF_FORMAT_IMA_ADPCM);
    }
    void compressed_with_loss() {
        QFETCH(int, format);
        const auto sound = tone(0.5, 2.0);
        if (!write_sound(root_ / "from", format, sound))
            QSKIP("this libsndfile cannot write it");
        const auto imported = import_sound(root_ / "from", tags_, memo_of_opa());
        QVERIFY2(imported.ok(), imported.error().c_str());
        QCOMPARE(imported->warning, std::string());
        const auto heard = samples_of(imported->file);
        QVERIFY(heard.size() >= sound.size() && heard.size() < sound.size() + 5'000);
        double energy = 0.0; // that of a sine of half of full scale, wherever its beginning has moved
        for (const std::int32_t sample : heard)
            energy += std::pow(sample / 2147483648.0, 2.0);
        const double rms = std::sqrt(energy / static_cast<double>(sound.size()));
        QVERIFY2(std::abs(rms - 0.5 / std::numbers::sqrt2) < 0.01, std::to_string(rms).c_str());
    }

    void floating_point_beyond_full_scale_is_cut() {
        SF_INFO info{};
        info.samplerate = 48'000;
        info.channels = 1;
        info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
        SNDFILE* const out = sf_open((root_ / "from").c_str(), SFM_WRITE, &info);
        const std::vector<float> samples{0.0F, 2.0F, -2.0F, INFINITY, -INFINITY, NAN, 0.5F, -1.0F};
        sf_write_float(out, samples.data(), static_cast<sf_count_t>(samples.size()));
        sf_close(out);
        const auto imported = import_sound(root_ / "from", tags_, {});
        QVERIFY2(imported.ok(), imported.error().c_str());
        const std::int32_t most = 0x7FFFFF00;
        const std::int32_t least = INT32_MIN;
        QVERIFY(samples_of(imported->file) ==
                (std::vector<std::int32_t>{0, most, least, 0, 0, 0, 1 << 30, least}));
    }

    void a_flac_is_copied_byte_for_byte() {
        const fs::path from = foreign_flac(widened(noise(50'000)));
        const auto imported = import_sound(from, tags_, memo_of_opa());
        QVERIFY2(imported.ok(), imported.error().c_str());
        QVERIFY(sound_bytes(imported->file) == sound_bytes(from));
        struct stat about {};
        QCOMPARE(::stat(imported->file.c_str(), &about), 0);
        QCOMPARE(about.st_mode & 0777u, 0600u);
        const auto again = import_sound(imported->file, tags_, memo_of_opa());
        QCOMPARE(again->file.filename().string(), std::string("2026-05-01T101500-memo-2.flac"));
    }

    void a_flac_that_was_written_into_a_pipe() {
        const auto sound = widened(noise(100'000));
        const fs::path from = foreign_flac(sound);
        std::string bytes = bytes_of(from);
        bytes[21] = static_cast<char>(bytes[21] & 0xF0); // it does not know how long it will be
        bytes.replace(22, 4, 4, '\0');
        write_bytes(from, bytes);
        QCOMPARE(about_recording(from)->frames, std::uint64_t{100'000});
        const auto imported = import_sound(from, tags_, {});
        QVERIFY2(imported.ok(), imported.error().c_str());
        QVERIFY(samples_of(imported->file) == sound);
        QCOMPARE(flac_head(**FileBytes::open(imported->file))->frames, std::uint64_t{100'000});
        const auto piece = trim_recording(from, 50'000, 60'000);
        QVERIFY2(piece.ok(), piece.error().c_str());
        QVERIFY(samples_of(*piece) ==
                std::vector<std::int32_t>(sound.begin() + 50'000, sound.begin() + 60'000));
    }

    void a_damaged_flac_gives_what_can_be_read() {
        const auto sound = widened(noise(200'000));
        const fs::path from = foreign_flac(sound);
        const std::string whole = bytes_of(from);
        write_bytes(from, whole.substr(0, whole.size() / 2));
        const auto imported = import_sound(from, tags_, {});
        QVERIFY2(imported.ok(), imported.error().c_str());
        QVERIFY2(imported->warning.find("damaged") != std::string::npos, imported->warning.c_str());
        const auto heard = samples_of(imported->file);
        QVERIFY(heard.size() > 80'000 && heard.size() <= 100'000);
        QVERIFY(std::equal(heard.begin(), heard.end(), sound.begin()));
    }

    void hostile_files_data() {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* name, const std::string& bytes) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes);
        };
        const std::string quiet(1'000, '\0');
        row("empty", "");
        row("text", "Dear Anna,");
        row("RIFF and nothing", "RIFF");
        row("WAV without samples", "RIFF" + number(36, 4) + "WAVE" + fmt + "data" + number(0, 4));
        row("FLAC marker", "fLaC");
        // blocks of 4096 frames, 48 kHz, mono, 16 bit
        const std::string info = std::string("\x10\x00\x10\x00", 4) + std::string(6, '\0') +
                                 std::string("\x0B\xB8\x00\xFF", 4) + std::string(4, '\xFF') +
                                 std::string(16, '\0');
        row("FLAC that claims 2^36 frames", "fLaC" + std::string("\x80\0\0\x22", 4) + info + quiet);
        row("FLAC block of 16 MB", "fLaC" + std::string("\x84\xFF\xFF\xFF", 4) + quiet);
        row("Ogg page and nothing", "OggS" + std::string(23, '\0') + "\xFF" + std::string(100, '\xFF'));
        row("ID3 of 256 MB", "ID3\x04" + std::string(2, '\0') + "\x7F\x7F\x7F\x7F" + quiet);
        row("AIFF that claims 4 GB", "FORM\xFF\xFF\xFF\xFF"
                                     "AIFFSSND\xFF\xFF\xFF\xFF" +
                                         quiet);
    }
    void hostile_files() {
        QFETCH(QByteArray, bytes);
        write_bytes(root_ / "from", bytes.toStdString());
        const auto imported = import_sound(root_ / "from", tags_, {});
        QVERIFY(!imported.ok());
        QVERIFY2(imported.error().size() > 10 && imported.error().ends_with('.'), imported.error().c_str());
        QVERIFY(!fs::exists(tags_) || fs::is_empty(tags_));
    }

    void claims_that_are_too_large_take_nothing_more() {
        const std::string sound(20'000, 's');
        write_bytes(root_ / "gigabyte.wav",
                    "RIFF" + number(1 << 30, 4) + "WAVE" + fmt + "data" + number(1 << 30, 4) + sound);
        write_bytes(root_ / "ages.wav", "RF64" + number(0xFFFFFFFF, 4) + "WAVEds64" + number(28, 4) +
                                            number(1ull << 63, 8) + number(1ull << 63, 8) +
                                            number(1ull << 62, 8) + number(0, 4) + fmt + "data" +
                                            number(0xFFFFFFFF, 4) + sound);
        for (const char* name : {"gigabyte.wav", "ages.wav"}) {
            const auto imported = import_sound(root_ / name, tags_, {});
            if (imported)
                QVERIFY2(samples_of(imported->file).size() <= 10'000, name);
            else
                QVERIFY2(imported.error().ends_with('.'), imported.error().c_str());
        }
    }

    void longer_than_a_day_is_refused() {
        // silence is small in FLAC: a second of it at the lowest rate, then a header that claims more
        QVERIFY(write_sound(root_ / "from", SF_FORMAT_FLAC | SF_FORMAT_PCM_16,
                            std::vector<std::int32_t>(8'000), {8'000, 1}));
        std::string bytes = bytes_of(root_ / "from");
        const std::uint32_t frames = 8'000 * 86'400 + 1;
        for (std::size_t i = 0; i < 4; ++i)
            bytes[22 + i] = static_cast<char>(frames >> (8 * (3 - i)) & 0xFFu);
        write_bytes(root_ / "from", bytes);
        const auto imported = import_sound(root_ / "from", tags_, {});
        QVERIFY2(imported.error().find("24 hours") != std::string::npos, imported.error().c_str());
    }

    void names_that_others_gave() {
        int files = 0;
        for (const std::string& name : {std::string("two\nlines.wav"), std::string("J\xF6rg.wav"),
                                        std::string(251, 'n') + ".wav", std::string("-rf")}) {
            QVERIFY(write_sound(root_ / name, SF_FORMAT_WAV | SF_FORMAT_PCM_16, widened(noise(100))));
            const auto imported = import_sound(root_ / name, tags_, memo_of_opa());
            QVERIFY2(imported.ok(), imported.error().c_str());
            const auto trimmed = trim_recording(root_ / name, 10, 20);
            QVERIFY2(trimmed.ok(), trimmed.error().c_str());
            ++files;
        }
        QCOMPARE(std::distance(fs::directory_iterator(tags_), fs::directory_iterator()), files);
    }

    void a_disk_that_fills_up_leaves_nothing() {
        const fs::path from = foreign_flac(widened(noise(100'000)));
        QVERIFY(write_sound(root_ / "from.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, widened(noise(100'000))));
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 50'000, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto copied = import_sound(from, tags_, {});
        const auto encoded = import_sound(root_ / "from.wav", tags_, {});
        const auto trimmed = trim_recording(from, 0, 90'000);
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        for (const std::string& reason : {copied.error(), encoded.error(), trimmed.error()})
            QVERIFY2(reason.ends_with('.'), reason.c_str());
        QCOMPARE(names_in(tags_), std::string());
        QCOMPARE(names_in(root_), std::string("IMG_1.jpg.tags foreign.flac from.wav"));
    }

    void trimming_is_exact_data() {
        QTest::addColumn<int>("begin");
        QTest::addColumn<int>("end");
        QTest::newRow("all") << 0 << 100'000;
        QTest::newRow("first sample") << 0 << 1;
        QTest::newRow("last sample") << 99'999 << 100'000;
        QTest::newRow("across blocks") << 4'095 << 8'193;
        QTest::newRow("middle") << 12'345 << 67'890;
    }
    void trimming_is_exact() {
        QFETCH(int, begin);
        QFETCH(int, end);
        const auto sound = wide_noise(200'000);
        const fs::path from = root_ / "a.flac";
        QVERIFY(write_sound(from, SF_FORMAT_FLAC | SF_FORMAT_PCM_24, sound, {48'000, 2}));
        RecordingNotes notes = memo_of_opa();
        notes.chapters = {{0.0, "one"}, {1.0, "two"}};
        QCOMPARE(relabel_recording(from, notes), std::string());
        const std::string before = bytes_of(from);
        const auto piece =
            trim_recording(from, static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(end));
        QVERIFY2(piece.ok(), piece.error().c_str());
        QCOMPARE(piece->filename().string(), std::string("a-2.flac"));
        const std::vector<std::int32_t> expected(sound.begin() + 2 * begin, sound.begin() + 2 * end);
        QVERIFY(samples_of(*piece) == at_depth(expected, 24));
        QVERIFY(bytes_of(from) == before);
        const auto about = about_recording(*piece);
        QVERIFY(about->notes.label == notes.label);
        QCOMPARE(about->notes.chapters.at(0).name, std::string(begin < 48'000 ? "one" : "two"));
    }

    void chapters_follow_the_piece() {
        const std::vector<Chapter> chapters{{0.0, "a"}, {10.0, "b"}, {20.0, "c"}, {30.0, "d"}};
        QVERIFY(chapters_between(chapters, 12.0, 30.0) == (std::vector<Chapter>{{0.0, "b"}, {8.0, "c"}}));
        QVERIFY(chapters_between(chapters, 10.0, 10.5) == (std::vector<Chapter>{{0.0, "b"}}));
        QVERIFY(chapters_between(chapters, 0.0, 100.0) == chapters);
        QVERIFY(chapters_between({{5.0, "x"}}, 0.0, 3.0).empty());
    }

    void pieces_that_are_none_are_refused() {
        const fs::path from = foreign_flac(widened(noise(1'000)));
        for (const auto& [begin, end] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{
                 {5, 5}, {6, 5}, {0, 1'001}, {UINT64_MAX, 1}, {0, UINT64_MAX}})
            QVERIFY(!trim_recording(from, begin, end).ok());
        QCOMPARE(names_in(root_), std::string("foreign.flac"));
    }

    void a_damaged_recording_is_not_trimmed_short() {
        const fs::path from = foreign_flac(widened(noise(100'000)));
        const std::string whole = bytes_of(from);
        write_bytes(from, whole.substr(0, whole.size() / 2));
        QVERIFY(trim_recording(from, 10'000, 90'000).error().ends_with('.'));
        QCOMPARE(names_in(root_), std::string("foreign.flac"));
    }

    void the_sound_half_of_a_pair() {
        for (const char* name : {"IMG_1.JPG", "IMG_1.WAV", "img_2.jpg", "IMG_2.wav", "img_2.WaV", "IMG_3.jpg",
                                 "IMG_3.wav.part", "IMG_33.WAV", "J\xF6rg.JPG", "J\xF6RG.WAV", "J\xF6rg.wav"})
            write_bytes(root_ / name, "x");
        fs::create_directory(root_ / "IMG_4.WAV");
        fs::create_symlink("nowhere", root_ / "IMG_5.WAV");
        const CameraSounds sounds(root_);
        const auto of = [&](const char* photo) {
            const auto sound = sounds.of(root_ / photo);
            return sound ? sound->filename().string() : std::string();
        };
        QCOMPARE(of("IMG_1.JPG"), std::string("IMG_1.WAV"));
        QCOMPARE(of("IMG_1.DNG"), std::string("IMG_1.WAV"));
        QCOMPARE(of("img_2.jpg"), std::string("img_2.WaV"));
        QCOMPARE(of("Img_2.jpg"), std::string("IMG_2.wav"));
        QCOMPARE(of("J\xF6rg.JPG"), std::string("J\xF6rg.wav"));
        for (const char* photo : {"IMG_3.jpg", "IMG_4.jpg", "IMG_5.jpg", "", "IMG_33.WAV"})
            QCOMPARE(of(photo), std::string());
        QVERIFY(sound_beside(root_ / "IMG_1.JPG") == root_ / "IMG_1.WAV");
        QVERIFY(!sound_beside(root_ / "missing" / "IMG_1.JPG"));
    }
};

} // namespace import_test

TP_TEST(import_test, ImportTest, event_loop)
#include "import_test.moc"
