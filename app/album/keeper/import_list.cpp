// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/import_list.hpp"

#include "app/album/keeper/path_text.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = 4 << 20; // 40 000 names; read it takes 75 times as much memory
constexpr const char* extension = ".json";

fs::path folder_of(const fs::path& album) { return album / ".touchphoto" / "import"; }

fs::path file_of(const fs::path& album, const std::string& id) { return folder_of(album) / (id + extension); }

bool is_id(const std::string& id) { return stays_below(id) && id.find('/') == std::string::npos; }

Error unknown(const std::string& id) {
    return Error{"There is no unfinished import " + quoted(fs::path(id)) + "."};
}

} // namespace

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
        auto file = NewFile::beside(file_of(album, id), Readers::owner_only);
        std::string reason =
            file ? file->write({text.data(), static_cast<std::size_t>(text.size())}) : file.error();
        std::error_code error;
        if (reason.empty() && fs::exists(file_of(album, id), error))
            continue;
        if (reason.empty())
            reason = file->take_place(Existing::kept);
        return reason.empty() ? Result<std::string>(id) : Error{reason};
    }
}

Result<ImportList> ImportList::read(const fs::path& album, const std::string& id) {
    std::error_code error;
    if (!is_id(id) || !fs::exists(file_of(album, id), error))
        return unknown(id);
    const auto bytes = read_whole(file_of(album, id), most_bytes);
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
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folder_of(album), error))
        if (file.path().extension() == extension && !is_temporary(file.path()))
            ids.push_back(file.path().stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::string ImportList::remove(const fs::path& album, const std::string& id) {
    std::error_code error;
    if (!is_id(id) || !fs::remove(file_of(album, id), error))
        return error ? "The import's list cannot be removed: " + reason_of(error.value())
                     : unknown(id).sentence;
    fs::remove_all(folder_of(album) / id, error); // what was unpacked for it
    return sync_folder(folder_of(album));
}

} // namespace tp
