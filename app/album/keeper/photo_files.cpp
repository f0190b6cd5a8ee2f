// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/photo_files.hpp"

#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/file_words.hpp"
#include "core/files/photo_endings.hpp"

#include <QCryptographicHash>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// `other` is the name or the stem and then .xmp, in capitals or not.
bool is_sidecar_of(const std::string& name, const std::string& other) {
    return other.size() == name.size() + 4 && other.starts_with(name) && small_ending(other) == ".xmp";
}

using Names = std::span<const std::string>; ///< in order

/// Those that begin so.
Names beginning_with(Names names, const std::string& beginning) {
    const auto first = std::lower_bound(names.begin(), names.end(), beginning);
    const auto last = std::find_if_not(first, names.end(),
                                       [&](const std::string& name) { return name.starts_with(beginning); });
    return {first, last};
}

/// Whether what is named by this photograph's stem may be another one's: of its stem, or of the stem as its
/// name.
bool shares_its_stem(Names names, const fs::path& photo) {
    if (std::binary_search(names.begin(), names.end(), photo.stem().string()))
        return true;
    const Names alike = beginning_with(names, photo.stem().string() + '.');
    return std::any_of(alike.begin(), alike.end(), [&](const fs::path& other) {
        return other != photo.filename() && other.stem() == photo.stem() && has_photo_name(other);
    });
}

} // namespace

fs::path tags_folder(const fs::path& photo) { return fs::path(photo) += ".tags"; }
fs::path contours_file(const fs::path& photo) { return fs::path(photo) += ".contours.svg"; }

bool is_own_folder(const fs::path& folder) { return folder.filename() == ".touchphoto"; }

fs::path album_around(const fs::path& photo) {
    std::error_code error;
    for (fs::path folder = photo.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        if (fs::is_directory(folder / ".touchphoto", error))
            return folder;
    return photo.parent_path();
}

std::vector<Companion> companions_of(const fs::path& photo) { return FolderCompanions().of(photo); }

void FolderCompanions::read(const fs::path& folder) {
    folder_ = folder;
    names_.clear();
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folder.empty() ? "." : folder, error))
        names_.push_back(file.path().filename().string());
    std::sort(names_.begin(), names_.end());
}

std::vector<Companion> FolderCompanions::of(const fs::path& photo) {
    if (folder_ != photo.parent_path())
        read(photo.parent_path());
    std::vector<Companion> found;
    const std::string name = photo.filename().string();
    for (const std::string& other : beginning_with(names_, name)) {
        const fs::path place = photo.parent_path() / other;
        const std::string suffix = other.substr(name.size());
        const auto original = conflict_original(other); // another machine's sidecar, not merged yet
        if (is_sidecar_of(name, other) || (original && is_sidecar_of(name, *original)) ||
            place == contours_file(photo) || place == tags_folder(photo))
            found.push_back({place, suffix, false});
    }
    for (const std::string& other : beginning_with(names_, photo.stem().string() + '.')) {
        const fs::path place = photo.parent_path() / other;
        if (is_sidecar_of(photo.stem().string(), other) && !other.starts_with(name) &&
            !shares_its_stem(names_, photo))
            found.push_back({place, place.extension().string(), true});
    }
    return found;
}

fs::path numbered(const fs::path& place, int number) {
    if (number == 1)
        return place;
    fs::path name = place.stem();
    name += " (" + std::to_string(number) + ")";
    name += place.extension();
    return place.parent_path() / name;
}

fs::path beside(const fs::path& photo, const Companion& companion) {
    fs::path base = companion.by_stem ? photo.parent_path() / photo.stem() : photo;
    return base += companion.suffix;
}

std::uintmax_t size_or_zero(const fs::path& file) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    return error ? 0 : size;
}

Result<std::string> content_hash(const fs::path& file) {
    std::error_code error;
    std::ifstream stream;
    if (fs::is_regular_file(file, error))
        stream.open(file, std::ios::binary);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    std::array<char, 1 << 16> block{};
    while (stream.is_open() && stream) {
        stream.read(block.data(), block.size());
        hash.addData(QByteArrayView(block.data(), stream.gcount()));
    }
    if (!stream.is_open() || !stream.eof())
        return Error{"The file " + quoted(file) + " cannot be read."};
    return hash.result().toHex().toStdString();
}

} // namespace tp
