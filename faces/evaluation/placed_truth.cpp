// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/placed_truth.hpp"

#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core/persistence.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace tp {
namespace {

constexpr const char* names[][2] = {{"eye_on_the_left_of_the_picture", feature::right_eye},
                                    {"eye_on_the_right_of_the_picture", feature::left_eye},
                                    {"outer_lip", feature::outer_lip},
                                    {"inner_lip", feature::inner_lip},
                                    {"outline", feature::outline}};

constexpr std::size_t largest_truth = std::size_t{16} << 20U; ///< bytes
constexpr int deepest = 8; ///< levels: photos, contours, points, numbers are four
constexpr double farthest_px = 1e6;

/// JSON with no more levels than `deepest`, so that OpenCV may read it: it goes down by calling itself, and would take
/// what begins as YAML or XML for that.
bool is_shallow_json(std::string_view text) {
    int level = 0;
    bool in_words = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (in_words && letter == '\\')
            ++i;
        else if (letter == '"')
            in_words = !in_words;
        else if (!in_words && (letter == '{' || letter == '[') && ++level > deepest)
            return false;
        else if (!in_words && (letter == '}' || letter == ']'))
            --level;
    }
    return text.starts_with('{') && text.find('\0') == text.npos;
}

bool can_be_a_place(Vec2 point) {
    return std::abs(point.x) <= farthest_px && std::abs(point.y) <= farthest_px;
}

} // namespace

Result<std::vector<PlacedPortrait>> read_placed_truth(const std::filesystem::path& file,
                                                      const std::filesystem::path& photos) {
    const Error unreadable{"The file " + quoted(file) + " cannot be read as contours placed by hand."};
    const Result<std::string> text = read_whole(file, largest_truth);
    if (!text)
        return Error{text.error()};
    if (!is_shallow_json(*text))
        return unreadable;
    try {
        constexpr int memory = cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_JSON;
        const cv::FileStorage storage(*text, memory);
        std::vector<PlacedPortrait> found;
        for (const cv::FileNode& person : storage.root()) {
            PlacedPortrait portrait{photos / person.name(), {}};
            for (const auto& [key, name] : names) {
                std::vector<Vec2> points;
                for (const cv::FileNode& p : person[key])
                    points.emplace_back(p[0].real(), p[1].real());
                if (points.size() < 3)
                    return Error{"In " + quoted(file) + " a photo has no " + key + ": " +
                                 readable(person.name())};
                if (!std::ranges::all_of(points, can_be_a_place))
                    return unreadable;
                portrait.truth.push_back(
                    contour_through(name, points, std::string_view(name) != feature::outline));
            }
            found.push_back(std::move(portrait));
        }
        return found.empty() ? Result<std::vector<PlacedPortrait>>(unreadable) : found;
    } catch (const std::exception&) {
        return unreadable;
    }
}

} // namespace tp
