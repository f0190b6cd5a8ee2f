// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/identity_bench.hpp"

#include "app/figures/bench/bench_clock.hpp"
#include "core/geometry/flatten.hpp"
#include "faces/base/face.hpp"
#include "faces/decode/picture.hpp"
#include "faces/evaluation/harder_ways.hpp"
#include "faces/evaluation/training_half.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/identity/face_describer.hpp"
#include "faces/identity/face_groups.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace tp {
namespace {

constexpr std::array<int, 3> face_sizes_px{60, 40, 25}; ///< of its box

/// The face's own contours as straight pieces: what is made harder asks for those that a hand has placed.
std::vector<Contour> straight(const std::vector<Contour>& contours) {
    std::vector<Contour> all;
    all.reserve(contours.size());
    for (const Contour& contour : contours)
        all.push_back(contour_through(contour.name, flatten(contour).points, contour.closed));
    return all;
}

std::vector<Degraded> ways_of(const cv::Mat& picture, const Face& face, unsigned seed) {
    std::vector<Degraded> ways = harder_ways(picture, straight(face.contours), seed);
    for (const int px : face_sizes_px) {
        const double scale = px / std::max(face.box.width(), face.box.height());
        Degraded small{"face " + std::to_string(px) + " px", {}, {}};
        cv::resize(picture, small.picture, {}, scale, scale, cv::INTER_AREA);
        ways.push_back(std::move(small));
    }
    return ways;
}

class Describing {
public:
    explicit Describing(FaceExtractor extractor) : extractor_(std::move(extractor)) {}

    /// The largest face of the picture, into `portrait`.
    void describe(const cv::Mat& picture, DescribedPortrait& portrait) {
        const Extraction found = extractor_.extract(picture);
        if (found.faces.empty())
            return;
        const cv::Mat upright = turned(picture, found.turned_degrees);
        const BusyClock clock;
        const auto numbers = describer_.describe(upright, found.faces.front());
        ms_.push_back(1e-6 * clock.ns());
        portrait.unfit = unfit_for_guessing(upright, found.faces.front());
        portrait.found = numbers.has_value();
        if (numbers)
            portrait.numbers = *numbers;
    }
    Extraction extract(const cv::Mat& picture) { return extractor_.extract(picture); }
    double median_ms() const { return quantile(ms_, 0.5); }

private:
    FaceExtractor extractor_;
    FaceDescriber describer_;
    std::vector<double> ms_;
};

} // namespace

Result<IdentityBench> run_identity_bench(const std::vector<std::filesystem::path>& files,
                                         const std::function<void(const std::string&)>& progress,
                                         const std::atomic<bool>& stop) {
    auto extractor = FaceExtractor::create();
    if (!extractor)
        return Error{extractor.error()};
    Describing describing(std::move(*extractor));
    IdentityBench bench;
    for (std::size_t i = 0; i < files.size() && !stop; ++i) {
        const std::string name = files[i].filename().string();
        progress("same person: " + name);
        const Result<cv::Mat> picture = read_picture(files[i]);
        if (!picture)
            return Error{files[i].string() + ": " + picture.error()};
        const std::string person = person_in(files[i]);
        const Extraction found = describing.extract(*picture);
        if (found.faces.empty() || found.turned_degrees != 0) {
            bench.portraits.push_back({person, name, as_it_is});
            continue;
        }
        for (const Degraded& way : ways_of(*picture, found.faces.front(), static_cast<unsigned>(i))) {
            bench.portraits.push_back({person, name, way.how});
            describing.describe(way.picture, bench.portraits.back());
        }
    }
    bench.describe_ms = describing.median_ms();
    return bench;
}

double face_adding_ms(std::size_t faces, std::size_t people) {
    std::mt19937 random(1);
    const auto near = [&random](const FaceNumbers& middle, double apart) {
        std::normal_distribution<double> normal(0.0, apart / std::sqrt(2.0 * descriptor_length));
        FaceNumbers numbers = middle;
        for (float& number : numbers)
            number += static_cast<float>(normal(random));
        return numbers;
    };
    constexpr double between_people = 0.85, between_portraits = 0.22; // means of the London set
    std::vector<FaceNumbers> middles;
    for (std::size_t i = 0; i < people; ++i)
        middles.push_back(near({}, between_people));
    std::vector<ComingFace> all(faces);
    for (std::size_t i = 0; i < faces; ++i) {
        all[i].id = all[i].photo = static_cast<FaceId>(i);
        all[i].descriptor =
            descriptor_of(near(middles[i % people], between_portraits)).value_or(FaceDescriptor{});
    }
    FaceGroups groups;
    const std::size_t last = faces - faces / 10;
    for (std::size_t i = 0; i < last; ++i)
        groups.add({all[i]});
    const BusyClock clock;
    for (std::size_t i = last; i < faces; ++i)
        groups.add({all[i]});
    return 1e-6 * clock.ns() / static_cast<double>(faces - last);
}

} // namespace tp
