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

/// Looks one place of the face after the other through, lane by lane, and follows what it meets; in the end it knows what the contours
/// tell of which it felt enough. The force on it is felt at once and exactly, unlike with StudyHand.
class FaceFeeler final : public SimulatedHand {
public:
    FaceFeeler(const StudyTrial& trial, const Person& person, double dt_s, std::uint64_t seed)
        : contours_(trial.scene.contours), person_(person), dt_s_(dt_s), seed_(seed),
          surface_(trial.scene.surface()), finger_(place(0), manner_of(person)),
          last_s_(trial.longest_s ? std::max(0.0, *trial.longest_s - person.answer_s - 0.05) : 1e9) {}

    Vec2 step(Vec2 finger, Vec2 force) override {
        time_s_ += dt_s_;
        if (finger_.finished() && at_ + 1 < face_places.size())
            finger_ = ExploringFinger(place(++at_), manner_of(person_));
        return finger_.step(finger, length(force) >= person_.threshold_n ? force : Vec2(0.0), dt_s_);
    }
    std::optional<std::string> knows(std::span<const FingerSample> path) override {
        return (finger_.finished() && at_ + 1 == face_places.size()) || time_s_ >= last_s_
                   ? std::optional(guess(path))
                   : std::nullopt;
    }
    std::string guess(std::span<const FingerSample> path) override {
        const auto exact = expression_cues(contours_);
        if (!exact)
            return {};
        const ExpressionObserver observer = ExpressionObserver::built_in();
        FingerTouch touch;
        touch.noise_mm = person_.touch_mm;
        touch.eyes_mm = eyes_mm();
        std::mt19937_64 random(seed_);
        ExpressionCues cues = felt(*exact, touch, random);
        for (std::size_t cue = 0; cue < cue_count; ++cue)
            if (!knows_cue(static_cast<Cue>(cue), path)) // as if it were like that of all expressions
                cues[cue] = usual(observer.model()[cue]);
        return std::string(name_of(answer_of(observer.judge(cues, paper_choices, touch))));
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
    static double usual(const ExpressionObserver::CueModel& model) {
        double sum = 0.0, count = 0.0;
        for (std::size_t e = 0; e < expression_count; ++e)
            if (paper_choices[e]) {
                sum += model.means[e];
                count += 1.0;
            }
        return sum / count;
    }
    const Contour* line(std::string_view name) const {
        const auto found = std::ranges::find(contours_, name, &Contour::name);
        return found == contours_.end() ? nullptr : &*found;
    }
    bool felt_enough(std::string_view name, std::span<const FingerSample> path) const {
        const Contour* const contour = line(name);
        if (contour == nullptr)
            return false;
        const Polyline flat = flatten(*contour);
        const Polyline places = resampled(flat, static_cast<std::size_t>(2.0 + length_of(flat) / 2.0));
        const auto passed = std::ranges::count_if(places.points, [&](Vec2 place) {
            return std::ranges::any_of(path, [&](const FingerSample& sample) {
                return length(Vec2(sample.x_mm, sample.y_mm) - place) <= passed_mm;
            });
        });
        return static_cast<double>(passed) >= enough_of_line * static_cast<double>(places.points.size());
    }
    bool knows_cue(Cue cue, std::span<const FingerSample> path) const {
        switch (cue) {
        case Cue::mouth_width:
        case Cue::outer_corner_lift:
            return felt_enough("outer_lip", path);
        case Cue::mouth_opening:
        case Cue::inner_corner_lift:
            return felt_enough("inner_lip", path);
        case Cue::lip_height:
            return felt_enough("outer_lip", path) && felt_enough("inner_lip", path);
        case Cue::chin_depth:
            return felt_enough("outline", path);
        default:
            return felt_enough("left_eye", path) && felt_enough("right_eye", path);
        }
    }
    double eyes_mm() const {
        double apart = 1.0;
        const Contour* const left = line("left_eye");
        const Contour* const right = line("right_eye");
        if (left != nullptr && right != nullptr)
            for (const Vec2 one : flatten(*left).points)
                for (const Vec2 other : flatten(*right).points)
                    apart = std::max(apart, length(one - other));
        return apart;
    }

    std::vector<Contour> contours_;
    Person person_;
    double dt_s_;
    std::uint64_t seed_;
    Rect surface_;
    std::size_t at_ = 0; ///< of face_places
    ExploringFinger finger_;
    double last_s_, time_s_ = 0.0;
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
