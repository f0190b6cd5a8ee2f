// SPDX-License-Identifier: Apache-2.0
#include "core/trials/study_trial.hpp"

#include "core/base/chance.hpp"
#include "core/experiment/number_text.hpp"
#include "core/geometry/transform.hpp"
#include "core/guidance/published_law.hpp"
#include "core/trials/study_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tp {
namespace {

constexpr double published_spacing_mm = 1.0;

std::string millimetres(double value) { return shortest(std::round(value)); }

/// Above 0 or as it stands in the experiment, whose reader has looked at the bounds.
std::optional<double> number_of(const Experiment& experiment, StudyParameter parameter,
                                std::size_t condition) {
    return number_in(experiment.value_of(parameter, condition), 1e-6, 1e6);
}

void choose_guidance(const Experiment& experiment, std::size_t condition, StudyTrial& trial) {
    trial.profile.stiffness =
        number_of(experiment, StudyParameter::stiffness, condition).value_or(trial.profile.stiffness);
    trial.profile.range =
        number_of(experiment, StudyParameter::range, condition).value_or(trial.profile.range);
    trial.law = law_named(experiment.value_of(StudyParameter::law, condition)).value_or(trial.law);
}

/// K·d in a condition, N.
double peak_of(const Experiment& experiment, std::size_t condition) {
    StudyTrial trial;
    choose_guidance(experiment, condition, trial);
    return trial.profile.stiffness * trial.profile.range;
}

/// A number from where a box of that size may begin to be inside an interval about 0.
double free_place(double surface, double size, double low, Chance& chance) {
    const double free = surface - size;
    const double margin = std::min(study_margin_mm, 0.5 * free);
    return chance.between(-0.5 * surface + margin, 0.5 * surface - margin - size) - low;
}

Result<Contour> shape_of(const Experiment& experiment, std::size_t condition, StudyShape shape,
                         Chance& chance) {
    const double radius =
        number_of(experiment, StudyParameter::radius, condition).value_or(usual_radius_mm(shape));
    const double first = shape == StudyShape::circle ? chance.share() : std::floor(chance.between(0.0, 60.0));
    const Rect box = bounds_of(flatten(study_shape(shape, Vec2(0.0), radius, first)).points);
    if (box.width() > experiment.surface_width_mm + 1e-9 ||
        box.height() > experiment.surface_height_mm + 1e-9)
        return Error{"A shape " + millimetres(box.width()) + " mm wide and " + millimetres(box.height()) +
                     " mm high does not fit on a surface of " + millimetres(experiment.surface_width_mm) +
                     " x " + millimetres(experiment.surface_height_mm) + " mm."};
    // Two numbers that place nothing are drawn first, so that a trial that was given stays as it was.
    chance.share();
    chance.share();
    Vec2 centre(0.0);
    if (experiment.task == StudyTask::follow)
        centre = {free_place(experiment.surface_width_mm, box.width(), box.min.x, chance),
                  free_place(experiment.surface_height_mm, box.height(), box.min.y, chance)};
    const Vec2 half(0.5 * experiment.surface_width_mm, 0.5 * experiment.surface_height_mm);
    centre = glm::clamp(centre, -half - box.min, half - box.max);
    return study_shape(shape, centre, radius, first);
}

Result<std::vector<Contour>> face_of(const Experiment& experiment, std::size_t condition,
                                     const StudyFaces& faces) {
    auto drawn = faces.contours(experiment.value_of(StudyParameter::expression, condition),
                                experiment.value_of(StudyParameter::face, condition));
    if (!drawn)
        return drawn;
    std::vector<Vec2> all;
    for (const Contour& contour : *drawn) {
        const Polyline line = flatten(contour);
        all.insert(all.end(), line.points.begin(), line.points.end());
    }
    const double margin =
        std::min(study_margin_mm, 0.25 * std::min(experiment.surface_width_mm, experiment.surface_height_mm));
    const Vec2 half(0.5 * experiment.surface_width_mm - margin, 0.5 * experiment.surface_height_mm - margin);
    const auto fit = fit_photo_to_surface(bounds_of(all), {-half, half});
    if (!fit)
        return Error{fit.error()};
    for (Contour& contour : *drawn)
        contour = mapped(contour, *fit);
    return drawn;
}

void choose_path(StudyTrial& trial) {
    trial.path = flatten(trial.scene.contours.front());
    trial.start = trial.path.points.front();
    const double whole = length_of(trial.path);
    trial.reach_mm = std::min(study_reach_mm, 0.5 * whole / study_path_parts);
    for (int part = 1; part < study_path_parts; ++part)
        trial.knots.push_back(point_along(trial.path, whole * part / study_path_parts));
}

} // namespace

double strongest_pull_n(const Experiment& experiment) {
    double strongest = 0.0;
    for (const Experiment& part : {experiment, experiment.in_training()})
        for (std::size_t condition = 0; condition < part.conditions(); ++condition)
            strongest = std::max(strongest, peak_of(part, condition));
    return strongest;
}

std::size_t conditions_cut_at(const Experiment& experiment, double limit_n) {
    std::size_t cut = 0;
    for (std::size_t condition = 0; condition < experiment.conditions(); ++condition)
        cut += peak_of(experiment, condition) > limit_n + 1e-9 ? 1 : 0;
    return cut;
}

Result<StudyTrial> trial_of(const Experiment& whole, const PlannedTrial& planned, const StudyFaces* faces) {
    const Experiment experiment = planned.training ? whole.in_training() : whole;
    const std::size_t condition = planned.condition;
    StudyTrial trial;
    trial.task = experiment.task;
    trial.asks = whole.asks(planned.training);
    trial.longest_s = planned.training && experiment.longest_training_s ? experiment.longest_training_s
                                                                        : experiment.longest_trial_s;
    trial.scene.width_mm = experiment.surface_width_mm;
    trial.scene.height_mm = experiment.surface_height_mm;
    choose_guidance(experiment, condition, trial);

    const auto path = study_shape_named(experiment.value_of(StudyParameter::path, condition));
    const auto shape = study_shape_named(experiment.value_of(StudyParameter::shape, condition));
    const bool face = !experiment.value_of(StudyParameter::expression, condition).empty() ||
                      !experiment.value_of(StudyParameter::face, condition).empty();
    if (int(path.has_value()) + int(shape.has_value()) + int(face) != 1)
        return Error{
            "The experiment " + experiment.name +
            " must have either a path, a shape or a face in every trial, as a factor or set for all."};
    if (face) {
        if (experiment.task == StudyTask::follow)
            return Error{"A face cannot be followed from a start to an end; the experiment " +
                         experiment.name + " needs the task: name."};
        if (faces == nullptr)
            return Error{"The experiment " + experiment.name + " needs faces, and none are there."};
        auto contours = face_of(experiment, condition, *faces);
        if (!contours)
            return Error{contours.error()};
        trial.scene.contours = std::move(*contours);
        return trial;
    }
    Chance chance(planned.seed);
    auto contour = shape_of(experiment, condition, path ? *path : *shape, chance);
    if (!contour)
        return Error{contour.error()};
    trial.scene.contours.push_back(std::move(*contour));
    if (experiment.task == StudyTask::follow)
        choose_path(trial);
    return trial;
}

Result<std::unique_ptr<HapticScene>> haptic_scene_of(const StudyTrial& trial, const Continuity& continuity) {
    auto haptic = make_haptic_scene(trial.scene, trial.profile, trial.law, continuity);
    if (haptic && trial.law == LawKind::published) {
        (*haptic)->flat = with_vertex_spacing((*haptic)->flat, published_spacing_mm);
        (*haptic)->law = make_law((*haptic)->flat, trial.profile, trial.law);
    }
    return haptic;
}

} // namespace tp
