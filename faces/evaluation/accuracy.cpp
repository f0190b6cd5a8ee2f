// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/accuracy.hpp"

#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/training_half.hpp"

#include <algorithm>

namespace tp {
namespace {

std::optional<std::array<double, feature_count>> errors_of(const Extraction& found,
                                                           const std::vector<Contour>& truth) {
    if (found.faces.size() != 1)
        return std::nullopt;
    std::array<double, feature_count> percent{};
    for (std::size_t f = 0; f < feature_count; ++f) {
        const auto error = contour_error_percent(truth, found.faces[0].contours, felt_features[f]);
        if (!error)
            return std::nullopt;
        percent[f] = *error;
    }
    return percent;
}

} // namespace

bool PortraitErrors::failed() const {
    return !problem.empty() || !percent ||
           std::ranges::any_of(*percent, [](double error) { return !(error <= failure_percent); });
}

Result<std::vector<PortraitErrors>> measured_errors(const ExtractorChoice& choice,
                                                    const std::vector<PlacedPortrait>& people) {
    Result<FaceExtractor> faces = FaceExtractor::create(choice);
    if (!faces)
        return Error{faces.error()};
    std::vector<PortraitErrors> all;
    for (const PlacedPortrait& person : people) {
        const Extraction found = faces->extract(person.photo);
        all.push_back({person.photo.filename().string(), errors_of(found, person.truth), found.problem,
                       found.milliseconds});
    }
    return all;
}

Result<std::vector<PlacedPortrait>> held_out_portraits(const std::filesystem::path& list,
                                                       const std::filesystem::path& truth,
                                                       const std::filesystem::path& photos) {
    const auto held_out = held_out_people(list);
    auto people = read_placed_truth(truth, photos);
    if (!held_out || !people)
        return Error{people ? held_out.error() : people.error()};
    std::erase_if(*people,
                  [&](const PlacedPortrait& person) { return !held_out->contains(person_in(person.photo)); });
    return people;
}

} // namespace tp
