// SPDX-License-Identifier: Apache-2.0
#include "faces/face_extractor.hpp"

#include "faces/contour_fit.hpp"
#include "faces/contour_nets.hpp"
#include "faces/covered_eye.hpp"
#include "faces/covered_mouth.hpp"
#include "faces/edge_fit.hpp"
#include "faces/embedded_detector.hpp"
#include "faces/extra_features.hpp"
#include "faces/face_problem.hpp"
#include "faces/fewest_pieces.hpp"
#include "faces/haar_detector.hpp"
#include "faces/lbf_model.hpp"
#include "faces/mesh_model.hpp"
#include "faces/model_catalog.hpp"
#include "faces/picture.hpp"
#include "faces/quality.hpp"
#include "faces/quiet_opencv.hpp"
#include "faces/yunet_detector.hpp"

#include <algorithm>
#include <chrono>

namespace tp {
namespace {

constexpr int smallest_side_px = 16;         ///< of a picture that can hold a face
constexpr double contour_tolerance_px = 0.2; ///< a fifth of what a net or a hand can place
constexpr double least_confidence = 0.5;
/// Of a face in a picture that had to be turned: three more looks would make three times the false alarms.
/// Nine in ten faces from 40 px on reach 0.98 (plausibility.cpp).
constexpr double least_confidence_turned = 0.95;
/// In which a picture is first looked at on its side: a face of 40 px in it can be felt.
constexpr int longest_turned_px = 1280;
/// What a photograph keeps of its longest side where its decoder shrinks it: the detector looks at 1280 px.
constexpr int longest_shrunk_px = 1600;
/// Of faces for which the shrunk pixels are enough: eyes that are 150 px apart, outer corner to outer corner.
/// Contours are as exact from there on (faces/README.md, errors over the size of the picture).
constexpr double least_shrunk_face_px = 300.0;
constexpr double same_within = 0.4; ///< of a face's size; two heads cannot be that near

/// Somebody asked the search to stop.
struct Stopped {};

void stop_if_asked(const std::stop_token& stop) {
    if (stop.stop_requested())
        throw Stopped();
}

Result<std::unique_ptr<Detector>> load_detector(const ChosenModel& model) {
    return model.kind == &haar_model ? HaarDetector::load(model.file) : YunetDetector::load(model.file);
}

Result<std::unique_ptr<LandmarkModel>> load_landmarks(const ChosenModel& model) {
    return model.kind == &lbf_model ? LbfModel::load(model.file) : MeshModel::load(model.file);
}

Result<std::unique_ptr<Detector>> make_detector(const std::string& choice) {
    if (choice == "embedded")
        return std::unique_ptr<Detector>(std::make_unique<EmbeddedDetector>());
    const auto model = find_model(choice, PluggableModel::Role::detector);
    return model ? load_detector(*model) : Error{model.error()};
}

Result<std::unique_ptr<LandmarkModel>> make_model(const ExtractorChoice& choice) {
    if (choice.model == "embedded")
        return std::unique_ptr<LandmarkModel>(std::make_unique<ContourNets>(choice.refinement));
    const auto model = find_model(choice.model, PluggableModel::Role::landmarks);
    return model ? load_landmarks(*model) : Error{model.error()};
}

/// What is covered is where it would be in such a face.
void guess_covered(FaceLines& lines, const Landmarks& points, const QualitySigns& signs) {
    if (is_guessed(signs, at_right_eye))
        lines.right_eye = lines_through(with_guessed_eye(points, at_right_eye)).right_eye;
    if (is_guessed(signs, at_left_eye))
        lines.left_eye = lines_through(with_guessed_eye(points, at_left_eye)).left_eye;
    if (is_guessed(signs, at_outer_lip)) {
        const FaceLines guess = lines_through(with_guessed_lips(points));
        lines.outer_lip = guess.outer_lip;
        lines.inner_lip = guess.inner_lip;
    }
}

/// Milliseconds since it was made or last asked.
class Stopwatch {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double passed = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return passed;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::vector<Contour> contours_of(const FaceLines& lines, double tolerance_px) {
    const auto opening = [tolerance_px](const char* name, const Opening& edges) {
        const std::size_t corner = edges.lower.size() - 1;
        return fewest_pieces(name, uncrossed(edges.around(), corner), true, {0, corner}, tolerance_px);
    };
    return {opening(feature::left_eye, lines.left_eye), opening(feature::right_eye, lines.right_eye),
            opening(feature::outer_lip, lines.outer_lip), opening(feature::inner_lip, lines.inner_lip),
            fewest_pieces(feature::outline, lines.outline, false, {}, tolerance_px)};
}

/// One for each of the contours, in their order.
std::vector<ContourQuality> qualities_of(const QualitySigns& signs) {
    return {quality_of(signs, at_left_eye), quality_of(signs, at_right_eye), quality_of(signs, at_outer_lip),
            quality_of(signs, at_inner_lip), quality_of(signs, at_outline)};
}

/// A face of a picture that is `shrink` times smaller, in places of the whole one.
void enlarge(Face& face, double shrink) {
    const auto whole = [shrink](Vec2 place) { return shrink * place; };
    face.box = {whole(face.box.min), whole(face.box.max)};
    for (auto* const contours : {&face.contours, &face.extras})
        for (Contour& contour : *contours)
            contour = mapped(contour, whole);
}

struct LocatedFace {
    Detection detection;
    Landmarks points;

    Vec2 centre() const {
        return 0.25 * (points.right_eye[0] + points.left_eye[0] + points.outer_lip[0] +
                       points.outer_lip[mouth_corner]);
    }
};

bool is_same(const LocatedFace& a, const LocatedFace& b) {
    return length(a.centre() - b.centre()) < same_within * std::max(a.detection.size(), b.detection.size());
}

/// What `search` says; where it throws, there are no faces, a sentence that says why, and true.
template <typename Search>
bool carefully(Extraction& result, Search search) {
    try {
        return search();
    } catch (const Stopped&) {
        result.faces.clear();
        result.problem = "The search for faces was stopped.";
    } catch (const std::exception& reason) {
        result.faces.clear();
        result.problem = std::string("The search for faces failed (") + reason.what() + ").";
    }
    return true;
}

} // namespace

struct FaceExtractor::Parts {
    std::unique_ptr<Detector> detector;
    std::unique_ptr<LandmarkModel> model;
    bool edges = true;

    /// The detected faces that the landmarks confirm, the largest first. Boxes of different size that led to
    /// the same eyes and mouth count once.
    std::vector<LocatedFace> confirmed(const cv::Mat& picture, std::vector<Detection> detections,
                                       const std::stop_token& stop) const {
        std::stable_sort(detections.begin(), detections.end(),
                         [](const Detection& a, const Detection& b) { return a.score > b.score; });
        std::vector<LocatedFace> located;
        for (const Detection& detection : detections) {
            stop_if_asked(stop);
            auto points = model->locate(picture, detection);
            if (!points || points->confidence < least_confidence)
                continue;
            LocatedFace face{detection, std::move(*points)};
            if (std::none_of(located.begin(), located.end(),
                             [&](const LocatedFace& other) { return is_same(face, other); }))
                located.push_back(std::move(face));
        }
        std::stable_sort(located.begin(), located.end(), [](const LocatedFace& a, const LocatedFace& b) {
            return a.detection.size() > b.detection.size();
        });
        return located;
    }

    /// Looks thoroughly, where `most` allows it, only if a usual look finds no face.
    std::vector<LocatedFace> locate(const cv::Mat& picture, Effort most, ExtractionTimes& times,
                                    const std::stop_token& stop) const {
        Looks looks;
        std::vector<Detection> refused; // the landmarks would say the same of them again
        for (const Effort effort : {Effort::usual, Effort::thorough}) {
            stop_if_asked(stop);
            Stopwatch watch;
            std::vector<Detection> detections = detector->detect(picture, effort, looks, stop);
            std::erase_if(detections, [&](const Detection& detection) {
                return std::find(refused.begin(), refused.end(), detection) != refused.end();
            });
            times.detect += watch.lap();
            std::vector<LocatedFace> located = confirmed(picture, detections, stop);
            times.landmarks += watch.lap();
            if (!located.empty() || effort == most)
                return located;
            refused = std::move(detections);
        }
        return {};
    }

    static double surest(const std::vector<LocatedFace>& located) {
        double best = 0.0;
        for (const LocatedFace& face : located)
            best = std::max(best, face.points.confidence);
        return best;
    }

    /// Those faces of a turned picture that are sure enough to believe that it had to be turned.
    std::vector<LocatedFace> locate_turned(const cv::Mat& turned_picture, ExtractionTimes& times,
                                           const std::stop_token& stop) const {
        std::vector<LocatedFace> located = locate(turned_picture, Effort::usual, times, stop);
        std::erase_if(located, [](const LocatedFace& face) {
            return face.points.confidence < least_confidence_turned;
        });
        return located;
    }

    /// Where no face is sure, the picture may stand on its side or its head: a scan, or a camera that noted
    /// nothing. (The nets, which know nothing else, see an upright face in some that stand on their head.)
    /// Turns `picture` where that makes a face surer than the best of `located`; first a small copy of it,
    /// because it seldom does.
    void look_turned(cv::Mat& picture, std::vector<LocatedFace>& located, Extraction& result,
                     const std::stop_token& stop) const {
        cv::Mat small = not_larger_than(picture, longest_turned_px);
        double best = surest(located);
        int best_degrees = 0, small_degrees = 0;
        for (const int degrees : {180, 90, 270}) {
            small = turned(small, (degrees - small_degrees + 360) % 360);
            small_degrees = degrees;
            const double here = surest(locate_turned(small, result.milliseconds, stop));
            if (here > best) {
                best = here;
                best_degrees = degrees;
            }
        }
        if (best_degrees == 0)
            return;
        const cv::Mat upright = turned(picture, best_degrees);
        std::vector<LocatedFace> there = locate_turned(upright, result.milliseconds, stop);
        if (there.empty())
            return;
        located = std::move(there);
        picture = upright;
        result.turned_degrees = best_degrees;
        result.width = picture.cols;
        result.height = picture.rows;
    }

    void extract(cv::Mat picture, Extraction& result, const std::stop_token& stop) const {
        std::vector<LocatedFace> located = locate(picture, Effort::thorough, result.milliseconds, stop);
        if (surest(located) < least_confidence_turned)
            look_turned(picture, located, result, stop);
        describe(picture, located, contour_tolerance_px, result, stop);
    }

    /// The same from fewer pixels, where the faces are sure and large enough in these; false: they are not.
    bool extract_shrunk(const ShrunkPicture& picture, Extraction& result, const std::stop_token& stop) const {
        const std::vector<LocatedFace> located =
            locate(picture.pixels, Effort::usual, result.milliseconds, stop);
        if (surest(located) < least_confidence_turned ||
            std::ranges::any_of(located, [](const LocatedFace& face) {
                return face.detection.size() < least_shrunk_face_px;
            }))
            return false;
        describe(picture.pixels, located, contour_tolerance_px / picture.shrink, result, stop);
        for (Face& face : result.faces)
            enlarge(face, picture.shrink);
        return true;
    }

    void describe(const cv::Mat& picture, const std::vector<LocatedFace>& located, double tolerance_px,
                  Extraction& result, const std::stop_token& stop) const {
        Stopwatch watch;
        for (const LocatedFace& face : located) {
            stop_if_asked(stop);
            FaceLines lines = lines_through(face.points);
            EdgeReports seen;
            if (edges)
                lines = on_edges(picture, std::move(lines), &seen);
            result.milliseconds.edges += watch.lap();
            const QualitySigns signs = signs_of(face.points, seen, picture);
            guess_covered(lines, face.points, signs);
            std::string problem = problem_of(face.detection, face.points, picture.size());
            if (problem.empty() && edges)
                problem = problem_of(signs);
            result.faces.push_back({face.detection.box,
                                    face.detection.score,
                                    contours_of(lines, tolerance_px),
                                    std::move(problem),
                                    qualities_of(signs),
                                    {},
                                    extra_contours(face.points, lines, tolerance_px)});
            result.milliseconds.contours += watch.lap();
        }
        result.problem =
            result.faces.empty() ? "No face was found in this picture." : result.faces.front().problem;
    }
};

FaceExtractor::FaceExtractor(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
FaceExtractor::FaceExtractor(FaceExtractor&&) noexcept = default;
FaceExtractor& FaceExtractor::operator=(FaceExtractor&&) noexcept = default;
FaceExtractor::~FaceExtractor() = default;

Result<FaceExtractor> FaceExtractor::create(const ExtractorChoice& choice) {
    try {
        quiet_opencv();
        auto detector = make_detector(choice.detector);
        if (!detector)
            return Error{detector.error()};
        auto model = make_model(choice);
        if (!model)
            return Error{model.error()};
        auto parts = std::make_unique<Parts>();
        parts->detector = std::move(*detector);
        parts->model = std::move(*model);
        parts->edges = choice.refinement == Refinement::onto_edges;
        return FaceExtractor(std::move(parts));
    } catch (const std::exception& reason) {
        return Error{std::string("The nets that find faces cannot be used: ") + reason.what()};
    }
}

std::string problem_with_model(const PluggableModel& model, const std::filesystem::path& file) {
    quiet_opencv();
    return model.role == PluggableModel::Role::detector ? load_detector({&model, file}).error()
                                                        : load_landmarks({&model, file}).error();
}

Extraction FaceExtractor::extract(const std::filesystem::path& photo, const std::stop_token& stop) {
    Stopwatch watch;
    double decode = 0.0;
    Extraction result;
    Result<ShrunkPicture> shrunk = read_picture_shrunk(photo, longest_shrunk_px);
    decode += watch.lap();
    if (!shrunk) {
        result.problem = shrunk.error();
    } else if (shrunk->shrink == 1) {
        result = extract(shrunk->pixels, stop);
    } else {
        result.width = shrunk->size.width;
        result.height = shrunk->size.height;
        const bool enough = carefully(result, [&] { return parts_->extract_shrunk(*shrunk, result, stop); });
        if (!enough) {
            const ExtractionTimes in_vain = result.milliseconds;
            shrunk->pixels.release();
            watch.lap();
            const Result<cv::Mat> picture = read_picture(photo);
            decode += watch.lap();
            result = picture ? extract(*picture, stop) : Extraction{};
            if (!picture)
                result.problem = picture.error();
            result.milliseconds.detect += in_vain.detect;
            result.milliseconds.landmarks += in_vain.landmarks;
        }
    }
    result.milliseconds.decode = decode;
    return result;
}

Extraction FaceExtractor::extract(const cv::Mat& picture, const std::stop_token& stop) {
    Extraction result;
    result.width = picture.cols;
    result.height = picture.rows;
    if (picture.empty()) {
        result.problem = "The picture is empty.";
        return result;
    }
    if (picture.type() != CV_8UC3) {
        result.problem = "The picture is not in 8-bit colour.";
        return result;
    }
    if (std::min(picture.cols, picture.rows) < smallest_side_px) {
        result.problem = "The picture is only " + std::to_string(picture.cols) + " × " +
                         std::to_string(picture.rows) + " pixels, too small to show a face.";
        return result;
    }
    carefully(result, [&] {
        parts_->extract(picture, result, stop);
        return true;
    });
    return result;
}

} // namespace tp
