// SPDX-License-Identifier: Apache-2.0
// What it costs to describe a face and to find its group among many.
#include "faces/identity/face_describer.hpp"
#include "faces/identity/face_groups.hpp"
#include "faces/identity/face_square.hpp"
#include "faces/identity/unfit.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

using namespace tp;

namespace {

/// A picture of noise, and a face in it whose eyes are `eyes` px apart.
struct Pictured {
    cv::Mat picture;
    Face face;
};

Pictured pictured(double eyes) {
    const int side = static_cast<int>(4.0 * eyes);
    Pictured made{cv::Mat(side, side, CV_8UC3), {}};
    cv::RNG(1).fill(made.picture, cv::RNG::UNIFORM, 0, 256);
    const auto around = [&](const char* name, Vec2 centre) {
        std::vector<Vec2> points;
        for (int i = 0; i < 16; ++i)
            points.push_back(eyes * (centre + 0.2 * Vec2(std::cos(i * 0.393), 0.5 * std::sin(i * 0.393))));
        return contour_through(name, points, true);
    };
    made.face.box = {Vec2(eyes), Vec2(3.0 * eyes)};
    made.face.contours = {around(feature::right_eye, {1.5, 1.6}), around(feature::left_eye, {2.5, 1.6}),
                          around(feature::outer_lip, {2.0, 2.8})};
    return made;
}

void describe(benchmark::State& state) {
    const Pictured made = pictured(static_cast<double>(state.range(0)));
    FaceDescriber describer;
    describer.describe(made.picture, made.face);
    for (auto _ : state)
        benchmark::DoNotOptimize(describer.describe(made.picture, made.face));
}

/// Soft faces are sharpened first.
void describe_soft(benchmark::State& state) {
    Pictured made = pictured(static_cast<double>(state.range(0)));
    cv::GaussianBlur(made.picture, made.picture, {}, 0.08 * static_cast<double>(state.range(0)));
    FaceDescriber describer;
    describer.describe(made.picture, made.face);
    for (auto _ : state)
        benchmark::DoNotOptimize(describer.describe(made.picture, made.face));
}

void align(benchmark::State& state) {
    const Pictured made = pictured(static_cast<double>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(face_square(made.picture, *face_places(made.face)));
}

void judge(benchmark::State& state) {
    const Pictured made = pictured(static_cast<double>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(unfit_for_guessing(made.picture, made.face));
}

/// A face of one of `people` added to range(0) faces of them and taken away again.
void add_to(benchmark::State& state, std::size_t people) {
    std::mt19937 random(1);
    const auto near = [&random](const FaceNumbers& middle, double apart) {
        std::normal_distribution<double> normal(0.0, apart / std::sqrt(2.0 * descriptor_length));
        FaceNumbers numbers = middle;
        for (float& number : numbers)
            number += static_cast<float>(normal(random));
        return numbers;
    };
    std::vector<FaceNumbers> middles;
    for (std::size_t i = 0; i < people; ++i)
        middles.push_back(near({}, 0.85));
    std::int64_t id = 0;
    const auto coming = [&] {
        ComingFace face;
        face.id = face.photo = ++id;
        face.descriptor = *descriptor_of(near(middles[static_cast<std::size_t>(id) % people], 0.22));
        return face;
    };
    FaceGroups groups;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        groups.add({coming()});
    const ComingFace face = coming();
    for (auto _ : state) {
        groups.add({face});
        groups.remove(face.id);
    }
}

void add_to_few_people(benchmark::State& state) { add_to(state, 200); }
void add_to_strangers(benchmark::State& state) { add_to(state, static_cast<std::size_t>(state.range(0))); }

BENCHMARK(describe)->Arg(20)->Arg(100)->Arg(600)->Unit(benchmark::kMillisecond);
BENCHMARK(describe_soft)->Arg(20)->Arg(100)->Arg(600)->Unit(benchmark::kMillisecond);
BENCHMARK(align)->Arg(20)->Arg(100)->Arg(600)->Unit(benchmark::kMillisecond);
BENCHMARK(judge)->Arg(20)->Arg(100)->Arg(600)->Unit(benchmark::kMillisecond);
BENCHMARK(add_to_few_people)->Arg(1000)->Arg(20'000)->Unit(benchmark::kMicrosecond);
BENCHMARK(add_to_strangers)->Arg(1000)->Arg(20'000)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
