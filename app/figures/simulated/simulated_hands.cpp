// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/simulated_hands.hpp"

#include "core/participant/felt_shape.hpp"
#include "core/participant/study_hand.hpp"
#include "core/study/exploring_finger.hpp"
#include "core/study/expression_observer.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

namespace tp {
namespace {

class Follower final : public SimulatedHand {
public:
    Follower(const StudyTrial& trial, const Person& person, double dt_s, std::uint64_t seed)
        : hand_(person, trial.scene.surface(), trial.start, true, dt_s, seed) {}
    Vec2 step(Vec2 finger, Vec2 force) override { return hand_.step(finger, force); }
    std::optional<std::string> knows(std::span<const FingerSample>) override { return std::nullopt; }
    std::string guess(std::span<const FingerSample>) override { return {}; }

private:
    StudyHand hand_;
};

std::string word_for(int corners) {
    switch (corners) {
    case 3:
        return "triangle";
    case 4:
        return "square";
    case 5:
        return "pentagon";
    case 6:
        return "hexagon";
    default:
        return "circle";
    }
}

class ShapeFeeler final : public SimulatedHand {
public:
    ShapeFeeler(const StudyTrial& trial, const Person& person, double dt_s, std::uint64_t seed)
        : hand_(person, trial.scene.surface(), trial.start, false, dt_s, seed), namer_(person, seed + 2) {}
    Vec2 step(Vec2 finger, Vec2 force) override { return hand_.step(finger, force); }
    std::optional<std::string> knows(std::span<const FingerSample>) override {
        const auto corners = namer_.hear(hand_.trail());
        return corners ? std::optional(word_for(*corners)) : std::nullopt;
    }
    std::string guess(std::span<const FingerSample>) override {
        const auto corners = namer_.guess();
        return corners ? word_for(*corners) : std::string();
    }

private:
    StudyHand hand_;
    ShapeNamer namer_;
};

/// Where a person who knows faces looks for the mouth, then for either eye, and then for all: shares of the surface from its middle
/// (assumed).
constexpr std::array<Rect, 4> face_places{Rect{{-0.25, -0.25}, {0.25, 0.05}},
                                          Rect{{-0.35, 0.22}, {-0.05, 0.47}},
                                          Rect{{0.05, 0.22}, {0.35, 0.47}}, Rect{{-0.5, -0.5}, {0.5, 0.5}}};
constexpr double passed_mm = 3.0;      // a place of a contour was felt where the finger came as near
constexpr double enough_of_line = 0.5; // a line of which less was felt tells nothing (assumed)
constexpr double thinks_s = 0.5;       // between two thoughts about what it is (assumed)

/// The contours of a face, and which of their places a finger has passed.
class PassedContours {
public:
    explicit PassedContours(const std::vector<Contour>& contours) {
        for (const Contour& contour : contours) {
            const Polyline flat = flatten(contour);
            lines_.push_back({contour.name,
                              resampled(flat, static_cast<std::size_t>(2.0 + length_of(flat) / 2.0)).points,
                              {},
                              0});
            lines_.back().passed.resize(lines_.back().places.size());
        }
    }
    void pass(Vec2 finger) {
        for (Line& line : lines_)
            for (std::size_t i = 0; i < line.places.size(); ++i)
                if (!line.passed[i] && length(line.places[i] - finger) <= passed_mm) {
                    line.passed[i] = true;
                    ++line.count;
                }
    }
    /// Enough of it to know how it runs.
    bool knows(std::string_view name) const {
        const auto line = std::ranges::find(lines_, name, &Line::name);
        return line != lines_.end() &&
               static_cast<double>(line->count) >= enough_of_line * static_cast<double>(line->places.size());
    }
    bool knows(Cue cue) const {
        switch (cue) {
        case Cue::mouth_width:
        case Cue::outer_corner_lift:
            return knows("outer_lip");
        case Cue::mouth_opening:
        case Cue::inner_corner_lift:
            return knows("inner_lip");
        case Cue::lip_height:
            return knows("outer_lip") && knows("inner_lip");
        case Cue::chin_depth:
            return knows("outline");
        default: // one eye is like the other
            return knows("left_eye") || knows("right_eye");
        }
    }

private:
    struct Line {
        std::string name;
        std::vector<Vec2> places;
        std::vector<bool> passed;
        std::size_t count = 0;
    };
    std::vector<Line> lines_;
};

/// Looks one place of the face after the other through, lane by lane, and follows what it meets; answers as soon as one expression is as
/// probable as `sure_belief` by the contours of which it felt enough, or at the end. The force on it is felt at once and exactly, unlike
/// with StudyHand.
class FaceFeeler final : public SimulatedHand {
public:
    FaceFeeler(const StudyTrial& trial, const Person& person, double dt_s, std::uint64_t seed)
        : person_(person), dt_s_(dt_s), surface_(trial.scene.surface()), passed_(trial.scene.contours),
          finger_(place(0), manner_of(person)),
          last_s_(trial.longest_s ? std::max(0.0, *trial.longest_s - person.answer_s - 0.05) : 1e9) {
        touch_.noise_mm = person.touch_mm;
        touch_.eyes_mm = eyes_mm(trial.scene.contours);
        std::mt19937_64 random(seed);
        if (const auto exact = expression_cues(trial.scene.contours))
            cues_ = felt(*exact, touch_, random);
    }

    Vec2 step(Vec2 finger, Vec2 force) override {
        time_s_ += dt_s_;
        if (finger_.finished() && at_ + 1 < face_places.size())
            finger_ = ExploringFinger(place(++at_), manner_of(person_));
        return finger_.step(finger, length(force) >= person_.threshold_n ? force : Vec2(0.0), dt_s_);
    }
    std::optional<std::string> knows(std::span<const FingerSample> path) override {
        hear(path);
        const bool ends = (finger_.finished() && at_ + 1 == face_places.size()) || time_s_ >= last_s_;
        if (!ends && time_s_ < thinks_at_s_)
            return std::nullopt;
        thinks_at_s_ = time_s_ + thinks_s;
        const ExpressionShares shares = beliefs();
        return ends || *std::ranges::max_element(shares) >= sure_belief ? named(shares) : std::nullopt;
    }
    std::string guess(std::span<const FingerSample> path) override {
        hear(path);
        return named(beliefs()).value_or("");
    }

private:
    Rect place(std::size_t number) const {
        const Vec2 size(surface_.width(), surface_.height());
        return {surface_.centre() + size * face_places[number].min,
                surface_.centre() + size * face_places[number].max};
    }
    static ExplorerManner manner_of(const Person& person) {
        ExplorerManner manner;
        manner.search_speed = person.search_speed_mm_s;
        manner.follow_speed = person.follow_speed_mm_s;
        manner.felt = person.threshold_n;
        return manner;
    }
    void hear(std::span<const FingerSample> path) {
        for (; heard_ < path.size(); ++heard_)
            passed_.pass({path[heard_].x_mm, path[heard_].y_mm});
    }
    ExpressionShares beliefs() const {
        if (!cues_)
            return {};
        MetCues met{};
        for (std::size_t cue = 0; cue < cue_count; ++cue)
            met[cue] = passed_.knows(static_cast<Cue>(cue));
        return ExpressionObserver::built_in().judge(*cues_, paper_choices, touch_, met);
    }
    std::optional<std::string> named(const ExpressionShares& shares) const {
        return cues_ ? std::optional(std::string(name_of(answer_of(shares)))) : std::nullopt;
    }
    static double eyes_mm(const std::vector<Contour>& contours) {
        const auto line = [&](std::string_view name) {
            const auto found = std::ranges::find(contours, name, &Contour::name);
            return found == contours.end() ? Polyline() : flatten(*found);
        };
        double apart = 1.0;
        const Polyline right = line("right_eye");
        for (const Vec2 one : line("left_eye").points)
            for (const Vec2 other : right.points)
                apart = std::max(apart, length(one - other));
        return apart;
    }

    Person person_;
    double dt_s_;
    Rect surface_;
    PassedContours passed_;
    std::size_t heard_ = 0; ///< samples of the path
    FingerTouch touch_;
    std::optional<ExpressionCues> cues_; ///< as this person takes them; nothing: it is no face
    std::size_t at_ = 0;                 ///< of face_places
    ExploringFinger finger_;
    double last_s_, time_s_ = 0.0, thinks_at_s_ = thinks_s;
};

} // namespace

std::unique_ptr<SimulatedHand> hand_for(const StudyTrial& trial, const Person& person, double dt_s,
                                        std::uint64_t seed) {
    if (trial.task == StudyTask::follow)
        return std::make_unique<Follower>(trial, person, dt_s, seed);
    if (trial.scene.contours.size() == 1)
        return std::make_unique<ShapeFeeler>(trial, person, dt_s, seed);
    return std::make_unique<FaceFeeler>(trial, person, dt_s, seed);
}

} // namespace tp
