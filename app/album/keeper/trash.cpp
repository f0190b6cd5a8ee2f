// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/trash.hpp"

#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/whole_file.hpp"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cerrno>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_list_bytes = 16 << 20;
constexpr const char* list_name = "list.json";

QByteArray list_of(const TrashEntry& entry) {
    QJsonArray files;
    for (const fs::path& file : entry.files)
        files.append(path_text(file));
    return QJsonDocument(QJsonObject{{"what", QString::fromStdString(entry.what)},
                                     {"note", QString::fromStdString(entry.note)},
                                     {"deleted", QString::fromStdString(entry.deleted)},
                                     {"files", files}})
        .toJson();
}

/// A folder of its own in the trash, called by the time; by the next millisecond's where that is taken, so that the
/// names are in the order of what was deleted.
Result<std::string> new_folder(const fs::path& trash, QDateTime time) {
    if (const std::string reason = make_folder(trash, Readers::owner_only); !reason.empty())
        return Error{"Nothing was deleted, because the trash cannot be created: " + reason};
    for (;; time = time.addMSecs(1)) {
        const std::string id = time.toString(QStringLiteral("yyyy-MM-ddThhmmss.zzz")).toStdString();
        const int error = make_directory(trash / id, Readers::owner_only);
        if (error == 0)
            return id;
        if (error != EEXIST)
            return Error{"Nothing was deleted, because the trash cannot be written to: " + reason_of(error)};
    }
}

/// Makes the folder that something goes back to; recordings lie where only their owner may look.
std::string make_folder_again(const fs::path& folder) {
    if (folder.extension() != ".tags" && std::none_of(folder.begin(), folder.end(), is_own_folder))
        return make_folder(folder);
    const std::string reason = make_folder_again(folder.parent_path());
    return reason.empty() ? make_folder(folder, Readers::owner_only) : reason;
}

/// Whether a deletion's folder holds at most what its program left before it moved anything in, or after all was back.
bool is_without_files(const fs::path& folder, bool with_list) {
    int error = 0;
    const std::vector<FolderEntry> files = entries_of(folder, &error);
    return error == 0 && std::all_of(files.begin(), files.end(), [&](const FolderEntry& file) {
               return is_temporary(file.name) || (with_list && file.name == list_name);
           });
}

} // namespace

fs::path Trash::kept(const std::string& id, std::size_t number) const {
    return folder() / id / std::to_string(number);
}

Result<std::string> Trash::put(const std::vector<fs::path>& files, const std::string& what,
                               const std::string& note) {
    const ForeignFolder held(album_);
    TrashEntry entry;
    entry.what = what;
    entry.note = note;
    for (const fs::path& file : files) {
        const fs::path below = file.is_absolute() ? file.lexically_relative(album_) : file.lexically_normal();
        if (!stays_below(below))
            return Error{quoted(file) + " was not deleted, because it is not in the album " + quoted(album_) +
                         "."};
        if (const auto link = link_on_the_way(album_ / below))
            return Error{left_alone(*link)};
        if (!name_taken(album_ / below))
            return Error{is_disks_fault(errno)
                             ? "The file " + quoted(file) + " cannot be read: " + reason_of(errno)
                             : "There is no file " + quoted(file) + "."};
        entry.files.push_back(below);
    }
    if (entry.files.empty())
        return Error{"Nothing was named that could be deleted."};
    const QDateTime now = QDateTime::currentDateTimeUtc();
    entry.deleted = now.toString(Qt::ISODate).toStdString();
    const auto id = new_folder(folder(), now);
    if (!id)
        return id;
    entry.id = *id;
    const auto list = list_of(entry);
    std::string reason =
        replace_file(folder() / *id / list_name, {list.data(), static_cast<std::size_t>(list.size())},
                     Readers::owner_only);
    for (std::size_t i = 0; i < entry.files.size() && reason.empty(); ++i)
        reason = move_file(album_ / entry.files[i], kept(*id, i));
    if (reason.empty())
        return id;
    if (const std::string stuck = move_back(entry); !stuck.empty())
        return Error{stuck};
    erase(*id);
    return Error{"Nothing was deleted: " + reason};
}

std::string Trash::move_back(const TrashEntry& entry) const {
    for (std::size_t i = 0; i < entry.files.size(); ++i) {
        if (is_gone(kept(entry.id, i)))
            continue;
        const fs::path place = album_ / entry.files[i];
        std::string reason = make_folder_again(place.parent_path());
        if (reason.empty())
            reason = move_file(kept(entry.id, i), place);
        if (!reason.empty())
            return quoted(entry.files[i]) + " cannot be restored and stays in the trash: " + reason;
    }
    return {};
}

std::string Trash::restore(const std::string& id, const fs::path& instead) {
    const ForeignFolder held(album_);
    auto what = entry(id);
    if (!what)
        return what.error();
    if (!instead.empty() && what->files.size() == 1 && stays_below(instead))
        what->files[0] = instead;
    bool any = false;
    for (std::size_t i = 0; i < what->files.size(); ++i) {
        const bool there = !is_gone(kept(id, i));
        any = any || there;
        if (there && name_taken(album_ / what->files[i]))
            return quoted(what->files[i]) +
                   " cannot be restored, because another file has its place now. Move that one away first.";
    }
    for (const fs::path& file : what->files)
        if (!any && is_gone(album_ / file))
            return quoted(file) + " is not in the trash any more.";
    if (std::string stuck = move_back(*what); !stuck.empty())
        return stuck;
    static_cast<void>(erase(id)); // a list that stays, without files, is passed over
    return {};
}

std::string Trash::erase(const std::string& id) {
    const ForeignFolder held(album_);
    if (!stays_below(id) || id.find('/') != std::string::npos || !name_taken(folder() / id))
        return "There is nothing of the name " + quoted(fs::path(id)) + " in the trash.";
    if (link_there(folder() / id))
        return left_alone(folder() / id);
    // The list goes last, so that what a power cut leaves is still known to be in the trash.
    std::string reason;
    int error = 0;
    for (const FolderEntry& file : entries_of(folder() / id, &error))
        if (file.name != list_name)
            if (std::string left = remove_tree(folder() / id / file.name); reason.empty())
                reason = left;
    if (reason.empty() && error != 0)
        reason = reason_of(error);
    if (reason.empty())
        reason = remove_tree(folder() / id);
    return reason.empty() ? reason : "The trash could not be emptied: " + reason;
}

std::string Trash::empty() {
    const ForeignFolder held(album_);
    if (const auto link = link_on_the_way(folder()))
        return left_alone(*link);
    std::vector<std::string> unread;
    std::string first;
    for (const TrashEntry& entry : entries(&unread))
        if (std::string problem = erase(entry.id); first.empty())
            first = problem;
    for (const FolderEntry& place : entries_of(folder()))
        if (!place.link && is_without_files(folder() / place.name, true)) // its list names what was deleted
            static_cast<void>(erase(place.name));
    return first.empty() && !unread.empty() ? unread.front() : first;
}

Result<TrashEntry> Trash::entry(const std::string& id) const {
    const ForeignFolder held(album_);
    if (!stays_below(id) || id.find('/') != std::string::npos)
        return Error{"There is nothing of the name " + quoted(fs::path(id)) + " in the trash."};
    const auto bytes = read_whole(folder() / id / list_name, most_list_bytes);
    const Error unreadable{"The list of what was deleted in " + quoted(folder() / id) +
                           " cannot be read; its files are still there."};
    if (!bytes)
        return name_taken(folder() / id)
                   ? unreadable
                   : Error{"There is nothing of the name " + quoted(fs::path(id)) + " in the trash."};
    const QJsonObject list = QJsonDocument::fromJson(QByteArray::fromStdString(*bytes)).object();
    TrashEntry entry{id,
                     list["what"].toString().toStdString(),
                     list["deleted"].toString().toStdString(),
                     {},
                     list["note"].toString().toStdString()};
    for (const QJsonValue& file : list["files"].toArray()) {
        const auto path = path_of(file.toString());
        if (!path || !stays_below(*path))
            return unreadable;
        entry.files.push_back(*path);
    }
    return entry.files.empty() ? Result<TrashEntry>(unreadable) : Result<TrashEntry>(entry);
}

std::vector<TrashEntry> Trash::entries(std::vector<std::string>* problems) const {
    const ForeignFolder held(album_);
    std::vector<TrashEntry> found;
    if (const auto link = link_on_the_way(folder()); link && problems)
        problems->push_back(left_alone(*link));
    int error = 0;
    const std::vector<FolderEntry> places = entries_of(folder(), &error);
    if (error != 0 && error != ENOENT && problems && !link_on_the_way(folder()))
        problems->push_back("The trash " + quoted(folder()) + " cannot be read: " + reason_of(error));
    for (const FolderEntry& place : places) {
        if (place.link) {
            if (problems)
                problems->push_back(left_alone(folder() / place.name));
            continue;
        }
        if (place.facts.kind != FileFacts::Kind::folder || is_without_files(folder() / place.name, false))
            continue;
        auto what = entry(place.name);
        if (what && is_without_files(folder() / place.name, true))
            continue;
        if (what)
            found.push_back(*std::move(what));
        else if (problems)
            problems->push_back(what.error());
    }
    std::sort(found.begin(), found.end(),
              [](const TrashEntry& a, const TrashEntry& b) { return a.id > b.id; });
    return found;
}

std::vector<fs::path> Trash::files_in(const std::string& id) const {
    std::vector<fs::path> files;
    if (const auto what = entry(id))
        for (std::size_t i = 0; i < what->files.size(); ++i)
            if (name_taken(kept(id, i)) && !link_there(kept(id, i)))
                files.push_back(kept(id, i));
    return files;
}

} // namespace tp
