// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "audio/recordings/recording_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

namespace tp {

namespace {

void add_label_options(VerbLine& line) {
    line.option("kind", "memo, person, place, story or ambient.", "KIND")
        .option("person", "Who it is about.", "NAME")
        .option("speaker", "Who speaks; separate several by \"; \".", "NAME")
        .option("language", "BCP 47, such as de-AT.", "TAG")
        .option("recorded", "When it was recorded, such as 2026-05-01T10:15:00+02:00.", "TIME")
        .option("transcript", "What is said, in writing.", "TEXT");
}

/// The label with what the options say in place of its own; an error where one makes no sense.
Result<RecordingLabel> labelled(const VerbLine& line, RecordingLabel label) {
    if (line.has("kind")) {
        const auto kind = recording_kind(line.text("kind").toStdString());
        if (!kind)
            return Error{"The kind of a recording is memo, person, place, story or ambient."};
        label.kind = *kind;
    }
    const auto take = [&](const char* option, std::string& text) {
        if (line.has(option))
            text = line.text(option).toStdString();
    };
    take("person", label.person);
    take("speaker", label.speaker);
    take("language", label.language);
    take("recorded", label.recorded);
    take("transcript", label.transcript);
    return label;
}

void print_tag(const Tag& tag, bool json) {
    if (json)
        return print_json(to_json(tag));
    const auto kind = name_of(tag.label.kind);
    print("%s\t%.*s\t%.1f s\t%s\t%s\n", readable(tag.file).c_str(), static_cast<int>(kind.size()),
          kind.data(), tag.duration_s, readable(tag.label.person).c_str(),
          readable(tag.label.speaker).c_str());
}

std::filesystem::path photo_given(const VerbLine& line) { return path_given(line.arguments().first()); }

int ended(const std::string& problem) { return problem.empty() ? int{exit_done} : refused(problem); }

int tag_list(const QStringList& words) {
    VerbLine line("album tag list", "The recordings of a photograph.");
    line.option("json", "One JSON object per line.").argument("PHOTO", "The photograph.");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    const auto record = read_record(photo_given(line));
    if (!record)
        return refused(record.error());
    for (const std::string& problem : record->problems)
        say_problem(problem);
    for (const Tag& tag : record->tags)
        print_tag(tag, line.has("json"));
    return record->problems.empty() ? exit_done : exit_bad_input;
}

int tag_add(const QStringList& words) {
    VerbLine line(
        "album tag add",
        "Adds a sound file to a photograph: it is kept as FLAC beside it and listed in its sidecar. Once\n"
        "this ends with 0, not even a power cut undoes it.");
    line.option("from", "The sound file: WAV, FLAC, Ogg, MP3, AIFF.", "FILE")
        .option("json", "The recording as JSON.");
    add_label_options(line);
    line.argument("PHOTO", "The photograph.");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    if (!line.has("from"))
        return wrong_usage("album tag add", "It needs --from FILE.");
    LongWork::step("storing " + quoted(path_given(line.text("from")).filename()));
    const auto about = about_recording(path_given(line.text("from"))); // what it says of itself, if anything
    const auto label = labelled(line, about ? about->notes.label : RecordingLabel{});
    if (!label)
        return wrong_usage("album tag add", label.error());
    AlbumKeeper keeper(album_around(photo_given(line)));
    const auto tag = keeper.add_recording(photo_given(line), path_given(line.text("from")), *label);
    if (!tag)
        return refused(tag.error());
    print_tag(tag->tag, line.has("json"));
    if (!tag->warning.empty())
        return refused(tag->warning);
    return exit_done;
}

int tag_label(const QStringList& words) {
    VerbLine line("album tag label", "Changes a recording's label; what is not given stays as it is.");
    add_label_options(line);
    line.argument("PHOTO", "The photograph.").argument("RECORDING", "Its file, as \"tag list\" names it.");
    if (const auto over = line.parse(words, 2, 2))
        return *over;
    const std::string file = line.arguments()[1].toStdString();
    LongWork::step("labelling " + file);
    const auto record = read_record(photo_given(line));
    if (!record)
        return refused(record.error());
    const auto listed = std::ranges::find_if(record->tags, [&](const Tag& tag) { return tag.file == file; });
    const bool is_listed = listed != record->tags.end();
    if (!is_listed && !record->problems.empty()) // a list that cannot be read now may be the next moment
        return refused(record->problems.front());
    const RecordingLabel before = is_listed ? listed->label : RecordingLabel{};
    const auto label = labelled(line, before);
    if (!label)
        return wrong_usage("album tag label", label.error());
    return ended(AlbumKeeper(album_around(photo_given(line)))
                     .label_recording(photo_given(line), file, *label, LongWork::stop_token()));
}

int tag_order(const QStringList& words) {
    VerbLine line("album tag order",
                  "Plays a photograph's recordings in this order; the others follow by kind.");
    line.argument("PHOTO", "The photograph.").argument("RECORDING", "Their files, in order.", "RECORDING...");
    if (const auto over = line.parse(words, 1, 1000))
        return *over;
    std::vector<std::string> files;
    for (const QString& word : line.arguments().mid(1))
        files.push_back(word.toStdString());
    return ended(AlbumKeeper(album_around(photo_given(line))).order_recordings(photo_given(line), files));
}

int tag_trim(const QStringList& words) {
    VerbLine line("album tag trim", "Keeps part of a recording; the original goes to the trash.");
    line.option("begin", "Start of the part, in seconds.", "S", "0")
        .option("end", "End of the part, in seconds.", "S")
        .option("json", "The new recording as JSON.")
        .argument("PHOTO", "The photograph.")
        .argument("RECORDING", "Its file, as \"tag list\" names it.");
    if (const auto over = line.parse(words, 2, 2))
        return *over;
    const auto end = line.positive("end");
    bool is_number = false;
    const double begin = line.text("begin").toDouble(&is_number);
    if (!end || !is_number || begin < 0.0)
        return wrong_usage("album tag trim", end ? "--begin must be a number of seconds." : end.error());
    AlbumKeeper keeper(album_around(photo_given(line)));
    LongWork::step("trimming " + line.arguments()[1].toStdString());
    const auto tag = keeper.trim_recording(photo_given(line), line.arguments()[1].toStdString(), begin, *end);
    if (!tag)
        return refused(tag.error());
    print_tag(*tag, line.has("json"));
    say("The original is in the trash of " + quoted(keeper.album()) + ".");
    return exit_done;
}

int tag_delete(const QStringList& words) {
    VerbLine line(
        "album tag delete",
        "Moves a recording to the album's trash: that of the nearest folder above it that has one,\n"
        "else of the photograph's own folder. It says which, and \"trash restore\" brings it back.");
    line.argument("PHOTO", "The photograph.").argument("RECORDING", "Its file, as \"tag list\" names it.");
    if (const auto over = line.parse(words, 2, 2))
        return *over;
    const auto album = album_around(photo_given(line));
    const std::string problem =
        AlbumKeeper(album).delete_recording(photo_given(line), line.arguments()[1].toStdString());
    if (problem.empty())
        say("It is in the trash of " + quoted(album) + ".");
    return ended(problem);
}

} // namespace

int album_tag(const QStringList& words) {
    static constexpr std::array<SubVerb, 6> verbs{{
        {"add", "add a sound file to a photograph", tag_add},
        {"list", "the recordings of a photograph", tag_list},
        {"label", "change a recording's label", tag_label},
        {"order", "set the order in which recordings are played", tag_order},
        {"trim", "keep part of a recording", tag_trim},
        {"delete", "move a recording to the trash", tag_delete},
    }};
    return run_sub_verb("album tag", verbs, words);
}

} // namespace tp
