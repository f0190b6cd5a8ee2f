// SPDX-License-Identifier: Apache-2.0
#include "app/cli/album/album_json.hpp"

#include "app/album/keeper/path_text.hpp"
#include "app/photo/seen/seen_names.hpp"

#include <QJsonArray>

#include <array>
#include <cstdio>

namespace tp {

namespace {

QJsonObject languages(const LanguageTexts& texts) {
    QJsonObject object;
    for (const auto& [language, text] : texts)
        object[json_text(language)] = json_text(text);
    return object;
}

QString text_of(std::string_view word) {
    return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
}

} // namespace

QString json_text(const std::string& text) { return QString::fromStdString(text); }

QJsonArray json_texts(const std::vector<std::string>& texts) {
    QJsonArray array;
    for (const std::string& text : texts)
        array.append(json_text(text));
    return array;
}

QJsonObject to_json(const Tag& tag) {
    return {{"file", json_text(tag.file)},
            {"kind", text_of(name_of(tag.label.kind))},
            {"person", json_text(tag.label.person)},
            {"speaker", json_text(tag.label.speaker)},
            {"language", json_text(tag.label.language)},
            {"recorded", json_text(tag.label.recorded)},
            {"transcript", json_text(tag.label.transcript)},
            {"duration_s", tag.duration_s},
            {"gain_db", tag.gain_db},
            {"order", tag.order}};
}

QJsonObject to_json(const std::filesystem::path& photo, const PhotoRecord& record) {
    QJsonArray faces, tags;
    for (const FaceRegion& face : record.faces)
        faces.append(QJsonObject{{"x", face.x},
                                 {"y", face.y},
                                 {"width", face.width},
                                 {"height", face.height},
                                 {"name", json_text(face.name)}});
    for (const Tag& tag : record.tags)
        tags.append(to_json(tag));
    QJsonValue place = QJsonValue::Null;
    if (record.place)
        place = QJsonObject{{"latitude", record.place->latitude}, {"longitude", record.place->longitude}};
    return {{"photo", path_text(photo)},
            {"width", static_cast<qint64>(record.width)},
            {"height", static_cast<qint64>(record.height)},
            {"orientation", record.orientation},
            {"taken", json_text(record.taken)},
            {"place", place},
            {"place_name", json_text(record.place_name)},
            {"alt_text", languages(record.alt_text)},
            {"description", languages(record.description)},
            {"faces", faces},
            {"persons", json_texts(record.persons)},
            {"keywords", json_texts(record.keywords)},
            {"tags", tags},
            {"content_hash", json_text(record.content_hash)},
            {"problems", json_texts(record.problems)}};
}

QJsonObject to_json(const SeenPhoto& seen) {
    QJsonArray faces;
    for (const SeenFace& face : seen.faces)
        faces.append(QJsonObject{{"left", face.part.min.x},
                                 {"top", face.part.min.y},
                                 {"right", face.part.max.x},
                                 {"bottom", face.part.max.y},
                                 {"cut_off", face.cut_off},
                                 {"expression", text_of(name_of(face.mien))},
                                 {"eyes", text_of(name_of(face.eyes))},
                                 {"facing", text_of(name_of(face.facing))}});
    return {{"width", seen.width},
            {"height", seen.height},
            {"turned_degrees", seen.turned_degrees},
            {"faces", faces},
            {"nearness", text_of(name_of(nearness_of(seen)))},
            {"light", text_of(name_of(seen.light))},
            {"colours", text_of(name_of(seen.colours))},
            {"blurred", seen.blurred}};
}

QJsonObject to_json(const ImportedPhoto& photo) {
    constexpr std::array names{"imported", "duplicate", "failed"};
    return {
        {"source", path_text(photo.source)},
        {"photo", photo.place.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(path_text(photo.place))},
        {"fate", names[static_cast<std::size_t>(photo.fate)]},
        {"problem",
         photo.problem.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(json_text(photo.problem))},
        {"sound", photo.sound ? QJsonValue(QJsonObject{{"recording", json_text(photo.sound->recording)},
                                                       {"source", text_of(name_of(photo.sound->source))}})
                              : QJsonValue(QJsonValue::Null)},
        {"reply",
         QJsonObject{{"recordings", json_texts(photo.reply.recordings)}, {"words", photo.reply.words}}}};
}

QJsonObject to_json(const Finding& finding) {
    const auto or_null = [](const std::string& text) {
        return text.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(json_text(text));
    };
    return {{"kind", text_of(name_of(finding.kind))},
            {"file", path_text(finding.file)},
            {"sentence", json_text(finding.sentence)},
            {"mend", or_null(finding.mend)},
            {"mended", finding.mended},
            {"problem", or_null(finding.problem)}};
}

QJsonObject to_json(const TrashEntry& entry) {
    QJsonArray files;
    for (const std::filesystem::path& file : entry.files)
        files.append(path_text(file));
    return {{"id", json_text(entry.id)},
            {"what", json_text(entry.what)},
            {"deleted", json_text(entry.deleted)},
            {"files", files}};
}

} // namespace tp
