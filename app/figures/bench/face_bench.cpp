// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/face_bench.hpp"

#include "app/figures/bench/bench_clock.hpp"
#include "faces/decode/picture.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/harder_ways.hpp"
#include "faces/extract/batch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

namespace tp {

namespace {

constexpr double failure_percent = 5.0;

struct Sample {
    cv::Mat picture;
    std::vector<Contour> truth; ///< pixels of `picture`
    double decode_ms = 0.0;
};

Result<Sample> read_sample(const PlacedPortrait& portrait, int longest_px) {
    const auto begun = std::chrono::steady_clock::now();
    const Result<cv::Mat> picture = read_picture(portrait.photo);
    const std::chrono::duration<double, std::milli> decode = std::chrono::steady_clock::now() - begun;
    if (!picture)
        return Error{portrait.photo.string() + ": " + picture.error()};
    Sample sample{longest_px > 0 ? not_larger_than(*picture, longest_px) : *picture, portrait.truth,
                  decode.count()};
    const Vec2 scale(static_cast<double>(sample.picture.cols) / picture->cols,
                     static_cast<double>(sample.picture.rows) / picture->rows);
    for (Contour& contour : sample.truth)
        contour = mapped(contour, [&](Vec2 p) { return scale * p; });
    return sample;
}

/// As FaceBenchRow::features; nothing where a feature is missing.
std::optional<std::array<double, 4>> errors_of(const std::vector<Contour>& truth,
                                               const std::vector<Contour>& found) {
    const auto right = contour_error_percent(truth, found, feature::right_eye);
    const auto left = contour_error_percent(truth, found, feature::left_eye);
    const auto outer = contour_error_percent(truth, found, feature::outer_lip);
    const auto inner = contour_error_percent(truth, found, feature::inner_lip);
    const auto outline = contour_error_percent(truth, found, feature::outline);
    if (!right || !left || !outer || !inner || !outline)
        return std::nullopt;
    return std::array{0.5 * (*right + *left), *outer, *inner, *outline};
}

/// Whether the person is told that something about this face may be wrong.
bool is_doubted(const Face& face) {
    return !face.problem.empty() || std::any_of(face.quality.begin(), face.quality.end(),
                                                [](const ContourQuality& q) { return !q.reasons.empty(); });
}

Result<FaceBenchRow> weigh(const FaceContender& contender, const std::vector<PlacedPortrait>& portraits,
                           int longest_px) {
    auto extractor = FaceExtractor::create(contender.choice);
    if (!extractor)
        return Error{extractor.error()};
    FaceBenchRow row;
    row.contender = contender.name;
    row.longest_px = longest_px;
    std::vector<double> decode, detect, landmarks, edges, contours;
    int found_faces = 0;
    for (const PlacedPortrait& portrait : portraits) {
        const Result<Sample> sample = read_sample(portrait, longest_px);
        if (!sample)
            return Error{sample.error()};
        const Extraction found = extractor->extract(sample->picture);
        ++row.photos;
        decode.push_back(sample->decode_ms);
        detect.push_back(found.milliseconds.detect);
        landmarks.push_back(found.milliseconds.landmarks);
        edges.push_back(found.milliseconds.edges);
        contours.push_back(found.milliseconds.contours);
        const auto errors =
            found.faces.empty() ? std::nullopt : errors_of(sample->truth, found.faces.front().contours);
        if (!errors) {
            ++row.failures;
            continue;
        }
        ++found_faces;
        const double worst = *std::max_element(errors->begin(), errors->end());
        row.failures += worst > failure_percent ? 1 : 0;
        row.worst_percent = std::max(row.worst_percent, worst);
        for (std::size_t f = 0; f < errors->size(); ++f)
            row.error_percent[f] += (*errors)[f];
    }
    for (double& error : row.error_percent)
        error = found_faces > 0 ? error / found_faces : std::nan("");
    row.decode_ms = quantile(std::move(decode), 0.5);
    row.detect_ms = quantile(std::move(detect), 0.5);
    row.landmarks_ms = quantile(std::move(landmarks), 0.5);
    row.edges_ms = quantile(std::move(edges), 0.5);
    row.contours_ms = quantile(std::move(contours), 0.5);
    return row;
}

} // namespace

double FaceBenchRow::mean_error_percent() const {
    double sum = 0.0;
    for (const double error : error_percent)
        sum += error;
    return sum / static_cast<double>(error_percent.size());
}

std::vector<FaceContender> face_contenders() {
    using enum RefinementStage;
    return {{"embedded", {}},
            {"embedded_without_edges", {"embedded", "embedded", close_looks}},
            {"embedded_two_looks", {"embedded", "embedded", second_look}},
            {"embedded_one_look", {"embedded", "embedded", first_look}},
            {"yunet_and_embedded", {"yunet", "embedded"}},
            {"mesh", {"embedded", "mesh"}},
            {"mesh_without_edges", {"embedded", "mesh", close_looks}}};
}

Result<std::vector<FaceBenchRow>> run_face_bench(const std::vector<PlacedPortrait>& portraits,
                                                 const std::vector<FaceContender>& contenders,
                                                 const std::vector<int>& longest_px,
                                                 const std::function<void(const std::string&)>& progress) {
    std::vector<FaceBenchRow> rows;
    for (const FaceContender& contender : contenders)
        for (const int longest : longest_px) {
            progress(contender.name +
                     (longest > 0 ? ", " + std::to_string(longest) + " px" : ", as they are"));
            const Result<FaceBenchRow> row = weigh(contender, portraits, longest);
            if (!row)
                return Error{row.error()};
            rows.push_back(*row);
        }
    return rows;
}

Result<std::vector<HarderRow>> run_harder_bench(const std::vector<PlacedPortrait>& portraits,
                                                const std::vector<FaceContender>& contenders,
                                                const std::function<void(const std::string&)>& progress) {
    std::vector<FaceExtractor> extractors;
    for (const FaceContender& contender : contenders) {
        auto extractor = FaceExtractor::create(contender.choice);
        if (!extractor)
            return Error{extractor.error()};
        extractors.push_back(std::move(*extractor));
    }
    std::vector<HarderRow> rows;
    std::vector<int> compared; // by way: portraits in which every contender found a face
    for (std::size_t i = 0; i < portraits.size(); ++i) {
        progress("harder: " + portraits[i].photo.filename().string());
        const Result<Sample> sample = read_sample(portraits[i], 0);
        if (!sample)
            return Error{sample.error()};
        const std::vector<Degraded> ways =
            harder_ways(sample->picture, sample->truth, static_cast<unsigned>(i));
        for (std::size_t w = 0; w < ways.size(); ++w) {
            if (compared.size() <= w) {
                compared.push_back(0);
                for (const FaceContender& contender : contenders)
                    rows.push_back({ways[w].how, contender.name});
            }
            std::vector<std::optional<std::array<double, 4>>> errors;
            for (std::size_t c = 0; c < extractors.size(); ++c) {
                HarderRow& row = rows[w * contenders.size() + c];
                const Extraction found = extractors[c].extract(ways[w].picture);
                errors.push_back(found.faces.empty()
                                     ? std::nullopt
                                     : errors_of(ways[w].truth, found.faces.front().contours));
                ++row.photos;
                row.found += errors.back() ? 1 : 0;
                row.failures += !errors.back() || *std::max_element(errors.back()->begin(),
                                                                    errors.back()->end()) > failure_percent;
                row.said += !found.faces.empty() && is_doubted(found.faces.front());
            }
            if (!std::all_of(errors.begin(), errors.end(), [](const auto& e) { return e.has_value(); }))
                continue;
            ++compared[w];
            for (std::size_t c = 0; c < errors.size(); ++c)
                for (std::size_t f = 0; f < errors[c]->size(); ++f)
                    rows[w * contenders.size() + c].error_percent[f] += (*errors[c])[f];
        }
    }
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (double& error : rows[r].error_percent)
            error =
                compared[r / contenders.size()] > 0 ? error / compared[r / contenders.size()] : std::nan("");
    return rows;
}

Result<std::vector<BatchSpeed>> run_batch_bench(const std::vector<PlacedPortrait>& portraits) {
    std::vector<std::filesystem::path> files;
    for (const PlacedPortrait& portrait : portraits)
        files.push_back(portrait.photo);
    std::vector<BatchSpeed> speeds;
    for (const std::size_t threads :
         {std::size_t(1), std::size_t(std::max(2U, std::thread::hardware_concurrency()))}) {
        std::vector<FaceExtractor> extractors;
        for (std::size_t i = 0; i < threads; ++i) {
            auto extractor = FaceExtractor::create();
            if (!extractor)
                return Error{extractor.error()};
            extractors.push_back(std::move(*extractor));
        }
        const std::atomic<bool> stop{false};
        const auto begun = std::chrono::steady_clock::now();
        const auto done = extract_batch(
            std::move(extractors), files, [](std::size_t, const Extraction&) { return true; }, stop);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
        if (!done)
            return Error{done.error()};
        speeds.push_back({threads, static_cast<double>(*done) / took.count()});
    }
    return speeds;
}

} // namespace tp
