// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/import_list.hpp"

#include "app/album/keeper/own_state.hpp"
#include "app/album/keeper/path_text.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/whole_file.hpp"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = 4 << 20; // 40 000 names; read it takes 75 times as much memory
constexpr const char* extension = ".json";

/// Of the lists.
fs::path folder_of(const fs::path& album) { return own_state_of(album) / "imports"; }

fs::path own_part_of(const fs::path& album) { return album / ".touchphoto" / "import"; }

bool is_id(const std::string& id) { return stays_below(id) && id.find('/') == std::string::npos; }

Error unknown(const std::string& id) {
    return Error{"There is no unfinished import " + quoted(fs::path(id)) + "."};
}

} // namespace

fs::path ImportList::place_of(const fs::path& album, const std::string& id) {
    return folder_of(album) / (id + extension);
}

fs::path ImportList::unpacked_in(const fs::path& album, const std::string& id) {
    return own_part_of(album) / id;
}

bool ImportList::makes_sense() const {
    return (into.empty() || stays_below(into)) &&
           std::all_of(sources.begin(), sources.end(),
                       [](const fs::path& source) { return source.is_absolute(); });
}

Result<std::string> ImportList::save(const fs::path& album) const {
    QJsonArray names;
    for (const fs::path& source : sources)
        names.append(path_text(source));
    const QByteArray text =
        QJsonDocument(QJsonObject{{"into", path_text(into)}, {"sources", names}}).toJson();
    if (static_cast<std::size_t>(text.size()) > most_bytes)
        return Error{"That is more than can be imported at once: import the folder that the files are in."};
    if (std::string reason = make_folder(folder_of(album), Readers::owner_only); !reason.empty())
        return Error{reason};
    // Called by the time; by the next millisecond's where that is taken, so that the names are in order.
    for (QDateTime time = QDateTime::currentDateTimeUtc();; time = time.addMSecs(1)) {
        const std::string id = time.toString(QStringLiteral("yyyy-MM-ddThhmmss.zzz")).toStdString();
        auto file = NewFile::beside(place_of(album, id), Readers::owner_only);
        std::string reason =
            file ? file->write({text.data(), static_cast<std::size_t>(text.size())}) : file.error();
        if (reason.empty() && (name_taken(place_of(album, id)) || name_taken(unpacked_in(album, id))))
            continue;
        if (reason.empty())
            reason = file->take_place(Existing::kept);
        return reason.empty() ? Result<std::string>(id) : Error{reason};
    }
}

Result<ImportList> ImportList::read(const fs::path& album, const std::string& id) {
    if (!is_id(id) || !name_taken(place_of(album, id)))
        return unknown(id);
    const auto bytes = read_whole(place_of(album, id), most_bytes);
    if (!bytes)
        return Error{bytes.error()};
    const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(*bytes)).object();
    const Error unreadable{"The list of the import " + quoted(fs::path(id)) +
                           " cannot be read; import its folder again, nothing comes twice."};
    ImportList list;
    const auto into = path_of(object["into"].toString());
    if (!into || !object["sources"].isArray())
        return unreadable;
    list.into = *into;
    for (const QJsonValue& source : object["sources"].toArray()) {
        const auto path = path_of(source.toString());
        if (!path)
            return unreadable;
        list.sources.push_back(*path);
    }
    return list.makes_sense() ? Result<ImportList>(list) : unreadable;
}

std::vector<std::string> ImportList::all(const fs::path& album) {
    std::vector<std::string> ids;
    for (const FolderEntry& file : entries_of(folder_of(album)))
        if (const fs::path name = file.name; name.extension() == extension && !is_temporary(name))
            ids.push_back(name.stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::string ImportList::remove(const fs::path& album, const std::string& id) {
    if (!is_id(id) || !name_taken(place_of(album, id)))
        return unknown(id).sentence;
    const ForeignFolder held(album);
    // First what was unpacked: while the list is there, that is found again.
    if (const std::string stuck = remove_tree(unpacked_in(album, id)); !stuck.empty())
        return "What was unpacked for the import cannot be removed: " + stuck;
    const std::string reason = remove_file(place_of(album, id));
    return reason.empty() ? reason : "The import's list cannot be removed: " + reason;
}

std::vector<fs::path> ImportList::in_album(const fs::path& album) {
    const ForeignFolder held(album);
    std::vector<fs::path> lists;
    if (const auto link = link_on_the_way(own_part_of(album)))
        lists.push_back(*link);
    for (const FolderEntry& file : entries_of(own_part_of(album)))
        if (fs::path(file.name).extension() == extension && !is_temporary(file.name))
            lists.push_back(own_part_of(album) / file.name);
    return lists;
}

} // namespace tp
