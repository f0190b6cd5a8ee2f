// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/camera_sound.hpp"

#include <algorithm>
#include <system_error>
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
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        const std::string extension = lower(entry->path().extension().string());
        if (std::find(ends.begin(), ends.end(), extension) != ends.end() && entry->is_regular_file(unknown))
            sounds_.emplace(lower(entry->path().stem().string()), folder / entry->path().filename());
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
