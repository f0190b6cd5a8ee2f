// SPDX-License-Identifier: Apache-2.0
#include "core/files/foreign_folder.hpp"

#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/new_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <mutex>
#include <string_view>
#include <system_error>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::string with_slash(const std::string& folder) {
    const char slash = static_cast<char>(fs::path::preferred_separator);
    return folder.ends_with(slash) ? folder : folder + slash;
}

/// Whether `below` a person's home, or a folder above it, lies in a hidden folder, where programs keep what is theirs.
bool is_programs_own(const fs::path& folder, const std::string& below) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing in the program changes its environment while threads run
    const char* const home = std::getenv("HOME");
    if (!below.starts_with('.') || below.starts_with(".touchphoto") || home == nullptr || *home == '\0')
        return false;
    const fs::path own = fs::path(home).lexically_normal();
    return std::mismatch(folder.begin(), folder.end(), own.begin(), own.end()).first == folder.end();
}

/// The folders that are held as foreign now; one that is held twice is there twice.
class Held {
public:
    /// Never destroyed: folders are held until the very end.
    static Held& all() {
        static Held& held = *new Held;
        return held;
    }
    /// But not the whole computer, which is nobody else's: programs and their files lie in it.
    void add(const fs::path& folder) {
        const std::lock_guard lock(mutex_);
        if (folder.has_relative_path())
            folders_.push_back(folder);
    }
    void drop(const fs::path& folder) {
        const std::lock_guard lock(mutex_);
        if (const auto one = std::find(folders_.begin(), folders_.end(), folder); one != folders_.end())
            folders_.erase(one);
    }
    /// The innermost that `file` lies below: its own folder was named, by whatever way.
    std::optional<ForeignPlace> around(const fs::path& file) {
        const std::string text = file.string();
        const std::lock_guard lock(mutex_);
        const fs::path* found = nullptr;
        for (const fs::path& folder : folders_) {
            if (found != nullptr && folder.native().size() <= found->native().size())
                continue;
            const std::string above = with_slash(folder.string());
            if (text.size() > above.size() && text.starts_with(above) &&
                !is_programs_own(folder, text.substr(above.size())))
                found = &folder;
        }
        if (found == nullptr)
            return std::nullopt;
        return ForeignPlace{*found, fs::path(text.substr(with_slash(found->string()).size()))};
    }
    bool none() {
        const std::lock_guard lock(mutex_);
        return folders_.empty();
    }

private:
    std::mutex mutex_;
    std::vector<fs::path> folders_;
};

fs::path without_slash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

/// Absolute, without dots, doubled slashes or one at its end.
fs::path plain(const fs::path& path) {
    const std::string text = path.string();
    const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
    if (text.starts_with('/') && !has("//") && !has("/./") && !has("/../") && !text.ends_with("/.") &&
        !text.ends_with("/..") && !text.ends_with('/'))
        return path;
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    return whole.has_relative_path() ? without_slash(whole) : whole;
}

bool ends_in(std::string_view name, std::string_view end) {
    return name.size() > end.size() &&
           std::equal(end.begin(), end.end(), name.end() - static_cast<std::ptrdiff_t>(end.size()),
                      [](char a, char b) {
                          return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b);
                      });
}

/// The names of folders that belong to an album or a photograph.
bool is_own_folder_name(const std::string& name) { return name == ".touchphoto" || name.ends_with(".tags"); }

/// The names of files that do.
bool is_own_file_name(const fs::path& name) {
    const std::string text = name.string();
    return ends_in(text, ".xmp") || (ends_in(text, ".svg") && text.find(".contours") != std::string::npos) ||
           is_temporary(name);
}

/// By its names alone: from the folder that an album's or a photograph's own things lie in.
std::optional<ForeignPlace> own_place(const fs::path& file) {
    fs::path folder;
    for (auto name = file.begin(); name != file.end(); ++name) {
        const bool last = std::next(name) == file.end();
        if (is_own_folder_name(name->string()) || (last && is_own_file_name(*name))) {
            fs::path below;
            for (; name != file.end(); ++name)
                below /= *name;
            return ForeignPlace{folder.empty() ? fs::path(".") : folder, std::move(below)};
        }
        folder /= *name;
    }
    return std::nullopt;
}

} // namespace

ForeignFolder::ForeignFolder(const fs::path& folder) : folder_(plain(folder)) { Held::all().add(folder_); }
ForeignFolder::ForeignFolder(const ForeignFolder& other) : folder_(other.folder_) {
    Held::all().add(folder_);
}
ForeignFolder::~ForeignFolder() { Held::all().drop(folder_); }

std::optional<ForeignPlace> foreign_place(const fs::path& file) {
    if (file.empty())
        return std::nullopt;
    if (!Held::all().none())
        if (auto place = Held::all().around(plain(file)))
            return place;
    return own_place(without_slash(file.lexically_normal()));
}

std::optional<fs::path> link_on_the_way(const fs::path& file) {
    const auto place = foreign_place(file);
    if (!place)
        return std::nullopt;
    fs::path here = place->folder == "." ? fs::path() : place->folder;
    for (const fs::path& name : place->below) {
        here /= name;
        const auto facts = facts_of_name(here);
        if (!facts)
            break;
        if (facts->kind == FileFacts::Kind::link)
            return here;
    }
    return std::nullopt;
}

std::string left_alone(const fs::path& link) { return quoted(link) + " is a link; it is left alone."; }

} // namespace tp
