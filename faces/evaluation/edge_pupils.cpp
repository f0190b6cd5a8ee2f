// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/edge_pupils.hpp"

#include "faces/base/face.hpp"
#include "faces/decode/picture.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/located_face.hpp"
#include "faces/evaluation/training_half.hpp"

#include <opencv2/imgproc.hpp>

namespace tp {
namespace {

constexpr const char* smile_suffix = "_08.jpg";
// Studio portraits are sharper and calmer than what people photograph: looks learned from them alone live off
// their finest grain, and are misled by noise and by drawings.
constexpr double noise = 15.0;       ///< grey levels
constexpr double blur_percent = 1.0; ///< of the distance between the outer eye corners

struct Frame {
    Vec2 down;
    double unit_px;
};
Frame frame_of(const FaceLines& lines) { // as in on_edges
    const Vec2 across = lines.left_eye.lower.front() - lines.right_eye.lower.front();
    return {Vec2(-across.y, across.x), length(across)};
}

bool is_open(const Opening& mouth, const Frame& frame) {
    return 100.0 * mouth.mean_gap() >= open_percent * frame.unit_px;
}

std::vector<cv::Mat> views_of(const cv::Mat& picture, double unit_px) {
    cv::RNG random(1);
    cv::Mat grain(picture.size(), CV_16SC3), noisy, blurred;
    random.fill(grain, cv::RNG::NORMAL, 0.0, noise);
    cv::add(picture, grain, noisy, cv::noArray(), CV_8U);
    cv::GaussianBlur(picture, blurred, {}, blur_percent * unit_px / 100.0);
    return {picture, noisy, blurred};
}

void learn_inner_lip(EdgeLessons& lessons, const LinedPortrait& portrait, const Opening& truth) {
    for (const FaceLines& lines : portrait.seen) {
        const Frame frame = frame_of(lines);
        const bool open = is_open(truth, frame);
        for (const cv::Mat& view : portrait.views)
            learn(lessons, view, lines.inner_lip, truth, frame.down, frame.unit_px,
                  open ? at_open_lower_lip : at_shut_lower_lip, open ? at_open_upper_lip : at_shut_upper_lip);
    }
}

void learn_lids_and_outer_lip(EdgeLessons& lessons, const LinedPortrait& portrait) {
    const auto placed = [&](const char* name) {
        return placed_opening(*contour_named(portrait.truth, name));
    };
    for (const FaceLines& lines : portrait.seen) {
        const Frame frame = frame_of(lines);
        const auto from = [&](const Opening& start, const char* name, EdgeKind lower, EdgeKind upper) {
            for (const cv::Mat& view : portrait.views)
                learn(lessons, view, start, placed(name), frame.down, frame.unit_px, lower, upper);
        };
        from(lines.right_eye, feature::right_eye, at_lower_lid, at_upper_lid);
        from(lines.left_eye, feature::left_eye, at_lower_lid, at_upper_lid);
        from(lines.outer_lip, feature::outer_lip, at_outer_lower_lip, at_outer_upper_lip);
    }
}

} // namespace

bool EdgePupil::smiles_openly() const {
    const FaceLines& lines = smiling.seen.back();
    return is_open(lines.inner_lip, frame_of(lines));
}

Result<std::vector<EdgePupil>> edge_pupils(const std::vector<PlacedPortrait>& portraits,
                                           const std::set<std::string>& held_out, LandmarkModel& nets,
                                           LandmarkModel& mesh) {
    EmbeddedDetector detector;
    const auto lined = [&](const std::filesystem::path& photo) -> Result<LinedPortrait> {
        const auto picture = read_picture(photo);
        if (!picture)
            return Error{photo.string() + ": " + picture.error()};
        const auto places = surest_first(detector, *picture);
        const auto by_nets = located(nets, *picture, places), by_mesh = located(mesh, *picture, places);
        if (!by_nets || !by_mesh)
            return Error{photo.string() + ": No face was found in this picture."};
        const std::array<FaceLines, 2> seen{lines_through(*by_nets), lines_through(*by_mesh)};
        return LinedPortrait{views_of(*picture, frame_of(seen.back()).unit_px), seen, {}};
    };
    std::vector<EdgePupil> pupils;
    for (const PlacedPortrait& portrait : portraits) {
        const std::string person = person_in(portrait.photo);
        if (held_out.contains(person))
            continue;
        auto neutral = lined(portrait.photo);
        auto smiling = lined(portrait.photo.parent_path() / (person + smile_suffix));
        if (!neutral || !smiling)
            return Error{neutral ? smiling.error() : neutral.error()};
        EdgePupil pupil{std::move(*neutral), std::move(*smiling), {}};
        pupil.neutral.truth = portrait.truth;
        pupil.smiling.truth = contours_of(pupil.smiling.seen.back());
        learn_lids_and_outer_lip(pupil.lessons, pupil.neutral);
        learn_inner_lip(pupil.lessons, pupil.neutral,
                        placed_opening(*contour_named(portrait.truth, feature::inner_lip)));
        learn_inner_lip(pupil.lessons, pupil.smiling, pupil.smiling.seen.back().inner_lip);
        pupils.push_back(std::move(pupil));
    }
    if (pupils.empty())
        return Error{"Everybody with contours placed by hand is held out of training."};
    return pupils;
}

} // namespace tp
