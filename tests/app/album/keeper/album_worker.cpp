// SPDX-License-Identifier: Apache-2.0
// A caregiver's afternoon in one process: imports, records, labels, names, deletes, takes back, exports. Says
// TRY before and ACK after each step on stdout, so that whoever kills it knows what was acknowledged.
#include "album_worker.hpp"

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "audio/recordings/recording_file.hpp"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <dlfcn.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace tp::test {

namespace fs = std::filesystem;

namespace {

void tell(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0)
        std::_Exit(3);
}

/// Runs a step; acknowledges it where it says that it is done, and tells so.
template <typename Step>
bool step(const std::string& what, Step work) {
    tell("TRY " + what);
    const std::string problem = work();
    tell(problem.empty() ? "ACK " + what : "SAID " + what + ": " + problem);
    return problem.empty();
}

void record(AlbumKeeper& keeper, const fs::path& photo) {
    tell("TRY record");
    auto part = start_recording(tags_folder(photo), {{RecordingKind::story, "Tom", {}, {}, {}, {}}, {}});
    if (!part)
        return tell("SAID record: " + part.error());
    for (int block = 0; block < 4; ++block) {
        std::vector<std::int16_t> samples(12'000);
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i] = static_cast<std::int16_t>((i * 37 + static_cast<std::size_t>(block) * 991) % 2000);
        if (part->append(samples).empty() && part->sync().empty())
            tell("ACK frames " + std::to_string(part->frames_synced()));
    }
    const auto file = finish_recording(std::move(*part), {{RecordingKind::story, "Tom", {}, {}, {}, {}}, {}});
    if (!file || !*file)
        return tell("SAID record: " + (file ? "nothing" : file.error()));
    const auto tag = keeper.list_recording(photo, (*file)->filename().string());
    tell(tag ? "ACK tag " + tag->file : "SAID record: " + tag.error());
}

} // namespace

void work_on_album(const fs::path& album, const fs::path& card, const fs::path& sound,
                   const fs::path& bundle) {
    AlbumKeeper keeper(album);
    ImportTools tools;
    tools.done = [](const ImportedPhoto& photo) {
        if (photo.fate != ImportedPhoto::Fate::failed)
            tell("ACK photo " + photo.place.filename().string());
    };
    step("import", [&] { return import_photos(album, {}, {card}, tools).error(); });
    const fs::path photo = album / "IMG_1.JPG";
    std::vector<std::string> files;
    for (const char* person : {"Anna", "Tom"}) {
        tell("TRY add");
        const auto added = keeper.add_recording(photo, sound, {RecordingKind::memo, person, {}, {}, {}, {}});
        if (added) {
            files.push_back(added->tag.file);
            tell("ACK tag " + added->tag.file);
        } else {
            tell("SAID add: " + added.error());
        }
    }
    record(keeper, photo);
    if (const auto count = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "tp_count_calls_from_here")))
        count();
    step("face Anna", [&] { return keeper.name_face(photo, {0.5, 0.5, 0.2, 0.3, "Anna"}); });
    step("name Anna", [&] { return keeper.keep_name_recording("Anna", sound); });
    step("name Anna again", [&] { return keeper.keep_name_recording("Anna", sound); });
    step("language fr", [&] { return NameLanguages(keeper).choose("Anna", "fr"); });
    step("language de", [&] { return NameLanguages(keeper).choose("Anna", "de"); });
    step("text", [&] { return keeper.describe(photo, "x-default", "In the garden", "A long afternoon."); });
    if (!files.empty()) {
        step("label " + files[0], [&] {
            return keeper.label_recording(photo, files[0],
                                          {RecordingKind::memo, "Anna Maria", "Tom", "de", {}, {}});
        });
        step("trim " + files[0], [&] { return keeper.trim_recording(photo, files[0], 0.1, 0.3).error(); });
    }
    if (files.size() > 1 &&
        step("delete " + files[1], [&] { return keeper.delete_recording(photo, files[1]); }))
        step("restore " + files[1], [&] { return keeper.history().undo(); });
    step("bundle", [&] { return write_bundle(bundle, album, {photo}); });
    tell("END");
}

void work_beside(const fs::path& photo, const fs::path& sound) {
    AlbumKeeper keeper(photo.parent_path());
    while (!fs::exists(photo))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    step("face Ben", [&] { return keeper.name_face(photo, {0.2, 0.2, 0.1, 0.1, "Ben"}); });
    step("name Ben", [&] { return keeper.keep_name_recording("Ben", sound); });
    for (;;) {
        tell("TRY add");
        const auto added = keeper.add_recording(photo, sound, {RecordingKind::story, "Ben", {}, {}, {}, {}});
        if (!added) {
            tell("SAID add: " + added.error());
            continue;
        }
        const std::string file = added->tag.file;
        tell("ACK tag " + file);
        step("label " + file, [&] {
            return keeper.label_recording(photo, file, {RecordingKind::memo, "Ben", "Anna", "en", {}, {}});
        });
    }
}

} // namespace tp::test
