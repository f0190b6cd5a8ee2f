// SPDX-License-Identifier: Apache-2.0
// learn_covered_eye TRUTH.json PHOTOS: prints faces/covered_eye_weights.inc. Where an eye lies in a face, and
// what tells a covered one from one that is seen, are learned from people who are not held out of training;
// the others are the test's (tests/faces).
#include "core/geometry/polyline.hpp"
#include "faces/covered_eye.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/cover_lessons.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/evaluation/opened_mouth.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/evaluation/training_half.hpp"
#include "faces/picture.hpp"
#include "faces/quiet_opencv.hpp"

#include <cstdio>
#include <memory>

using namespace tp;

namespace {

constexpr double ridge = 0.1; ///< of an eye from its guides, in units of guides divided by their deviation
constexpr double prior = 0.2; ///< covered eyes to seen ones, as they are weighed
constexpr unsigned looks = 4; ///< at what is left to chance, of each portrait
constexpr int rounds = 5;     ///< of moving guides onto their mean
constexpr FeatureIndex eyes[] = {at_right_eye, at_left_eye};

/// A look at a face, and which of its eyes is covered.
struct Lesson {
    Sight sight;
    const Sight* plain = nullptr; ///< at the same face in the same place, nothing covered
    std::optional<FeatureIndex> covered;
    bool is_sharp = false; ///< where the eyes lie can be learned from it
};

bool is_left_to_chance(const Degraded& way) {
    return way.how.starts_with("eye covered") || way.how.starts_with("noise");
}

/// Which eye something covers: the one at which both pictures differ.
FeatureIndex covered_eye(const cv::Mat& portrait, const cv::Mat& picture, const Landmarks& plain) {
    const auto differs = [&](const std::vector<Vec2>& eye) {
        const Rect extent = bounds_of(eye);
        const cv::Point at(static_cast<int>(extent.centre().x), static_cast<int>(extent.centre().y));
        return portrait.at<cv::Vec3b>(at) != picture.at<cv::Vec3b>(at);
    };
    return differs(plain.left_eye) ? at_left_eye : at_right_eye;
}

/// An eye of the guesser: the left one, or the right one in a mirror.
std::vector<Vec2> as_left(const Landmarks& points, FeatureIndex eye) {
    std::vector<Vec2> line = eye == at_left_eye ? points.left_eye : points.right_eye;
    for (Vec2& p : line)
        p.x *= eye == at_left_eye ? 1.0 : -1.0;
    return line;
}

using Guides = std::array<Vec2, eye_guide_points>;

/// Each moved, turned and scaled onto the mean, whose eyes' outer corner and mouth are about 1 apart.
Guides mean_of(const std::vector<Guides>& all) {
    Guides mean = all.front();
    const double unit = length(mean[0] - mean[9]);
    for (Vec2& p : mean)
        p = (p - all.front()[0]) / unit;
    for (int round = 0; round < rounds; ++round) {
        Guides sum{};
        for (const Guides& guides : all) {
            const GuideFrame frame(guides, mean);
            for (std::size_t i = 0; i < eye_guide_points; ++i)
                sum[i] += frame.into(guides[i]) / static_cast<double>(all.size());
        }
        mean = sum;
    }
    return mean;
}

EyeGuesser learned(const std::vector<Lesson>& lessons) {
    std::vector<Guides> guides;
    std::vector<std::vector<Vec2>> places;
    for (const Lesson& lesson : lessons)
        for (const FeatureIndex eye : eyes)
            if (lesson.covered ? *lesson.covered == eye : lesson.is_sharp) {
                guides.push_back(eye_guide_places(lesson.sight.points, eye).value());
                places.push_back(as_left((lesson.plain ? *lesson.plain : lesson.sight).points, eye));
            }
    EyeGuesser guesser{mean_of(guides), {}, {}};
    cv::Mat1d x, y;
    for (std::size_t i = 0; i < guides.size(); ++i) {
        const GuideFrame frame(guides[i], guesser.mean_guides);
        x.push_back(row_of(eye_guides(guides[i], frame)));
        std::vector<double> place;
        for (const Vec2 p : places[i]) {
            place.push_back(frame.into(p).x);
            place.push_back(frame.into(p).y);
        }
        y.push_back(cv::Mat1d(place, true).reshape(1, 1));
    }
    const cv::Mat1d weights = fitted_places(x, y, ridge);
    for (int g = 0; g < x.cols; ++g) {
        cv::minMaxLoc(x.col(g), &guesser.range[g][0], &guesser.range[g][1]);
        for (int p = 0; p < y.cols; ++p)
            guesser.weights[p][g] = weights(g, p);
    }
    std::printf("/// %zu eyes.\n", guides.size());
    return guesser;
}

void print(const EyeGuesser& guesser) {
    std::puts("constexpr EyeGuesser eye_guesser{");
    std::puts("    {{");
    for (const Vec2 p : guesser.mean_guides)
        std::printf("        {%.4f, %.4f},\n", p.x, p.y);
    std::puts("    }},\n    {");
    for (const auto& range : guesser.range)
        std::printf("        {%.4f, %.4f},\n", range[0], range[1]);
    std::puts("    },\n    {");
    for (const auto& row : guesser.weights) {
        std::printf("        ");
        print_row(cv::Mat1d(std::vector<double>(std::begin(row), std::end(row)), true));
        std::puts(",");
    }
    std::puts("    }};");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("learn_covered_eye TRUTH.json PHOTOS > faces/covered_eye_weights.inc\n", stderr);
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
    std::vector<Lesson> lessons;
    std::vector<std::unique_ptr<Sight>> plain;
    for (std::size_t i = 0; i < people->size(); ++i) {
        const PlacedPortrait& person = (*people)[i];
        if (held_out->contains(person_in(person.photo)))
            continue;
        const auto portrait = read_picture(person.photo);
        if (!portrait) {
            std::fprintf(stderr, "%s: %s\n", person.photo.c_str(), portrait.error().c_str());
            return 1;
        }
        const auto as_it_is = sight_of(detector, nets, *portrait);
        if (!as_it_is)
            continue;
        plain.push_back(std::make_unique<Sight>(*as_it_is));
        for (unsigned look = 0; look < looks; ++look) {
            const auto seed = static_cast<unsigned>(i + look * people->size());
            std::vector<Degraded> ways = degraded(*portrait, person.truth, seed);
            std::erase_if(ways, [look](const Degraded& way) {
                return way.how == "half covered" || (look > 0 && !is_left_to_chance(way));
            });
            if (look == 0)
                ways.push_back(with_opened_mouth(*portrait, person.truth, 0.5, seed));
            for (const double shut : {0.5, 1.0})
                ways.push_back(with_closed_eyes(*portrait, person.truth, shut, seed));
            for (const Degraded& way : ways) {
                const auto sight = sight_of(detector, nets, way.picture);
                if (!sight)
                    continue;
                Lesson lesson{*sight, nullptr, std::nullopt,
                              way.how == "as it is" || way.how.starts_with("turned")};
                if (way.how.starts_with("eye covered")) {
                    lesson.plain = plain.back().get();
                    lesson.covered = covered_eye(*portrait, way.picture, as_it_is->points);
                }
                lessons.push_back(lesson);
            }
        }
    }
    std::puts("// SPDX-License-Identifier: Apache-2.0");
    const EyeGuesser guesser = learned(lessons);
    cv::Mat1d signs, is_covered;
    for (Lesson& lesson : lessons) {
        for (const FeatureIndex eye : eyes)
            lesson.sight.signs.eye_off_guess[eye] = off_guess_percent(lesson.sight.points, eye, guesser);
        for (const FeatureIndex eye : eyes)
            if (can_tell_eye_cover(lesson.sight.signs, eye)) {
                signs.push_back(row_of(eye_cover_signs(lesson.sight.signs, eye)));
                is_covered.push_back(lesson.covered == eye ? 1.0 : 0.0);
            }
    }
    print(guesser);
    std::printf("/// Of eye_cover_signs: %d looks, %d of them at covered eyes.\n", signs.rows,
                static_cast<int>(cv::sum(is_covered)[0]));
    std::puts("constexpr std::array<double, eye_cover_sign_count> eye_cover_weights");
    print_row(fitted_cover(signs, is_covered, prior));
    std::puts(";");
    return 0;
}
