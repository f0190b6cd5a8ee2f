// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/wild_bench.hpp"

#include "app/figures/bench/bench_clock.hpp"
#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"
#include "faces/evaluation/contour_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tp {

namespace {

constexpr double same_place = 0.4; ///< of a face's size
/// Of wild_contours: both eyes are one feature.
constexpr std::array<std::size_t, 5> feature_of{0, 0, 1, 2, 3};
constexpr std::array<const char*, 4> feature_names{"eyes", "outer lip", "inner lip", "outline"};

/// The middle of both eyes and the mouth, px; nothing where none of them is there.
std::optional<Vec2> middle_of(const Face& face) {
    Vec2 sum(0.0);
    int count = 0;
    for (const char* name : {feature::right_eye, feature::left_eye, feature::outer_lip})
        if (const Contour* contour = contour_named(face.contours, name))
            if (const Polyline line = flatten(*contour); !line.points.empty()) {
                sum += bounds_of(line.points).centre();
                ++count;
            }
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

/// The nearest of `others` at the same place as `face`; null where none is there.
const Face* at_same_place(const Face& face, const std::vector<const Face*>& others) {
    const std::optional<Vec2> here = middle_of(face);
    double nearest = same_place * std::max(face.box.width(), face.box.height());
    const Face* found = nullptr;
    for (const Face* other : others)
        if (const std::optional<Vec2> there = middle_of(*other);
            here && there && length(*there - *here) < nearest) {
            nearest = length(*there - *here);
            found = other;
        }
    return found;
}

/// Sentences that differ in a number only are one.
std::string without_numbers(const std::string& sentence) {
    std::string words;
    bool in_number = false;
    for (const char letter : sentence) {
        const bool digit = letter >= '0' && letter <= '9';
        if (!digit)
            words += letter;
        else if (!in_number)
            words += 'N';
        in_number = digit;
    }
    return words;
}

bool is_without_face(const WildPhoto& photo, const WildLabels* labels) {
    return labels && labels->says(photo.file, wild_label::no_face);
}

bool lacks_face(const WildPhoto& photo) { return photo.was_read() && (!photo.face || !photo.mesh_face); }

/// The rest from `off_percent` in any order.
void work_out(WildAgreement& all, const char* name) {
    all.name = name;
    std::sort(all.off_percent.begin(), all.off_percent.end());
    all.contours = static_cast<int>(all.off_percent.size());
    double sum = 0.0;
    for (const double off : all.off_percent) {
        sum += off;
        all.much_off += off > much_percent ? 1 : 0;
    }
    all.mean_percent = all.contours > 0 ? sum / all.contours : std::numeric_limits<double>::quiet_NaN();
    all.p95_percent = all.contours > 0 ? quantile(all.off_percent, 0.95) : all.mean_percent;
}

void count(WildCovers& covers, const WildPhoto& photo, const WildLabels& labels) {
    if (!labels.of(photo.file)) {
        ++covers.unlabelled;
        return;
    }
    if (labels.says(photo.file, wild_label::no_face)) {
        ++covers.without_face.all;
        covers.without_face.said += photo.face ? 1 : 0;
        return;
    }
    if (!photo.face)
        return;
    ++covers.photos;
    const std::size_t before = covers.falsely.size();
    const auto count_one = [&](WildCovers::Count& clear, WildCovers::Count& covered, const char* word,
                               const char* what, bool said) {
        const bool is_covered = labels.says(photo.file, word);
        WildCovers::Count& one = is_covered ? covered : clear;
        ++one.all;
        one.said += said ? 1 : 0;
        if (said && !is_covered)
            covers.falsely.push_back(photo.name + ": " + what);
    };
    count_one(covers.clear_eyes, covers.covered_eyes, wild_label::right_eye_covered, "right eye",
              photo.is_said_covered(0));
    count_one(covers.clear_eyes, covers.covered_eyes, wild_label::left_eye_covered, "left eye",
              photo.is_said_covered(1));
    count_one(covers.clear_mouths, covers.covered_mouths, wild_label::mouth_covered, "mouth",
              photo.is_said_covered(2) || photo.is_said_covered(3));
    covers.photos_falsely += covers.falsely.size() > before ? 1 : 0;
}

} // namespace

double WildPhoto::worst_percent() const {
    double worst = 0.0;
    for (const std::optional<double>& off : off_percent)
        worst = std::max(worst, off.value_or(0.0));
    return worst;
}

bool WildPhoto::is_said_covered(std::size_t contour) const {
    if (!face)
        return false;
    for (std::size_t i = 0; i < std::min(face->contours.size(), face->quality.size()); ++i)
        if (face->contours[i].name == wild_contours[contour])
            return is_said_hidden(face->quality[i]);
    return false;
}

WildPhoto compared(const Extraction& ours, const Extraction& mesh) {
    WildPhoto photo;
    photo.problem = ours.width > 0 ? "" : ours.problem;
    photo.faces = static_cast<int>(ours.faces.size());
    photo.mesh_faces = static_cast<int>(mesh.faces.size());
    photo.turned_degrees = ours.faces.empty() ? mesh.turned_degrees : ours.turned_degrees;
    photo.milliseconds = ours.milliseconds;
    std::vector<const Face*> left;
    if (ours.turned_degrees == mesh.turned_degrees) // else their pixels are not the same
        for (const Face& face : mesh.faces)
            left.push_back(&face);
    for (const Face& face : ours.faces) {
        photo.said.push_back(face.problem);
        const Face* other = at_same_place(face, left);
        if (other) {
            ++photo.common_faces;
            std::erase(left, other);
        }
        if (photo.face)
            continue;
        photo.face = face;
        if (!other)
            continue;
        photo.mesh_face = *other;
        for (std::size_t i = 0; i < wild_contours.size(); ++i)
            photo.off_percent[i] = contour_error_percent(other->contours, face.contours, wild_contours[i]);
    }
    if (ours.faces.empty() && !mesh.faces.empty())
        photo.mesh_face = mesh.faces.front();
    return photo;
}

std::string run_wild_bench(const std::vector<std::filesystem::path>& files,
                           const std::filesystem::path& folder, const std::function<void(WildPhoto)>& take) {
    auto ours = FaceExtractor::create();
    if (!ours)
        return ours.error();
    auto mesh = FaceExtractor::create({"embedded", "mesh", RefinementStage::close_looks});
    if (!mesh)
        return mesh.error();
    for (const std::filesystem::path& file : files) {
        const Extraction found = ours->extract(file);
        WildPhoto photo = compared(found, found.width > 0 ? mesh->extract(file) : Extraction{});
        photo.file = file;
        photo.name = file.lexically_relative(folder).string();
        take(std::move(photo));
    }
    return {};
}

WildSummary summary_of(const std::vector<WildPhoto>& photos, const WildLabels* labels) {
    WildSummary all;
    all.photos = static_cast<int>(photos.size());
    if (labels)
        all.covers.emplace();
    std::vector<double> decode, rest;
    for (const WildPhoto& photo : photos) {
        if (!photo.was_read()) {
            all.unread.push_back(photo.name);
            continue;
        }
        decode.push_back(photo.milliseconds.decode);
        rest.push_back(photo.milliseconds.detect + photo.milliseconds.landmarks + photo.milliseconds.edges +
                       photo.milliseconds.contours);
        all.faces += photo.faces;
        all.mesh_faces += photo.mesh_faces;
        all.common_faces += photo.common_faces;
        if (labels)
            count(*all.covers, photo, *labels);
        if (is_without_face(photo, labels))
            continue;
        all.largest_faces += photo.face ? 1 : 0;
        if (photo.faces == 0)
            all.not_found.push_back(photo.name);
        if (photo.mesh_faces == 0)
            all.not_found_by_mesh.push_back(photo.name);
        if (photo.face && photo.mesh_faces > 0 && !photo.mesh_face)
            all.apart.push_back(photo.name);
        for (std::size_t i = 0; i < photo.said.size(); ++i)
            if (!photo.said[i].empty()) {
                WildSummary::Said& said = all.sentences[without_numbers(photo.said[i])];
                said.largest += i == 0 ? 1 : 0;
                ++said.all;
            }
        if (photo.face)
            for (std::size_t i = 0; i < std::min(photo.face->contours.size(), photo.face->quality.size());
                 ++i) {
                const auto contour =
                    std::find(wild_contours.begin(), wild_contours.end(), photo.face->contours[i].name);
                if (contour != wild_contours.end())
                    for (const std::string& reason : photo.face->quality[i].reasons)
                        ++all.reasons[reason][static_cast<std::size_t>(contour - wild_contours.begin())];
            }
        for (std::size_t i = 0; i < photo.off_percent.size(); ++i)
            if (photo.off_percent[i])
                all.agreement[feature_of[i]].off_percent.push_back(*photo.off_percent[i]);
    }
    for (std::size_t f = 0; f < all.agreement.size(); ++f)
        work_out(all.agreement[f], feature_names[f]);
    all.decode_ms = quantile(decode, 0.5);
    all.decode_p95_ms = quantile(std::move(decode), 0.95);
    all.rest_ms = quantile(rest, 0.5);
    all.rest_p95_ms = quantile(std::move(rest), 0.95);
    return all;
}

std::vector<std::size_t> worst_of(const std::vector<WildPhoto>& photos, const WildLabels* labels,
                                  std::size_t most) {
    std::vector<std::size_t> lacking, different;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const WildPhoto& photo = photos[i];
        if (is_without_face(photo, labels))
            continue;
        if (lacks_face(photo))
            lacking.push_back(i);
        else if (photo.was_read())
            different.push_back(i);
    }
    // What only we missed comes first, then what only the mesh missed, then what both missed, which may show
    // nobody.
    const auto kind = [&](std::size_t i) { return photos[i].face ? 1 : photos[i].mesh_face ? 0 : 2; };
    std::stable_sort(lacking.begin(), lacking.end(), [&](auto a, auto b) { return kind(a) < kind(b); });
    std::stable_sort(different.begin(), different.end(),
                     [&](auto a, auto b) { return photos[a].worst_percent() > photos[b].worst_percent(); });
    const std::size_t room = most - std::min(most, different.size());
    lacking.resize(std::min(lacking.size(), std::max(most / 2, room)));
    different.resize(std::min(different.size(), most - std::min(most, lacking.size())));
    lacking.insert(lacking.end(), different.begin(), different.end());
    return lacking;
}

} // namespace tp
