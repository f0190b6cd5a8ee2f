// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_queries.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/cli/album/album_index_words.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/file_words.hpp"

#include <array>
#include <cstdio>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_people = 100'000, most_photos = 10'000'000;

fs::path first_path(const VerbLine& line) { return path_given(line.arguments().first()); }

int person_list(const QStringList& words) {
    VerbLine line("album person list", "The people of an album, with how many photographs show each.");
    add_index_options(line)
        .option("json", "One JSON object per line.")
        .argument("ALBUM", "The album's folder.");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    auto index = filled_index(line, {first_path(line)});
    if (!index)
        return refused(index.error());
    const auto people = AlbumQueries(*index).topics("person", "", most_people);
    if (!people)
        return refused(people.error());
    AlbumKeeper keeper(first_path(line));
    const NameLanguages languages(keeper);
    for (const TopicEntry& person : *people) {
        const auto spoken = keeper.name_recording(person.name);
        const auto language = languages.of(person.name);
        if (!language)
            print_to(stderr, "%s\n", language.error().c_str());
        const std::string tag = language ? *language : std::string{};
        if (line.has("json"))
            print_json(
                {{"person", json_text(person.name)},
                 {"photos", static_cast<qint64>(person.photos)},
                 {"recording", spoken ? QJsonValue(path_text(*spoken)) : QJsonValue(QJsonValue::Null)},
                 {"language", tag.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(json_text(tag))}});
        else
            print("%s\t%zu%s%s\n", readable(person.name).c_str(), person.photos,
                  spoken ? "\tname recorded" : "", tag.empty() ? "" : ("\tread as " + tag).c_str());
    }
    return exit_done;
}

int person_rename(const QStringList& words) {
    VerbLine line("album person rename", "Gives a person another name on every photograph of an album, or "
                                         "only on those that are named. Where\n"
                                         "somebody has that name already, the two become one; to take two "
                                         "people apart, name the photographs.");
    add_index_options(line)
        .argument("ALBUM", "The album's folder.")
        .argument("FROM", "The present name.")
        .argument("TO", "The new one.")
        .argument("PHOTO", "Only these photographs.", "[PHOTO...]");
    if (const auto over = line.parse(words, 3, 100'000))
        return *over;
    const std::string from = line.arguments()[1].toStdString(), to = line.arguments()[2].toStdString();
    std::vector<fs::path> photos;
    for (const QString& word : line.arguments().mid(3))
        photos.push_back(path_given(word));
    const bool everywhere = photos.empty();
    if (everywhere) {
        auto index = scanned_index(line, {first_path(line)});
        if (!index)
            return refused(index.error());
        const auto found = AlbumQueries(*index).page(OfTopic{"person", from}, std::nullopt, most_photos);
        if (!found)
            return refused(found.error());
        for (const PhotoEntry& entry : *found)
            photos.push_back(entry.path);
    }
    LongWork::step("writing the name into " + std::to_string(photos.size()) + " photographs");
    AlbumKeeper keeper(first_path(line));
    const auto changed = keeper.rename_person(photos, from, to);
    if (!changed)
        return refused(changed.error());
    if (everywhere) {
        std::string problem = keeper.rename_name_recording(from, to);
        if (problem.empty())
            problem = NameLanguages(keeper).rename(from, to);
        if (!problem.empty())
            return refused(problem);
    }
    print("%zu photographs changed.\n", *changed);
    return *changed > 0 ? exit_done : refused("Nobody named " + quoted(fs::path(from)) + " is on them.");
}

int person_name(const QStringList& words) {
    VerbLine line("album person name", "Names a face on a photograph; without NAME its name is removed.");
    line.option("face", "Centre and size, 0 to 1 of the stored picture from its upper left.",
                "X,Y,WIDTH,HEIGHT")
        .argument("PHOTO", "The photograph.")
        .argument("NAME", "The person.", "[NAME]");
    if (const auto over = line.parse(words, 1, 2))
        return *over;
    const QStringList numbers = line.text("face").split(QLatin1Char(','));
    std::array<double, 4> place{};
    bool well = numbers.size() == 4;
    for (int i = 0; well && i < 4; ++i)
        place[static_cast<std::size_t>(i)] = numbers[i].toDouble(&well);
    if (!well)
        return wrong_usage("album person name", "--face needs four numbers, such as 0.5,0.4,0.2,0.3.");
    const std::string name = line.arguments().value(1).toStdString();
    const std::string problem =
        AlbumKeeper(album_around(first_path(line)))
            .name_face(first_path(line), {place[0], place[1], place[2], place[3], name});
    return problem.empty() ? int{exit_done} : refused(problem);
}

int person_record(const QStringList& words) {
    VerbLine line("album person record", "Saves a recording of how somebody says a person's name.");
    line.option("from", "The sound file.", "FILE")
        .argument("ALBUM", "The album's folder.")
        .argument("NAME", "The person.");
    if (const auto over = line.parse(words, 2, 2))
        return *over;
    if (!line.has("from"))
        return wrong_usage("album person record", "It needs --from FILE.");
    LongWork::step("storing " + quoted(path_given(line.text("from")).filename()));
    const std::string problem =
        AlbumKeeper(first_path(line))
            .keep_name_recording(line.arguments()[1].toStdString(), path_given(line.text("from")));
    return problem.empty() ? int{exit_done} : refused(problem);
}

int person_language(const QStringList& words) {
    VerbLine line("album person language",
                  "Shows the language that a person's name is read in, or sets it; \"\" removes it.");
    line.argument("ALBUM", "The album's folder.")
        .argument("NAME", "The person.")
        .argument("TAG", "BCP 47, such as fr or pt-BR.", "[TAG]");
    if (const auto over = line.parse(words, 2, 3))
        return *over;
    if (std::error_code error; !fs::is_directory(first_path(line), error))
        return refused("There is no folder " + quoted(first_path(line)) + ".");
    AlbumKeeper keeper(first_path(line));
    NameLanguages languages(keeper);
    const std::string person = line.arguments()[1].toStdString();
    if (line.arguments().size() == 3) {
        const std::string problem = languages.choose(person, line.arguments()[2].toStdString());
        return problem.empty() ? int{exit_done} : refused(problem);
    }
    const auto language = languages.of(person);
    if (!language)
        return refused(language.error());
    if (!language->empty())
        print("%s\n", language->c_str());
    return exit_done;
}

} // namespace

int album_person(const QStringList& words) {
    static constexpr std::array<SubVerb, 5> verbs{{
        {"list", "the people of an album", person_list},
        {"rename", "rename a person, or merge two people", person_rename},
        {"name", "name a face", person_name},
        {"record", "save how somebody says a name", person_record},
        {"language", "the language that a name is read in", person_language},
    }};
    return run_sub_verb("album person", verbs, words);
}

} // namespace tp
