// SPDX-License-Identifier: Apache-2.0
#include "app/photo/seen/seen_names.hpp"

#include <array>
#include <cstddef>

namespace tp {

namespace {

template <std::size_t count, typename Kind>
std::string_view named(const std::array<std::string_view, count>& names, Kind kind) {
    const auto place = static_cast<std::size_t>(kind);
    return place < count ? names[place] : "unknown";
}

constexpr double face_from = 0.55, head_and_shoulders_from = 0.33,
                 far_below = 0.07; ///< of the picture's height

} // namespace

std::string_view name_of(Mien mien) {
    static constexpr std::array<std::string_view, 5> names{"unknown", "perhaps_smiling", "smiling",
                                                           "smiling_broadly", "perhaps_laughing"};
    return named(names, mien);
}

std::string_view name_of(Eyes eyes) {
    static constexpr std::array<std::string_view, 4> names{"unknown", "open", "perhaps_shut", "shut"};
    return named(names, eyes);
}

std::string_view name_of(Facing facing) {
    static constexpr std::array<std::string_view, 4> names{"unknown", "camera", "left", "right"};
    return named(names, facing);
}

std::string_view name_of(Nearness nearness) {
    static constexpr std::array<std::string_view, 4> names{"far", "usual", "head_and_shoulders", "face"};
    return named(names, nearness);
}

std::string_view name_of(Light light) {
    static constexpr std::array<std::string_view, 4> names{"usual", "dark", "dark_background",
                                                           "bright_background"};
    return named(names, light);
}

std::string_view name_of(Colours colours) {
    static constexpr std::array<std::string_view, 7> names{
        "many", "black_and_white", "red", "yellow", "green", "blue", "violet"};
    return named(names, colours);
}

Nearness nearness_of(const SeenPhoto& seen) {
    if (seen.faces.empty())
        return Nearness::far;
    const double height = seen.faces.front().part.height();
    return height >= face_from                 ? Nearness::face
           : height >= head_and_shoulders_from ? Nearness::head_and_shoulders
           : height >= far_below               ? Nearness::usual
                                               : Nearness::far;
}

} // namespace tp
