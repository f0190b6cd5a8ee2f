// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/placed_truth.hpp"

#include "faces/base/face.hpp"

#include <opencv2/core/persistence.hpp>

#include <string_view>

namespace tp {
namespace {

constexpr const char* names[][2] = {{"eye_on_the_left_of_the_picture", feature::right_eye},
                                    {"eye_on_the_right_of_the_picture", feature::left_eye},
                                    {"outer_lip", feature::outer_lip},
                                    {"inner_lip", feature::inner_lip},
                                    {"outline", feature::outline}};

} // namespace

Result<std::vector<PlacedPortrait>> read_placed_truth(const std::filesystem::path& file,
                                                      const std::filesystem::path& photos) {
    const Error unreadable{"The file \"" + file.string() + "\" cannot be read as contours placed by hand."};
    if (!std::filesystem::is_regular_file(file))
        return Error{"There is no file \"" + file.string() + "\"."};
    try {
        const cv::FileStorage storage(file.string(), cv::FileStorage::READ | cv::FileStorage::FORMAT_JSON);
        std::vector<PlacedPortrait> found;
        for (const cv::FileNode& person : storage.root()) {
            PlacedPortrait portrait{photos / person.name(), {}};
            for (const auto& [key, name] : names) {
                std::vector<Vec2> points;
                for (const cv::FileNode& p : person[key])
                    points.emplace_back(p[0].real(), p[1].real());
                if (points.size() < 3)
                    return Error{"In \"" + file.string() + "\" a photo has no " + key + ": " + person.name()};
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
