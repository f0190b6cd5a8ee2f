// SPDX-License-Identifier: Apache-2.0
// learn_covered PHOTOS LABELS: prints faces/judge/covered_weights.inc. What tells an eye or a mouth that
// something covers from one that is seen is learned from portraits and from photographs in the wild that no
// test takes: as they are, and with a cover that degraded() puts there, where the mesh sees the feature. Of
// the seen eyes in the wild one in 125 is said to be covered.
#include "core/geometry/polyline.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "faces/evaluation/cover_lessons.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/evaluation/located_face.hpp"
#include "faces/evaluation/opened_mouth.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/evaluation/training_half.hpp"
#include "faces/evaluation/wild_labels.hpp"
#include "faces/judge/covered.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr double prior = 0.2; ///< covered ones to seen ones, as they are weighed
/// Of seen eyes in the wild, how many are said to be covered. (Of mouths fewer are by the regression's own
/// threshold.)
constexpr double eyes_told_wrongly = 8e-3;

/// Of degraded(); in the wild much is hard to see as it is.
const std::string shown_in_the_wild[] = {"as it is", "eye covered dark", "eye covered like skin",
                                         "mouth covered"};

/// Looks at one kind of feature.
struct Lessons {
    cv::Mat1d signs, covered;
    cv::Mat1d ignored_in_the_wild; ///< 0 for seen ones in photographs in the wild as they are

    void add(const QualitySigns& seen, FeatureIndex feature, bool is_covered, bool wild) {
        if (!can_tell_cover(seen, feature))
            return;
        signs.push_back(row_of(cover_signs(seen, feature)));
        covered.push_back(is_covered ? 1.0 : 0.0);
        ignored_in_the_wild.push_back(wild && !is_covered ? 0.0 : 1.0);
    }
};

/// Whether a cover that degraded() made lies on that eye: there both pictures differ.
bool differs_at(const cv::Mat& one, const cv::Mat& other, const std::vector<Vec2>& eye) {
    const Vec2 centre = bounds_of(eye).centre();
    const cv::Point at(static_cast<int>(centre.x), static_cast<int>(centre.y));
    return one.at<cv::Vec3b>(at) != other.at<cv::Vec3b>(at);
}

class Teacher {
public:
    /// A photograph as it is and made harder; `labels`: what is covered in it.
    void show(const cv::Mat& photo, const std::vector<Contour>& contours, const Sight& plain,
              const std::set<std::string>& labels, bool wild, unsigned seed) {
        std::vector<Degraded> ways = degraded(photo, contours, seed);
        std::erase_if(ways, [wild](const Degraded& way) {
            return wild ? std::ranges::find(shown_in_the_wild, way.how) == std::end(shown_in_the_wild)
                        : way.how == "half covered";
        });
        if (!wild)
            for (const double openness : {0.25, 0.5, 0.8})
                ways.push_back(with_opened_mouth(photo, contours, openness, seed));
        if (!wild)
            for (const double shut : {0.5, 1.0})
                ways.push_back(with_closed_eyes(photo, contours, shut, seed));
        for (const Degraded& way : ways) {
            const auto sight = sight_of(eyewitness, way.picture);
            if (!sight)
                continue;
            const bool as_it_is = wild && way.how == "as it is",
                       eye_covered = way.how.starts_with("eye covered");
            const Landmarks& there = plain.opinions.mesh;
            eyes.add(sight->signs, at_right_eye,
                     labels.contains(wild_label::right_eye_covered) ||
                         (eye_covered && differs_at(photo, way.picture, there.right_eye)),
                     as_it_is);
            eyes.add(sight->signs, at_left_eye,
                     labels.contains(wild_label::left_eye_covered) ||
                         (eye_covered && differs_at(photo, way.picture, there.left_eye)),
                     as_it_is);
            mouths.add(sight->signs, at_outer_lip,
                       labels.contains(wild_label::mouth_covered) || way.how == "mouth covered", as_it_is);
        }
    }

    Eyewitness eyewitness;
    Lessons eyes, mouths;
};

void print(const char* name, const Lessons& lessons, std::optional<double> told_wrongly) {
    cv::Mat1d weights = fitted_cover(lessons.signs, lessons.covered, prior);
    if (told_wrongly)
        weights(0) -= threshold_for(lessons.signs, lessons.ignored_in_the_wild, weights, *told_wrongly);
    int told = 0, wrongly = 0;
    for (int r = 0; r < lessons.signs.rows; ++r)
        if (lessons.signs.row(r).dot(weights.t()) > 0.0)
            ++(lessons.covered(r) > 0.5 ? told : wrongly);
    std::printf("/// Of cover_signs: %d looks, %d of them at covered ones, of which %d are told; wrongly "
                "told are %d.\n",
                lessons.signs.rows, static_cast<int>(cv::sum(lessons.covered)[0]), told, wrongly);
    std::printf("constexpr std::array<double, cover_sign_count> %s", name);
    print_row(weights);
    std::puts(";");
}

/// The mesh's contours of a photograph of which there is no truth.
std::vector<Contour> contours_as_seen(const Sight& sight) {
    return contours_of(lines_through(sight.opinions.mesh));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("learn_covered ../shared/faces/photos tests/faces/wild_labels.txt > "
                   "faces/judge/covered_weights.inc\n",
                   stderr);
        return 2;
    }
    quiet_opencv();
    const fs::path photos = argv[1], training = TP_TRAINING;
    const auto people = read_placed_truth(photos / "london_truth.json", photos);
    const auto held_out = held_out_people(training / "holdout.txt");
    const auto held_out_wild = held_out_people(training / "holdout_wild.txt");
    const auto labels = read_wild_labels(argv[2]);
    for (const std::string& problem :
         {people.error(), held_out.error(), held_out_wild.error(), labels.error()})
        if (!problem.empty()) {
            std::fprintf(stderr, "%s\n", problem.c_str());
            return 1;
        }
    Teacher teacher;
    unsigned seed = 0;
    for (const PlacedPortrait& person : *people) {
        const auto photo = read_picture(person.photo);
        const auto plain = photo ? sight_of(teacher.eyewitness, *photo) : std::nullopt;
        if (plain && !held_out->contains(person_in(person.photo)))
            teacher.show(*photo, person.truth, *plain, {}, false, seed++);
    }
    for (const auto& [name, words] : labels->words()) {
        if (held_out_wild->contains(name) || !labels->is_plain(name))
            continue;
        const auto photo = read_picture(photos / "wild" / name);
        const auto plain = photo ? sight_of(teacher.eyewitness, *photo) : std::nullopt;
        if (plain)
            teacher.show(*photo, contours_as_seen(*plain), *plain, words, true, seed++);
    }
    std::puts("// SPDX-License-Identifier: Apache-2.0");
    print("eye_cover_weights", teacher.eyes, eyes_told_wrongly);
    print("mouth_cover_weights", teacher.mouths, std::nullopt);
    return 0;
}
