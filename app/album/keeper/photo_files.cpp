// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/photo_files.hpp"

#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/file_words.hpp"

#include <QCryptographicHash>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

bool is_xmp(std::string extension) {
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".xmp";
}

bool shares_its_stem(const fs::path& photo) {
    std::error_code error;
    for (const auto& other : fs::directory_iterator(photo.parent_path(), error))
        if (other.path() != photo && other.path().stem() == photo.stem() && has_photo_name(other.path()))
            return true;
    return false;
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

std::vector<Companion> companions_of(const fs::path& photo) {
    std::vector<Companion> found;
    const std::string name = photo.filename().string();
    std::error_code error;
    for (const auto& file :
         fs::directory_iterator(photo.parent_path().empty() ? "." : photo.parent_path(), error)) {
        const std::string other = file.path().filename().string();
        const fs::path place = photo.parent_path() / other;
        if (other.starts_with(name)) {
            const std::string suffix = other.substr(name.size());
            const auto original = conflict_original(other); // another machine's sidecar, not merged yet
            const bool is_conflict =
                original && original->starts_with(name) && is_xmp(original->substr(name.size()));
            if (is_xmp(suffix) || is_conflict || place == contours_file(photo) || place == tags_folder(photo))
                found.push_back({place, suffix, false});
        } else if (is_xmp(place.extension().string()) && place.stem() == photo.stem() &&
                   !shares_its_stem(photo)) {
            found.push_back({place, place.extension().string(), true});
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Companion& a, const Companion& b) { return a.file < b.file; });
    return found;
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
