// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/recording_name.hpp"
#include "core/files/file_words.hpp"
#include "sounds.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <stop_token>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace recording_file_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

RecordingNotes notes_of_anna() {
    RecordingNotes notes;
    notes.label = {RecordingKind::story,           "Anna",
                   "Opa; Jörg שלום 👵🏽", "de-AT",
                   "2026-05-01T10:15:00+02:00",    "Das ist Anna.\nAm See = 1962.\n"};
    notes.chapters = {{0.0, "Am See"}, {1.5, ""}, {3723.25, "Heimweg"}};
    return notes;
}

/// A finished recording of these samples.
fs::path recorded(const fs::path& folder, const RecordingNotes& notes, std::span<const std::int16_t> samples,
                  const SoundFormat& format = {}) {
    auto part = start_recording(folder, notes, format);
    if (!part || !part->append(samples).empty())
        return {};
    const auto flac = finish_recording(std::move(*part), notes);
    return flac && *flac ? **flac : fs::path();
}

} // namespace

class RecordingFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }

    void a_recording_becomes_a_flac_data() {
        QTest::addColumn<int>("rate");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("samples");
        QTest::newRow("usual") << 48'000 << 1 << 100'000;
        QTest::newRow("stereo") << 44'100 << 2 << 100'000;
        QTest::newRow("one sample") << 8'000 << 1 << 1;
        QTest::newRow("192 kHz") << 192'000 << 2 << 200'000;
    }
    void a_recording_becomes_a_flac() {
        QFETCH(int, rate);
        QFETCH(int, channels);
        QFETCH(int, samples);
        const auto sound = noise(static_cast<std::size_t>(samples));
        const fs::path folder = root_ / "deep" / QTest::currentDataTag();
        const fs::path flac = recorded(folder, notes_of_anna(), sound, {rate, channels});
        QCOMPARE(flac.filename().string(), std::string("2026-05-01T101500-story.flac"));
        QCOMPARE(names_in(folder), flac.filename().string());
        QVERIFY(samples_of(flac) == widened(sound));
        struct stat about {};
        QCOMPARE(::stat(flac.c_str(), &about), 0);
        QCOMPARE(about.st_mode & 0777u, 0600u);
        const auto says = about_recording(flac);
        QVERIFY2(says.ok(), says.error().c_str());
        QVERIFY(says->notes == notes_of_anna());
        QVERIFY(says->format == (SoundFormat{rate, channels}));
        QCOMPARE(says->frames, static_cast<std::uint64_t>(samples / channels));
        QVERIFY(says->flac);
    }

    void flac_and_metaflac_agree() {
        if (!has_program("flac") || !has_program("metaflac"))
            QSKIP("flac is not installed");
        const fs::path flac = recorded(root_, notes_of_anna(), noise(100'000));
        const QString name = QString::fromStdString(flac);
        const Ran tested = run("flac", {"-t", "--warnings-as-errors", "-s", name});
        QVERIFY2(tested.status == 0, tested.output.c_str());
        const Ran listed =
            run("metaflac", {"--no-utf8-convert", "--list", "--block-type=VORBIS_COMMENT", name});
        QCOMPARE(listed.status, 0);
        for (const char* line :
             {"KIND=story\n", "PERSON=Anna\n", "SPEAKER=Opa; Jörg שלום 👵🏽\n", "LANGUAGE=de-AT\n",
              "DATE=2026-05-01T10:15:00+02:00\n", "TRANSCRIPT=Das ist Anna.\nAm See = 1962.\n",
              "CHAPTER001=00:00:00.000\n", "CHAPTER001NAME=Am See\n", "CHAPTER002=00:00:01.500\n",
              "CHAPTER003=01:02:03.250\n", "CHAPTER003NAME=Heimweg\n"})
            QVERIFY2(listed.output.find(line) != std::string::npos, (line + listed.output).c_str());
        QVERIFY(listed.output.find("CHAPTER002NAME") == std::string::npos);
    }

    void what_metaflac_writes_is_read() {
        if (!has_program("metaflac"))
            QSKIP("flac is not installed");
        const fs::path flac = recorded(root_, {}, noise(1'000));
        QCOMPARE(run("metaflac", {"--remove-all-tags", "--no-utf8-convert", "--set-tag=kind=place",
                                  "--set-tag=Person=Am See", "--set-tag=ALBUM=Familie",
                                  "--set-tag=artist=Oma", "--add-padding=4000", QString::fromStdString(flac)})
                     .status,
                 0);
        const auto says = about_recording(flac);
        QVERIFY(says.ok());
        QVERIFY(says->notes.label.kind == RecordingKind::place);
        QCOMPARE(says->notes.label.person, std::string("Am See"));
        QCOMPARE(says->notes.label.speaker, std::string("Oma"));
    }

    void relabelling_leaves_the_sound_and_foreign_comments() {
        const auto sound = noise(50'000);
        const fs::path flac = recorded(root_, notes_of_anna(), sound);
        const auto comments_in = [&] { return flac_head(**FileBytes::open(flac))->comments; };
        {
            const auto bytes = FileBytes::open(flac);
            VorbisComments comments = comments_in();
            comments.fields.push_back({"ALBUM", "Familie"});
            QCOMPARE(store_flac_copy(**bytes, comments, root_ / "b.flac"), std::string());
            fs::rename(root_ / "b.flac", flac);
        }
        RecordingNotes notes;
        notes.label.kind = RecordingKind::ambient;
        QCOMPARE(relabel_recording(flac, notes), std::string());
        QVERIFY(about_recording(flac)->notes == notes);
        QCOMPARE(comments_in().value("album").value_or(""), std::string("Familie"));
        QVERIFY(!comments_in().value("TRANSCRIPT"));
        QVERIFY(samples_of(flac) == widened(sound));
        QCOMPARE(names_in(root_), flac.filename().string());
        if (has_program("flac"))
            QCOMPARE(run("flac", {"-t", "-s", QString::fromStdString(flac)}).status, 0);
    }

    void relabelling_that_is_stopped_leaves_the_recording_as_it_was() {
        const fs::path flac = recorded(root_, notes_of_anna(), noise(50'000));
        const std::string before = bytes_of(flac);
        RecordingNotes notes;
        notes.label.kind = RecordingKind::ambient;
        std::stop_source person;
        person.request_stop();
        QCOMPARE(relabel_recording(flac, notes, person.get_token()), std::string("it was stopped."));
        QCOMPARE(bytes_of(flac), before);
        QCOMPARE(names_in(root_), flac.filename().string());
    }

    void nothing_recorded_leaves_nothing() {
        auto part = start_recording(root_, {});
        QVERIFY(part.ok());
        const auto flac = finish_recording(std::move(*part), {});
        QVERIFY(flac.ok() && !*flac);
        QCOMPARE(names_in(root_), std::string());
    }

    void names_are_made_unique() {
        RecordingNotes notes;
        notes.label.recorded = "2026-05-01T10:15:00+02:00";
        fs::create_symlink("nowhere", root_ / "2026-05-01T101500-memo.flac");
        auto first = start_recording(root_, notes);
        auto second = start_recording(root_, notes);
        QVERIFY(first.ok() && second.ok());
        QCOMPARE(second->place().filename().string(), std::string("2026-05-01T101500-memo-2.wav.part"));
        QCOMPARE(first->append(noise(10)), std::string());
        QCOMPARE(second->append(noise(20)), std::string());
        const auto a = finish_recording(std::move(*first), notes);
        const auto b = finish_recording(std::move(*second), notes);
        QVERIFY(a.ok() && b.ok());
        QCOMPARE((*a)->filename().string(), std::string("2026-05-01T101500-memo-2.flac"));
        QCOMPARE((*b)->filename().string(), std::string("2026-05-01T101500-memo-2-2.flac"));
        QCOMPARE(samples_of(**a).size(), std::size_t{10});
        QCOMPARE(samples_of(**b).size(), std::size_t{20});
    }

    void a_name_that_is_taken_meanwhile_is_passed_over() {
        int calls = 0;
        const auto name = under_free_name(root_, "a", ".flac", [&](const fs::path& place) -> std::string {
            if (++calls == 1) {
                write_bytes(place, "another program's");
                return reason_of(EEXIST);
            }
            write_bytes(place, "ours");
            return {};
        });
        QVERIFY(name.ok());
        QCOMPARE(name->filename().string(), std::string("a-2.flac"));
        QCOMPARE(bytes_of(root_ / "a.flac"), std::string("another program's"));
        const auto refused =
            under_free_name(root_, "b", ".flac", [](const fs::path&) { return "the disk is full."; });
        QCOMPARE(refused.error(), std::string("the disk is full."));
        // one that has its name, but whose folder could not be brought to the disk
        const auto unsure = under_free_name(root_, "c", ".flac", [&](const fs::path& place) -> std::string {
            write_bytes(place, "ours");
            return "the disk reports a fault.";
        });
        QVERIFY(!unsure.ok());
        QVERIFY(!fs::exists(root_ / "c-2.flac"));
    }

    void stems_come_from_the_label() {
        RecordingLabel label;
        QCOMPARE(recording_stem(label), std::string("undated-memo"));
        for (const char* other :
             {"2026-05-01", "2026-05-01 10:15:00", "2026-05-01T10:15", "../../etc/passwd-000000"}) {
            label.recorded = other;
            QCOMPARE(recording_stem(label), std::string("undated-memo"));
        }
        label.recorded = "2026-05-01T10:15:59.5Z";
        label.kind = RecordingKind::ambient;
        QCOMPARE(recording_stem(label), std::string("2026-05-01T101559-ambient"));
    }

    void a_disk_that_fills_up_keeps_the_part() {
        const auto sound = noise(100'000);
        auto part = start_recording(root_, notes_of_anna());
        QVERIFY(part.ok());
        QCOMPARE(part->append(sound), std::string());
        const fs::path place = part->place();
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 50'000, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto flac = finish_recording(std::move(*part), notes_of_anna());
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY(!flac.ok());
        QVERIFY2(flac.error().ends_with('.') && flac.error().find("FLAC") == std::string::npos,
                 flac.error().c_str());
        QCOMPARE(names_in(root_), place.filename().string());
        const auto lock = PartLock::take(place);
        const auto again = finish_part(place, **lock, std::nullopt);
        QVERIFY2(again.ok(), again.error().c_str());
        QVERIFY(samples_of(**again) == widened(sound));
        QVERIFY(about_recording(**again)->notes == notes_of_anna());
    }

    void a_folder_that_may_not_be_written_to() {
        const auto open_to_all = fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec;
        fs::permissions(root_.parent_path(), open_to_all);
        fs::permissions(root_, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                   fs::perms::others_exec);
        constexpr uid_t nobody = 65534; // root may write everywhere
        const uid_t user = ::geteuid();
        if (user == 0)
            QCOMPARE(::seteuid(nobody), 0);
        const auto part = start_recording(root_, {});
        QCOMPARE(::seteuid(user), 0);
        fs::permissions(root_, fs::perms::owner_all);
        QVERIFY2(part.error().find("not allowed") != std::string::npos, part.error().c_str());
        QCOMPARE(names_in(root_), std::string());
    }

    void what_is_no_recording_is_refused() {
        write_bytes(root_ / "text", "Dear Anna,");
        write_bytes(root_ / "empty", "");
        for (const char* name : {"text", "empty", "missing", ""}) {
            const auto about = about_recording(root_ / name);
            QVERIFY2(about.error().ends_with('.'), name);
            QVERIFY2(relabel_recording(root_ / name, {}).ends_with('.'), name);
        }
        QCOMPARE(bytes_of(root_ / "text"), std::string("Dear Anna,"));
    }
};

} // namespace recording_file_test

TP_TEST(recording_file_test, RecordingFileTest, event_loop)
#include "recording_file_test.moc"
