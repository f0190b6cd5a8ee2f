// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"
#include "faces/decode/picture.hpp"
#include "places.hpp"

#include <opencv2/core/persistence.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

/// Skips a test, by name, where they are missing.
#define NEEDS_PORTRAITS()                                                                                    \
    if (!portraits::present())                                                                               \
    QSKIP("needs ../shared/faces: portraits of people are not part of the repository")

/// Photographs of people that lie beside the repository, not in it.
namespace portraits {

inline std::filesystem::path folder() { return std::filesystem::path(tp::test::in_shared("faces")); }
inline bool present() { return std::filesystem::exists(folder() / "photos/london_truth.json"); }

struct Portrait {
    std::filesystem::path photo;
    std::vector<tp::Contour> truth; ///< px, placed by hand
};

/// Numbers of the people of the London set whom the training of the embedded models did not see.
inline std::set<std::string> held_out_people() {
    std::ifstream file(std::filesystem::path(tp::test::in_source("faces/training/holdout.txt")));
    std::set<std::string> people;
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line.front() != '#')
            people.insert(line);
    return people;
}

/// Those of them with contours placed by hand, each with the neutral portrait to which these belong.
inline std::vector<Portrait> held_out() {
    constexpr const char* names[][2] = {{"eye_on_the_left_of_the_picture", tp::feature::right_eye},
                                        {"eye_on_the_right_of_the_picture", tp::feature::left_eye},
                                        {"outer_lip", tp::feature::outer_lip},
                                        {"inner_lip", tp::feature::inner_lip},
                                        {"outline", tp::feature::outline}};
    const cv::FileStorage file((folder() / "photos/london_truth.json").string(),
                               cv::FileStorage::READ | cv::FileStorage::FORMAT_JSON);
    const std::set<std::string> people = held_out_people();
    std::vector<Portrait> found;
    for (const cv::FileNode& person : file.root()) {
        // "london/002_03.jpg" shows person 002.
        if (!people.contains(std::filesystem::path(person.name()).stem().string().substr(0, 3)))
            continue;
        Portrait portrait{folder() / "photos" / person.name(), {}};
        for (const auto& [key, name] : names) {
            std::vector<tp::Vec2> points;
            for (const cv::FileNode& p : person[key])
                points.emplace_back(p[0].real(), p[1].real());
            portrait.truth.push_back(
                tp::contour_through(name, points, std::string(name) != tp::feature::outline));
        }
        found.push_back(std::move(portrait));
    }
    return found;
}

/// A frontal portrait, 900 px.
inline cv::Mat one(const char* name = "london/005_03.jpg") {
    auto picture = tp::read_picture(folder() / "photos" / name);
    return picture ? *picture : cv::Mat();
}

} // namespace portraits
