// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/camera_sound.hpp"

#include "core/files/durable_file.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
}

} // namespace

CameraSounds::CameraSounds(const fs::path& folder, const std::vector<std::string>& ends) {
    for (const FolderEntry& entry : entries_of(folder)) {
        const fs::path name = entry.name;
        if (!entry.link && entry.facts.kind == FileFacts::Kind::file &&
            std::find(ends.begin(), ends.end(), lower(name.extension().string())) != ends.end())
            sounds_.emplace(lower(name.stem().string()), folder / name);
    }
}

std::optional<fs::path> CameraSounds::of(const fs::path& photo) const {
    const auto [begin, end] = sounds_.equal_range(lower(photo.stem().string()));
    std::optional<fs::path> best;
    const auto rank = [&](const fs::path& sound) { return std::pair(sound.stem() != photo.stem(), sound); };
    for (auto sound = begin; sound != end; ++sound)
        if (sound->second.filename() != photo.filename() && (!best || rank(sound->second) < rank(*best)))
            best = sound->second;
    return best;
}

std::optional<fs::path> sound_beside(const fs::path& photo) {
    return CameraSounds(photo.parent_path()).of(photo);
}

std::optional<fs::path> video_beside(const fs::path& photo) {
    return CameraSounds(photo.parent_path(), {".mov", ".mp4"}).of(photo);
}

} // namespace tp
