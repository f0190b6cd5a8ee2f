// SPDX-License-Identifier: Apache-2.0
#include "faces/extract/face_extractor.hpp"

#include "faces/base/freed_memory.hpp"
#include "faces/contours/contour_nets.hpp"
#include "faces/contours/dark_glasses.hpp"
#include "faces/contours/hidden_jaw.hpp"
#include "faces/contours/mesh_model.hpp"
#include "faces/contours/second_opinion.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "faces/detect/yunet_detector.hpp"
#include "faces/edges/edge_fit.hpp"
#include "faces/extract/face_search.hpp"
#include "faces/extract/stopwatch.hpp"
#include "faces/judge/covered.hpp"
#include "faces/judge/face_problem.hpp"
#include "faces/judge/quality.hpp"
#include "faces/models/model_catalog.hpp"
#include "faces/pieces/contour_fit.hpp"
#include "faces/pieces/extra_features.hpp"
#include "faces/pieces/fewest_pieces.hpp"

#include <algorithm>

namespace tp {
namespace {

constexpr int smallest_side_px = 16;         ///< of a picture that can hold a face
constexpr double contour_tolerance_px = 0.2; ///< a fifth of what a net or a hand can place
/// In which a picture is first looked at on its side: a face of 40 px in it can be felt.
constexpr int longest_turned_px = 1280;
/// To which a face that is unsure is shrunk there: one half as large is still found.
constexpr double turned_face_px = 96.0;
/// What a photograph keeps of its longest side where its decoder shrinks it: the detector looks at 1280 px.
constexpr int longest_shrunk_px = 1600;
/// Of faces for which the shrunk pixels are enough: eyes that are 150 px apart, outer corner to outer corner.
/// Contours are as exact from there on (faces/FIGURES.md, errors over the size of the picture).
constexpr double least_shrunk_face_px = 300.0;
/// Few people wear any: half of those from whom the net learned did.
constexpr double least_evidence_of_glasses = 1.0;

Result<std::unique_ptr<Detector>> make_detector(const std::string& choice) {
    if (choice == "embedded")
        return std::unique_ptr<Detector>(std::make_unique<EmbeddedDetector>());
    if (choice == "yunet")
        return std::unique_ptr<Detector>(std::make_unique<YunetDetector>(embedded_net(EmbeddedModel::yunet)));
    return Error{"There is no detector named \"" + choice + "\": choose \"embedded\" or \"yunet\"."};
}

std::string unusable(const std::exception& reason) {
    return std::string("The nets that find faces cannot be used: ") + reason.what();
}

/// What is covered is where the mesh sees it, and not on an edge of what covers it.
void uncover(FaceLines& lines, const Landmarks& mesh, const QualitySigns& signs) {
    const bool right = is_covered(signs, at_right_eye), left = is_covered(signs, at_left_eye),
               mouth = is_covered(signs, at_outer_lip);
    if (!right && !left && !mouth)
        return;
    const FaceLines seen = lines_through(mesh);
    if (right)
        lines.right_eye = seen.right_eye;
    if (left)
        lines.left_eye = seen.left_eye;
    if (mouth) {
        lines.outer_lip = seen.outer_lip;
        lines.inner_lip = seen.inner_lip;
    }
}

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

/// The longer side, px, in which a picture is looked at on its side: less where there is something to compare.
int side_to_turn(cv::Size picture, const std::vector<LocatedFace>& located) {
    if (located.empty())
        return longest_turned_px;
    const double side =
        std::max(picture.width, picture.height) * turned_face_px / located.front().detection.size();
    return static_cast<int>(std::min(side, static_cast<double>(longest_turned_px)));
}

/// What `search` says; where it throws, there are no faces, a sentence that says why, and true.
template <typename Search>
bool carefully(Extraction& result, Search search) {
    try {
        return search();
    } catch (const SearchStopped&) {
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
    std::unique_ptr<LandmarkModel> model;
    // Where the model is ours, and its most refined.
    std::unique_ptr<SecondOpinion> second;
    std::unique_ptr<DarkGlasses> glasses;
    std::unique_ptr<HiddenJaw> jaws = std::make_unique<HiddenJaw>();
    std::unique_ptr<FaceSearch> search;
    bool edges = true;

    /// Gives back what is made anew when it is asked for.
    void rest() const {
        jaws->rest();
        if (second) {
            glasses->rest();
            second->rest();
        } else {
            give_back_freed_memory();
        }
    }

    /// Where no face is sure, the picture may stand on its side or its head: a scan, or a camera that noted
    /// nothing. (The nets, which know nothing else, see an upright face in some that stand on their head.)
    /// Turns `picture` where that makes a face surer than the best of `located`; first a small copy of it,
    /// because it seldom does.
    void look_turned(cv::Mat& picture, std::vector<LocatedFace>& located, Extraction& result,
                     SearchTimes& times, const std::stop_token& stop) const {
        rest();
        cv::Mat small = not_larger_than(picture, side_to_turn(picture.size(), located));
        double best = surest(located);
        int best_degrees = 0, small_degrees = 0;
        for (const int degrees : {180, 90, 270}) {
            small = turned(small, (degrees - small_degrees + 360) % 360);
            small_degrees = degrees;
            const double here = surest(search->turned(small, times, stop));
            if (here > best) {
                best = here;
                best_degrees = degrees;
            }
        }
        if (best_degrees == 0)
            return;
        const cv::Mat upright = turned(picture, best_degrees);
        std::vector<LocatedFace> there = search->turned(upright, times, stop);
        if (there.empty())
            return;
        located = std::move(there);
        picture = upright;
        result.turned_degrees = best_degrees;
        result.width = picture.cols;
        result.height = picture.rows;
    }

    void extract(cv::Mat picture, Extraction& result, const std::stop_token& stop) const {
        SearchTimes times;
        std::vector<LocatedFace> located = search->upright(picture, Effort::thorough, times, stop);
        if (surest(located) < least_confidence_turned)
            look_turned(picture, located, result, times, stop);
        add(times, result);
        describe(picture, std::move(located), contour_tolerance_px, result, stop);
    }

    /// The same from fewer pixels, where the faces are sure and large enough in these; false: they are not.
    bool extract_shrunk(const ShrunkPicture& picture, Extraction& result, const std::stop_token& stop) const {
        SearchTimes times;
        std::vector<LocatedFace> located = search->upright(picture.pixels, Effort::usual, times, stop);
        add(times, result);
        if (surest(located) < least_confidence_turned ||
            std::ranges::any_of(located, [](const LocatedFace& face) {
                return face.detection.size() < least_shrunk_face_px;
            }))
            return false;
        describe(picture.pixels, std::move(located), contour_tolerance_px / picture.shrink, result, stop);
        for (Face& face : result.faces)
            enlarge(face, picture.shrink);
        return true;
    }

    static void add(const SearchTimes& times, Extraction& result) {
        result.milliseconds.detect += times.detect;
        result.milliseconds.landmarks += times.landmarks;
    }

    /// A face's lines, and what they tell about themselves.
    struct Drawn {
        FaceLines lines;
        QualitySigns signs;
    };
    Drawn drawn(const cv::Mat& picture, const Landmarks& points) const {
        FaceLines lines = lines_through(points);
        EdgeReports seen;
        if (edges)
            lines = on_edges(picture, std::move(lines), &seen);
        return {std::move(lines), signs_of(points, seen, picture)};
    }

    void describe(const cv::Mat& picture, std::vector<LocatedFace> located, double tolerance_px,
                  Extraction& result, const std::stop_token& stop) const {
        Stopwatch watch;
        for (LocatedFace& face : located) {
            if (stop.stop_requested())
                throw SearchStopped();
            Drawn seen = drawn(picture, face.points);
            result.milliseconds.edges += watch.lap();
            const bool is_doubtful = second && (face.mesh || !is_sure(seen.signs));
            if (is_doubtful && !face.mesh) {
                if (auto opinions = second->about(picture, face.detection, &face.points)) {
                    face.points = std::move(opinions->settled);
                    face.mesh = std::move(opinions->mesh);
                }
                result.milliseconds.landmarks += watch.lap();
                if (face.mesh)
                    seen = drawn(picture, face.points);
                result.milliseconds.edges += watch.lap();
            }
            if (edges)
                seen.signs.jaw = jaws->cover(picture, face.points);
            if (is_doubtful)
                seen.signs.dark_glasses = glasses->evidence(picture, face.points) > least_evidence_of_glasses;
            if (face.mesh)
                uncover(seen.lines, *face.mesh, seen.signs);
            std::string problem = problem_of(face.detection, face.points, picture.size());
            if (problem.empty() && edges)
                problem = problem_of(seen.signs);
            result.faces.push_back({face.detection.box,
                                    face.detection.score,
                                    contours_of(seen.lines, tolerance_px),
                                    std::move(problem),
                                    qualities_of(seen.signs),
                                    {},
                                    extra_contours(face.points, seen.lines, tolerance_px)});
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
        auto parts = std::make_unique<Parts>();
        parts->edges = choice.refinement == RefinementStage::onto_edges;
        if (choice.model == "embedded") {
            auto nets = std::make_unique<ContourNets>(choice.refinement);
            if (parts->edges) {
                parts->second = std::make_unique<SecondOpinion>(*nets);
                parts->glasses = std::make_unique<DarkGlasses>();
            }
            parts->model = std::move(nets);
        } else if (choice.model == "mesh") {
            parts->model = std::make_unique<MeshModel>(embedded_net(EmbeddedModel::mesh));
        } else {
            return Error{"There is no model named \"" + choice.model +
                         "\": choose \"embedded\" or \"mesh\"."};
        }
        parts->search =
            std::make_unique<FaceSearch>(std::move(*detector), *parts->model, parts->second.get());
        return FaceExtractor(std::move(parts));
    } catch (const std::exception& reason) {
        return Error{unusable(reason)};
    }
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
            parts_->rest(); // the whole picture and the mesh need not be there at once
            watch.lap();
            const Result<cv::Mat> picture = shrunk->whole();
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

std::string FaceExtractor::problem() {
    try {
        const cv::Mat blank = cv::Mat::zeros(64, 64, CV_8UC3);
        SearchTimes times;
        parts_->search->upright(blank, Effort::usual, times, {});
        parts_->model->locate(blank, {{{16.0, 16.0}, {48.0, 48.0}}, {26.0, 28.0}, {38.0, 28.0}, 1.0});
        return {};
    } catch (const std::exception& reason) {
        return unusable(reason);
    }
}

} // namespace tp
