// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/corrections.hpp"

#include "core/files/durable_file.hpp"
#include "core/geometry/flatten.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

namespace tp {

namespace {

/// "face 2 left_eye" is face 2's left_eye; any other name is the only face's.
std::pair<int, std::string> face_and_feature(const std::string& name) {
    constexpr std::string_view prefix = "face ";
    int number = 0;
    if (name.starts_with(prefix)) {
        const char* const end = name.data() + name.size();
        const auto [after, error] = std::from_chars(name.data() + prefix.size(), end, number);
        if (error == std::errc{} && after != end && *after == ' ' && number > 0)
            return {number, std::string(after + 1, end)};
    }
    return {0, name};
}

Rect bounds_of_contours(const std::vector<Contour>& contours) {
    std::vector<Vec2> points;
    for (const Contour& contour : contours)
        for (const Vec2 p : flatten(contour, {0.5, 10.0}).points)
            points.push_back(p);
    return bounds_of(points);
}

double size_of(const Rect& box) { return std::max(box.width(), box.height()); }

/// The face not yet taken that `place` lies in or next to.
std::optional<std::size_t> face_at(const std::vector<Face>& faces, const std::vector<bool>& taken,
                                   Vec2 place) {
    std::optional<std::size_t> best;
    double nearest = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const double away = length(faces[i].box.centre() - place);
        if (!taken[i] && away < 0.75 * size_of(faces[i].box) && (!best || away < nearest)) {
            best = i;
            nearest = away;
        }
    }
    return best;
}

constexpr std::string_view removed_suffix = " removed";

bool is_removal(const Contour& contour) { return contour.name.ends_with(removed_suffix); }

void take_away(Face& face, const std::string& name) {
    face.mended.push_back(name);
    const auto own = std::find_if(face.contours.begin(), face.contours.end(),
                                  [&](const Contour& c) { return c.name == name; });
    if (own == face.contours.end())
        return;
    const auto index = own - face.contours.begin();
    if (index < static_cast<std::ptrdiff_t>(face.quality.size()))
        face.quality.erase(face.quality.begin() + index);
    face.contours.erase(own);
}

void mend(Face& face, std::vector<Contour> contours) {
    const std::size_t found = face.contours.size();
    for (Contour& contour : contours) {
        if (is_removal(contour)) {
            take_away(face, contour.name.substr(0, contour.name.size() - removed_suffix.size()));
            continue;
        }
        const auto own = std::find_if(face.contours.begin(), face.contours.end(),
                                      [&](const Contour& c) { return c.name == contour.name; });
        face.mended.push_back(contour.name);
        if (own != face.contours.end())
            *own = std::move(contour);
        else
            face.contours.push_back(std::move(contour));
    }
    if (face.mended.size() >= found) // a person has looked at all of it
        face.problem.clear();
}

} // namespace

std::filesystem::path correction_file(const std::filesystem::path& photo) {
    return photo.string() + ".contours.svg";
}

std::string removed_name(const std::string& name) { return name + std::string(removed_suffix); }

ContourSheet sheet_of(const Extraction& extraction) {
    ContourSheet sheet{static_cast<double>(extraction.width),
                       static_cast<double>(extraction.height),
                       ContourSheet::Unit::pixel,
                       {}};
    for (std::size_t i = 0; i < extraction.faces.size(); ++i)
        for (Contour contour : extraction.faces[i].contours) {
            if (extraction.faces.size() > 1)
                contour.name = "face " + std::to_string(i + 1) + " " + contour.name;
            sheet.contours.push_back(std::move(contour));
        }
    return sheet;
}

Result<Extraction> corrected(Extraction extraction, const ContourSheet& sheet) {
    const double across = extraction.width / sheet.width;
    const double down = extraction.height / sheet.height;
    if (!(std::abs(across / down - 1.0) < 0.01))
        return Error{"they belong to a picture of another shape, " +
                     std::to_string(std::lround(sheet.width)) + " × " +
                     std::to_string(std::lround(sheet.height)) + " pixels."};
    std::map<int, std::vector<Contour>> people;
    for (const Contour& contour : sheet.contours) {
        auto [number, feature] = face_and_feature(contour.name);
        Contour scaled = mapped(contour, [&](Vec2 p) { return p * Vec2(across, down); });
        scaled.name = std::move(feature);
        people[number].push_back(std::move(scaled));
    }
    std::vector<bool> taken(extraction.faces.size(), false);
    for (auto& [number, contours] : people) {
        const Rect box = bounds_of_contours(contours);
        if (const auto face = face_at(extraction.faces, taken, box.centre())) {
            taken[*face] = true;
            mend(extraction.faces[*face], std::move(contours));
            continue;
        }
        if (std::all_of(contours.begin(), contours.end(), is_removal))
            continue;
        Face added;
        added.box = box;
        added.score = 1.0;
        mend(added, std::move(contours));
        extraction.faces.push_back(std::move(added));
        taken.push_back(true);
    }
    std::stable_sort(extraction.faces.begin(), extraction.faces.end(),
                     [](const Face& a, const Face& b) { return size_of(a.box) > size_of(b.box); });
    if (!extraction.faces.empty())
        extraction.problem = extraction.faces.front().problem;
    return extraction;
}

Extraction with_corrections(Extraction extraction, const std::filesystem::path& photo) {
    const std::filesystem::path file = correction_file(photo);
    if (extraction.width <= 0 || is_gone(file))
        return extraction;
    const auto unusable = [&](const std::string& why) {
        extraction.problem = "The mended contours in " + file.filename().string() +
                             " cannot be used, so the program's own are used: " + why;
        return extraction;
    };
    const Result<ContourSheet> sheet = read_sheet(file, ContourSheet::Unit::pixel);
    if (!sheet)
        return unusable(sheet.error());
    Result<Extraction> mended = corrected(extraction, *sheet);
    return mended ? std::move(mended).value() : unusable(mended.error());
}

} // namespace tp
