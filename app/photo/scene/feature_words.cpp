// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/feature_words.hpp"

#include "faces/base/face.hpp"

#include <algorithm>

namespace tp {

namespace {

std::string words_for(std::string_view name) {
    if (name == feature::outer_lip)
        return "lips";
    if (name == feature::inner_lip)
        return "mouth opening";
    if (name == feature::outline)
        return "face outline";
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

} // namespace

std::string spoken_feature(std::string_view name) {
    constexpr std::string_view prefix = "face ";
    const std::size_t space =
        name.starts_with(prefix) ? name.find(' ', prefix.size()) : std::string_view::npos;
    if (space == std::string_view::npos)
        return words_for(name);
    return words_for(name.substr(space + 1)) + " of " + std::string(name.substr(0, space));
}

} // namespace tp
