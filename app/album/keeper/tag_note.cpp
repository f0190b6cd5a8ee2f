// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/tag_note.hpp"

#include "app/album/keeper/path_text.hpp"

#include <QJsonDocument>
#include <QJsonObject>

namespace tp {

namespace {

QJsonValue value(const std::string& text) { return QString::fromStdString(text); }

} // namespace

std::string note_of(const TagNote& note) {
    const RecordingLabel& label = note.tag.label;
    const auto kind = name_of(label.kind);
    return QJsonDocument(QJsonObject{
                             {"photo", path_text(note.photo)},
                             {"file", value(note.tag.file)},
                             {"kind", QString::fromUtf8(kind.data(), static_cast<qsizetype>(kind.size()))},
                             {"person", value(label.person)},
                             {"speaker", value(label.speaker)},
                             {"language", value(label.language)},
                             {"recorded", value(label.recorded)},
                             {"transcript", value(label.transcript)},
                             {"duration_s", note.tag.duration_s},
                             {"gain_db", note.tag.gain_db},
                             {"order", note.tag.order},
                         })
        .toJson(QJsonDocument::Compact)
        .toStdString();
}

std::optional<TagNote> tag_note(const std::string& note) {
    const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(note)).object();
    const auto text = [&](const char* name) { return object[QLatin1String(name)].toString().toStdString(); };
    const auto photo = path_of(object["photo"].toString());
    const auto kind = recording_kind(text("kind"));
    if (!photo || !stays_below(*photo) || !kind || text("file").empty())
        return std::nullopt;
    return TagNote{
        *photo,
        {text("file"),
         {*kind, text("person"), text("speaker"), text("language"), text("recorded"), text("transcript")},
         object["duration_s"].toDouble(),
         object["gain_db"].toDouble(),
         object["order"].toInt()}};
}

} // namespace tp
