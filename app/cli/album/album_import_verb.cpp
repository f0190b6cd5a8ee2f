// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_queries.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/cli/album/album_index_words.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"

#include <algorithm>
#include <cstdio>

namespace tp {

namespace fs = std::filesystem;

namespace {

using Fate = ImportedPhoto::Fate;

void print_photo(const ImportedPhoto& photo, bool json) {
    if (json)
        return print_json(to_json(photo));
    const std::string name = quoted(photo.source.filename());
    if (photo.fate == Fate::imported)
        print("%s is now %s.\n", name.c_str(), quoted(photo.place).c_str());
    else if (photo.fate == Fate::duplicate)
        print("%s is already in the album, as %s.\n", name.c_str(), quoted(photo.place).c_str());
    for (const std::string& recording : photo.reply.recordings)
        print("It brought the recording %s.\n", quoted(fs::path(recording)).c_str());
    if (photo.reply.words)
        print("It brought names or descriptions.\n");
    if (photo.sound)
        print("The sound around it is now its recording %s.\n",
              quoted(fs::path(photo.sound->recording)).c_str());
    std::fflush(stdout);
    if (!photo.problem.empty())
        say_problem(photo.problem);
}

void tell(const ImportProgress& progress) {
    LongWork::item(readable(progress.current.filename().string()), progress.done + 1, progress.total);
}

constexpr const char* stopped = "The import was stopped. Continue it with --continue.";

int ended(const ImportReport& report) {
    if (report.stopped) {
        say(stopped);
        return LongWork::stop_code();
    }
    say(std::to_string(report.count(Fate::imported)) + " imported, " +
        std::to_string(report.count(Fate::duplicate)) + " in the album already, " +
        (report.count_replies() > 0 ? std::to_string(report.count_replies()) + " of them with something new, "
                                    : std::string()) +
        std::to_string(report.count(Fate::failed)) + " not imported.");
    return report.count(Fate::failed) == 0 ? exit_done : exit_bad_input;
}

/// Lists in the album are followed by nobody; a person who expects that hears of them.
void say_lists_in_album(const fs::path& album) {
    for (const fs::path& list : import_lists_in_album(album))
        say_problem(link_there(list) ? left_alone(list) : words_for_list_in_album(list));
}

/// Where an import takes photographs from and brings them, before it goes on.
void say_what_goes_on(const fs::path& album, const std::string& id) {
    const auto import = unfinished_import(album, id);
    if (!import)
        return;
    std::string sources;
    for (const fs::path& source : import->sources)
        (sources += sources.empty() ? "" : ", ") += quoted(source);
    say("Continuing the import of " + sources + " into " + quoted(import->into) + ".");
}

} // namespace

int album_import(const QStringList& words) {
    VerbLine line(
        "album import",
        "Copies photographs into an album: files, folders, a camera's card, .touchphoto bundles, ZIP files.\n"
        "Sidecars, contours and recordings come along; so do a sound of the same name (IMG_1.WAV) and the\n"
        "sound of a motion photo or a Live Photo (IMG_1.MOV), as recordings of what was to be heard. A\n"
        "photograph that is already in the album is not copied again; what its other copy has beside it\n"
        "is added to what is there. The sources are only read. An import that was stopped\n"
        "or killed can be continued with --continue.");
    add_index_options(line)
        .option("into", "A folder of the album; created if it is missing.", "FOLDER")
        .option("continue",
                "Continues unfinished imports that were begun on this computer, and says of what.")
        .option("give-up", "Discards unfinished imports; what they imported stays.")
        .option("json", "One JSON object per photograph, written at once.")
        .argument("ALBUM", "The album's folder.")
        .argument("SOURCE", "What to import.", "[SOURCE...]");
    if (const auto over = line.parse(words, 1, 10'000))
        return *over;
    const fs::path album = path_given(line.arguments().first());
    std::vector<fs::path> sources;
    for (const QString& word : line.arguments().mid(1))
        sources.push_back(path_given(word));
    const bool go_on = line.has("continue"), give_up = line.has("give-up");
    if (sources.empty() != (go_on || give_up) || (go_on && give_up))
        return wrong_usage("album import", "It needs something to import, or --continue, or --give-up.");
    std::error_code error;
    if (!fs::is_directory(album, error))
        return refused("There is no folder " + quoted(album) + ".");
    if (go_on || give_up)
        say_lists_in_album(album);
    if (give_up) {
        for (const std::string& id : unfinished_imports(album))
            if (const std::string problem = give_up_import(album, id); !problem.empty())
                return refused(problem);
        return exit_done;
    }
    auto index = scanned_index(line, {album});
    if (!index)
        return refused(index.error());
    ImportTools tools;
    tools.known = [&](const std::string& hash) {
        const auto found = AlbumQueries(*index).with_content(hash);
        return found && *found ? std::optional((*found)->path) : std::nullopt;
    };
    tools.progress = tell;
    tools.unpacking = [](const fs::path& bundle, double share) {
        LongWork::step("unpacking " + quoted(bundle.filename()));
        LongWork::share(share);
    };
    tools.done = [&](const ImportedPhoto& photo) { print_photo(photo, line.has("json")); };
    tools.stop = LongWork::stop_token();
    const LastWords goes_on([] { say(stopped); });
    if (!go_on) {
        const auto report = import_photos(album, line.text("into").toStdString(), sources, tools);
        return report ? ended(*report) : refused(report.error());
    }
    int result = exit_done;
    for (const std::string& id : unfinished_imports(album)) {
        say_what_goes_on(album, id);
        const auto report = go_on_importing(album, id, tools);
        if (const int end = report ? ended(*report) : refused(report.error()); end != exit_done)
            result = end;
    }
    return result;
}

int album_export(const QStringList& words) {
    VerbLine line("album export", "Writes photographs with everything that belongs to them as one "
                                  ".touchphoto file, which is a ZIP file.");
    line.output("to", "The file to write.", "FILE.touchphoto")
        .argument("ALBUM", "The album's folder.")
        .argument("PHOTO", "Photographs or folders of the album; all if none is given.", "[PHOTO...]");
    if (const auto over = line.parse(words, 1, 10'000))
        return *over;
    if (!line.has("to"))
        return wrong_usage("album export", "It needs --to FILE.touchphoto.");
    const auto bundle = line.output_file(line.text("to"));
    if (!bundle)
        return refused(bundle.error());
    const fs::path album = path_given(line.arguments().first());
    std::vector<fs::path> photos;
    for (const QString& word : line.arguments().mid(1))
        photos.push_back(path_given(word));
    if (photos.empty())
        photos.push_back(album);
    LongWork::step("packing " + quoted(bundle->filename()));
    const auto report = [](std::uintmax_t done, std::uintmax_t all) {
        LongWork::share(static_cast<double>(done) / static_cast<double>(std::max<std::uintmax_t>(all, 1)));
    };
    const ForeignFolder held = held_around(*bundle);
    std::vector<fs::path> left;
    const std::string problem = export_bundle(*bundle, album, photos, report, LongWork::stop_token(), &left);
    for (const fs::path& link : left)
        say_problem(left_alone(link));
    if (LongWork::stop_asked() && !problem.empty())
        return LongWork::stop_code();
    return problem.empty() ? int{exit_done} : refused(problem);
}

} // namespace tp
