// SPDX-License-Identifier: Apache-2.0
// learn_covered_mouth TRUTH.json PHOTOS: prints faces/covered_mouth_weights.inc. What tells a covered mouth
// from one that is seen is learned from three quarters of the people, where lips are guessed from those whom
// training saw; the other quarter, every fourth from the second on, is the test's (tests/faces).
#include "faces/contour_nets.hpp"
#include "faces/covered_mouth.hpp"
#include "faces/embedded_detector.hpp"
#include "faces/evaluation/cover_lessons.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/evaluation/opened_mouth.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/evaluation/training_half.hpp"
#include "faces/net_points.hpp"
#include "faces/picture.hpp"
#include "faces/quality.hpp"
#include "faces/quiet_opencv.hpp"

#include <algorithm>
#include <cstdio>

using namespace tp;

namespace {

constexpr double ridge = 0.1; ///< of lips from guides, in units of guides divided by their deviation
constexpr double prior = 0.2; ///< covered mouths to seen ones, as they are weighed
constexpr const char* covered = "mouth covered";

/// The ways of degraded() that are most like a covered mouth; blurred and small faces are told by other
/// means.
bool is_like_cover(const std::string& how) {
    constexpr const char* ways[] = {covered, "as it is", "noise 45", "jpeg 8", "side light"};
    return how.starts_with("turned") ||
           std::any_of(std::begin(ways), std::end(ways), [&](const char* way) { return how == way; });
}

/// x and y of lip points in the frame of lip_guides, by mirroring also those of the mirrored face.
cv::Mat1d places_of(const Landmarks& points) {
    const Vec2 origin = 0.5 * (points.right_eye[0] + points.left_eye[0]);
    const Vec2 across = points.left_eye[0] - points.right_eye[0];
    std::vector<double> places;
    for (const auto* lip : {&points.outer_lip, &points.inner_lip})
        for (Vec2 p : *lip) {
            const Vec2 d = p - origin;
            places.push_back(glm::dot(d, across) / glm::dot(across, across));
            places.push_back((across.x * d.y - across.y * d.x) / glm::dot(across, across));
        }
    return cv::Mat1d(places, true).reshape(1, 1);
}

cv::Mat1d mirrored_places(const cv::Mat1d& places) {
    cv::Mat1d result(places.size());
    const auto first = net_points::lips.begin;
    for (std::size_t i = 0; i < net_points::lips.size(); ++i) {
        const int from = 2 * static_cast<int>(in_mirror(first + i) - first), to = 2 * static_cast<int>(i);
        result(to) = -places(from);
        result(to + 1) = places(from + 1);
    }
    return result;
}

cv::Mat1d guides_of(const Landmarks& points) {
    const auto guides = lip_guides(points);
    return cv::Mat1d(std::vector<double>(guides.begin(), guides.end()), true).reshape(1, 1);
}

/// Jaw and chin seen from the other side: the first and the last place change sides.
cv::Mat1d mirrored_guides(const cv::Mat1d& g) {
    return (cv::Mat1d(1, static_cast<int>(lip_guide_count)) << g(0), -g(5), g(6), -g(3), g(4), -g(1), g(2));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("learn_covered_mouth TRUTH.json PHOTOS > faces/covered_mouth_weights.inc\n", stderr);
        return 2;
    }
    quiet_opencv();
    const auto people = read_placed_truth(argv[1], argv[2]);
    const auto held_out = held_out_people(TP_HOLDOUT_LIST);
    if (!people.ok() || !held_out.ok()) {
        std::fprintf(stderr, "%s\n", (people.ok() ? held_out.error() : people.error()).c_str());
        return 1;
    }
    EmbeddedDetector detector;
    ContourNets nets;
    cv::Mat1d signs, is_covered, guides, places;
    for (std::size_t i = 0; i < people->size(); ++i) {
        if (i % 4 == 1)
            continue;
        const PlacedPortrait& person = (*people)[i];
        const auto portrait = read_picture(person.photo);
        if (!portrait) {
            std::fprintf(stderr, "%s: %s\n", person.photo.c_str(), portrait.error().c_str());
            return 1;
        }
        const auto seed = static_cast<unsigned>(i);
        std::vector<Degraded> ways = degraded(*portrait, person.truth, seed);
        std::erase_if(ways, [](const Degraded& way) { return !is_like_cover(way.how); });
        for (const double openness : {0.1, 0.25, 0.5, 0.8})
            ways.push_back(with_opened_mouth(*portrait, person.truth, openness, seed));
        std::optional<Sight> plain;
        for (const Degraded& way : ways) {
            const auto sight = sight_of(detector, nets, way.picture);
            if (!sight)
                continue;
            if (!plain)
                plain = sight; // degraded() begins with the portrait as it is
            if (can_tell_cover(sight->signs)) {
                const auto row = cover_signs(sight->signs);
                signs.push_back(cv::Mat1d(std::vector<double>(row.begin(), row.end()), true).reshape(1, 1));
                is_covered.push_back(way.how == covered ? 1.0 : 0.0);
            }
            if (held_out->contains(person_in(person.photo)) || (way.how != covered && way.how != "as it is"))
                continue;
            const cv::Mat1d here = guides_of(sight->points), lips = places_of(plain->points);
            guides.push_back(here);
            places.push_back(lips);
            guides.push_back(mirrored_guides(here));
            places.push_back(mirrored_places(lips));
        }
    }
    std::printf("// SPDX-License-Identifier: Apache-2.0\n/// Of cover_signs: %d looks, %d of them at covered "
                "mouths.\n",
                signs.rows, static_cast<int>(cv::sum(is_covered)[0]));
    std::puts("constexpr std::array<double, cover_sign_count> cover_weights");
    print_row(fitted_cover(signs, is_covered, prior));
    std::puts(";\n/// Least and most of lip_guides.");
    std::puts("constexpr double lip_guide_range[lip_guide_count][2] = {");
    for (int g = 0; g < guides.cols; ++g) {
        double least = 0.0, most = 0.0;
        cv::minMaxLoc(guides.col(g), &least, &most);
        std::printf("    {%.4f, %.4f},\n", least, most);
    }
    std::printf(
        "};\n/// Of lip_guides, for x and y of each point of the outer, then of the inner lip: %d faces.\n",
        guides.rows);
    std::puts("constexpr double lip_weights[4 * points_of_a_lip][lip_guide_count] = {");
    const cv::Mat1d weights = fitted_places(guides, places, ridge);
    for (int p = 0; p < weights.cols; ++p) {
        std::printf("    ");
        print_row(cv::Mat1d(weights.col(p).t()));
        std::puts(",");
    }
    std::puts("};");
    return 0;
}
