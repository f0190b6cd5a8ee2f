// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording_notes.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string_view>

namespace tp {

namespace {

constexpr std::size_t most_chapters = 999; // three digits
constexpr std::string_view chapter_start = "CHAPTER";
constexpr std::array<std::string_view, 6> our_fields{"KIND",     "PERSON", "SPEAKER",
                                                     "LANGUAGE", "DATE",   "TRANSCRIPT"};

std::size_t replacements_in(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("\xEF\xBF\xBD", at)) != std::string_view::npos; at += 3)
        ++count;
    return count;
}

/// The text itself where it is UTF-8; else its readable lines.
std::string as_utf8(const std::string& text) {
    if (replacements_in(readable(text)) == replacements_in(text))
        return text;
    std::string result;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t line = rest.find('\n');
        result += readable(rest.substr(0, line));
        if (line == std::string_view::npos)
            break;
        result += '\n';
        rest.remove_prefix(line + 1);
    }
    return result;
}

/// The number in "CHAPTER012" or "CHAPTER012NAME", and whether it is a name's.
struct ChapterField {
    int number = 0;
    bool names = false;
};
std::optional<ChapterField> chapter_field(std::string_view field) {
    constexpr std::size_t digits = 3;
    const std::size_t plain = chapter_start.size() + digits;
    if (field.size() < plain || !same_field(field.substr(0, chapter_start.size()), chapter_start))
        return std::nullopt;
    ChapterField result;
    const char* const end = field.data() + plain;
    if (std::from_chars(field.data() + chapter_start.size(), end, result.number).ptr != end ||
        result.number < 0)
        return std::nullopt;
    result.names = same_field(field.substr(plain), "NAME");
    if (field.size() > plain && !result.names && !same_field(field.substr(plain), "URL"))
        return std::nullopt;
    return result;
}

/// "HH:MM:SS.mmm" with any number of hours and decimals.
std::optional<double> seconds_in(const std::string& time) {
    unsigned hours = 0;
    unsigned minutes = 0;
    int read = 0;
    if (std::sscanf(time.c_str(), "%3u:%2u:%n", &hours, &minutes, &read) != 2 || read == 0)
        return std::nullopt;
    double seconds = 0;
    const char* const end = time.data() + time.size();
    const auto [stop, error] = std::from_chars(time.data() + read, end, seconds, std::chars_format::fixed);
    if (error != std::errc{} || stop != end || !(seconds >= 0.0 && seconds < 60.0) || minutes >= 60)
        return std::nullopt;
    return hours * 3600.0 + minutes * 60.0 + seconds;
}

std::string time_of(double seconds) {
    const auto ms = static_cast<long long>(std::llround(std::clamp(seconds, 0.0, 999.0 * 3600.0) * 1000.0));
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%02lld:%02lld:%02lld.%03lld", ms / 3'600'000, ms / 60'000 % 60,
                  ms / 1000 % 60, ms % 1000);
    return text.data();
}

bool ours(const VorbisComments::Field& field) {
    return chapter_field(field.name) ||
           std::any_of(our_fields.begin(), our_fields.end(),
                       [&](std::string_view name) { return same_field(field.name, name); });
}

} // namespace

RecordingNotes notes_in(const VorbisComments& comments) {
    const auto text = [&](std::string_view name) { return as_utf8(comments.value(name).value_or("")); };
    RecordingNotes notes;
    notes.label.kind = recording_kind(text("KIND")).value_or(RecordingKind::memo);
    notes.label.person = text("PERSON");
    for (const std::string_view name : {"SPEAKER", "ARTIST", "PERFORMER"})
        if (notes.label.speaker.empty())
            notes.label.speaker = text(name);
    notes.label.language = text("LANGUAGE");
    notes.label.recorded = text("DATE");
    notes.label.transcript = text("TRANSCRIPT");
    std::map<int, Chapter> chapters;
    for (const auto& field : comments.fields) {
        const auto chapter = chapter_field(field.name);
        if (chapter && field.name.size() == chapter_start.size() + 3)
            if (const auto begin = seconds_in(field.value))
                chapters[chapter->number].begin_s = *begin;
    }
    for (const auto& field : comments.fields) {
        const auto chapter = chapter_field(field.name);
        if (const auto at = chapter && chapter->names ? chapters.find(chapter->number) : chapters.end();
            at != chapters.end())
            at->second.name = as_utf8(field.value);
    }
    for (const auto& [number, chapter] : chapters)
        if (notes.chapters.size() < most_chapters)
            notes.chapters.push_back(chapter);
    std::stable_sort(notes.chapters.begin(), notes.chapters.end(),
                     [](const Chapter& a, const Chapter& b) { return a.begin_s < b.begin_s; });
    return notes;
}

void set_notes(VorbisComments& comments, const RecordingNotes& notes) {
    std::erase_if(comments.fields, ours);
    const auto add = [&](std::string name, const std::string& value) {
        if (!value.empty())
            comments.fields.push_back({std::move(name), value});
    };
    add("KIND", std::string(name_of(notes.label.kind)));
    add("PERSON", notes.label.person);
    add("SPEAKER", notes.label.speaker);
    add("LANGUAGE", notes.label.language);
    add("DATE", notes.label.recorded);
    add("TRANSCRIPT", notes.label.transcript);
    for (std::size_t i = 0; i < std::min(notes.chapters.size(), most_chapters); ++i) {
        std::string number = std::to_string(i + 1);
        number.insert(0, 3 - number.size(), '0');
        add(std::string(chapter_start) + number, time_of(notes.chapters[i].begin_s));
        add(std::string(chapter_start) + number + "NAME", notes.chapters[i].name);
    }
}

std::vector<Chapter> chapters_between(const std::vector<Chapter>& chapters, double begin_s, double end_s) {
    std::vector<Chapter> result;
    for (const Chapter& chapter : chapters) {
        if (chapter.begin_s >= end_s)
            continue;
        if (chapter.begin_s <= begin_s)
            result.clear(); // an earlier one that is over when the piece begins
        result.push_back({std::max(0.0, chapter.begin_s - begin_s), chapter.name});
    }
    return result;
}

} // namespace tp
