// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/terminal.hpp"
#include "app/photo/sight/photo_look.hpp"
#include "app/photo/words/description.hpp"
#include "core/files/file_words.hpp"

#include <cstdio>

namespace tp {

namespace {

void print_line_of(const char* what, const std::string& text) {
    if (!text.empty())
        print("%-12s %s\n", what, readable(text).c_str());
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words)
        all += (all.empty() ? "" : ", ") + word;
    return all;
}

void print_for_a_person(const PhotoRecord& record) {
    print_line_of("taken", record.taken);
    print_line_of("place", record.place_name);
    if (record.place)
        print("%-12s %.5f, %.5f\n", "", record.place->latitude, record.place->longitude);
    print_line_of("persons", joined(record.persons));
    print_line_of("keywords", joined(record.keywords));
    for (const auto& [language, text] : record.alt_text)
        print_line_of("alt text", text);
    for (const auto& [language, text] : record.description)
        print_line_of("description", text);
    for (const FaceRegion& face : record.faces)
        print("%-12s %s at %.3f, %.3f\n", "face",
              face.name.empty() ? "of nobody named" : readable(face.name).c_str(), face.x, face.y);
    for (const Tag& tag : record.tags) {
        const auto kind = name_of(tag.label.kind);
        print("%-12s %.*s, %.1f s, %s%s%s\n", "recording", static_cast<int>(kind.size()), kind.data(),
              tag.duration_s, readable(tag.file).c_str(), tag.label.speaker.empty() ? "" : ", spoken by ",
              readable(tag.label.speaker).c_str());
    }
}

/// What is on it, in each language.
QJsonObject in_words(const SeenPhoto& seen, const PhotoRecord& record) {
    QJsonObject words;
    for (const QLocale::Language language : {QLocale::English, QLocale::German, QLocale::Korean}) {
        const PhotoView view = view_of(seen, record, language);
        words[QLocale::languageToCode(language)] = QJsonObject{{"short", short_description(view, language)},
                                                               {"full", full_description(view, language)}};
    }
    return words;
}

} // namespace

int album_show(const QStringList& words) {
    VerbLine line("album show", "Everything that is known of a photograph, from its metadata and its "
                                "sidecars, and what is seen on it, in words.");
    line.option("json", "One JSON object on stdout.").argument("PHOTO", "The photograph.");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    const auto photo = path_given(line.arguments().first());
    const auto record = read_record(photo);
    if (!record)
        return refused(record.error());
    const SeenPhoto seen = photo_look()(photo, Marks::no, {}).seen;
    if (line.has("json")) {
        QJsonObject known = to_json(photo, *record);
        known["seen"] = seen.width > 0 ? QJsonValue(to_json(seen)) : QJsonValue(QJsonValue::Null);
        known["words"] = in_words(seen, *record);
        print_json(known);
    } else {
        print_for_a_person(*record);
        print_line_of(
            "in words",
            full_description(view_of(seen, *record, QLocale::English), QLocale::English).toStdString());
    }
    for (const std::string& problem : record->problems)
        say_problem(problem);
    return record->problems.empty() ? exit_done : exit_bad_input;
}

} // namespace tp
