// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/bundle_parts.hpp"

#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tp {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

namespace {

/// What companions' names end in, in lower case: sidecars, contours, cameras' sounds and films.
constexpr std::array companion_ends{".xmp"sv, ".svg"sv, ".wav"sv, ".mov"sv, ".mp4"sv};

fs::path in_lower_case(const fs::path& name) {
    std::string text = name.string();
    for (char& c : text)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool is_hidden(const fs::path& folder) {
    return std::any_of(folder.begin(), folder.end(),
                       [](const fs::path& name) { return name.string().starts_with('.'); });
}

} // namespace

void BundleParts::add(const fs::path& file) {
    if (!has_photo_name(file) || is_hidden(file.parent_path()))
        return;
    photos_.insert(file);
    stems_.insert(file.parent_path() / in_lower_case(file.stem()));
}

bool BundleParts::hold(const fs::path& file) const {
    const fs::path folder = file.parent_path();
    if (photos_.contains(file) ||
        (folder.extension() == ".tags" && photos_.contains(folder.parent_path() / folder.stem())))
        return true;
    const auto original = conflict_original(file.filename().string());
    fs::path name = in_lower_case(original ? fs::path(*original) : file.filename());
    if (std::find(companion_ends.begin(), companion_ends.end(), name.extension().string()) ==
        companion_ends.end())
        return false;
    while (name.has_extension()) { // IMG_1.jpg.contours.svg
        name = name.stem();
        if (stems_.contains(folder / name))
            return true;
    }
    return false;
}

} // namespace tp
