// SPDX-License-Identifier: Apache-2.0
#include "faces/detect/embedded_detector.hpp"

#include "faces/detect/detector_answer.hpp"
#include "faces/detect/shrunk_rows.hpp"
#include "faces/models/model_catalog.hpp"

#include <opencv2/imgproc.hpp>

#include <array>
#include <cmath>

namespace tp {
namespace {

constexpr std::array levels{160, 320, 640, 1280}; ///< longer side of what the net is shown, px
constexpr std::size_t kept_levels = 2;            ///< whose nets are kept
constexpr int usual_finest = 640; ///< pictures are shrunk to about this before they are shrunk further
/// Of the longer side of a picture, how far it is shrunk for a thorough look: a face of 40 px is then as
/// large as the net knows them.
constexpr double thorough_share = 0.4;
constexpr int tile = 640, tile_overlap = 128; ///< px; a tile takes a twentieth of the memory of 50 megapixel
constexpr int largest_part = 640;             ///< px, of a finer level: 1280 px at once would take 65 MB
constexpr double large_face = 48.0;           ///< px of a level: four times the smallest face that is found
constexpr double sure_score = 0.6;            ///< of a face for which finer levels are left out
constexpr double unit_face = 40.0; ///< px; sizes are answered as the logarithm of a multiple of this
constexpr double least_score = 0.3;
constexpr double most_overlap = 0.35;

/// 1 / (1 + exp(-x))
cv::Mat logistic(const cv::Mat& x) {
    cv::Mat result;
    cv::exp(-x, result);
    return 1.0 / (1.0 + result);
}

/// Itself where it has that size.
cv::Mat resized(const cv::Mat& picture, int longer) {
    if (longer == std::max(picture.cols, picture.rows))
        return picture;
    cv::Mat result;
    cv::resize(picture, result, size_with_longer_side(picture.size(), longer), 0, 0,
               longer < std::max(picture.cols, picture.rows) ? cv::INTER_AREA : cv::INTER_LINEAR);
    return result;
}

/// The faces in what the net answered, in pixels of what it was shown.
std::vector<Detection> faces_in(cv::Mat output) {
    const auto plane = [&](int channel) {
        return cv::Mat(output.size[2], output.size[3], CV_32F, output.ptr<float>(0, channel));
    };
    const cv::Mat scores = logistic(plane(0));
    cv::Mat strongest_near;
    cv::dilate(scores, strongest_near, cv::Mat::ones(3, 3, CV_8U));
    std::vector<Detection> found;
    for (int y = 0; y < scores.rows; ++y)
        for (int x = 0; x < scores.cols; ++x) {
            const float score = scores.at<float>(y, x);
            if (!(score > least_score && score >= strongest_near.at<float>(y, x)))
                continue;
            const auto value = [&](int channel) {
                return static_cast<double>(plane(channel).at<float>(y, x));
            };
            const Vec2 here((x + 0.5) * detector_cell, (y + 0.5) * detector_cell);
            const Vec2 centre = here + Vec2(value(1), value(2)) * static_cast<double>(detector_cell);
            const double size = unit_face * std::exp(value(3));
            if (is_finite(centre) && std::isfinite(size))
                found.push_back({{centre - 0.5 * size, centre + 0.5 * size},
                                 here + Vec2(value(4), value(5)) * size,
                                 here + Vec2(value(6), value(7)) * size,
                                 static_cast<double>(score)});
        }
    return found;
}

/// Where tiles begin that cover `side` px and overlap.
std::vector<int> tile_starts(int side) {
    std::vector<int> starts{0};
    while (starts.back() + tile < side)
        starts.push_back(std::min(starts.back() + tile - tile_overlap, side - tile));
    return starts;
}

/// The same in tiles that overlap by more than the largest face that is looked for there.
std::vector<Detection> faces_in_tiles(cv::dnn::Net& net, const ShrunkRows& picture,
                                      const std::stop_token& stop) {
    std::vector<Detection> found;
    for (const int y : tile_starts(picture.size().height)) {
        const cv::Mat band = picture.rows({y, std::min(y + tile, picture.size().height)});
        for (const int x : tile_starts(band.cols)) {
            if (stop.stop_requested())
                return found;
            for (Detection face :
                 faces_in(detector_answer(net, band.colRange(x, std::min(x + tile, band.cols))))) {
                const Vec2 corner(x, y);
                face.box = {face.box.min + corner, face.box.max + corner};
                face.right_eye += corner;
                face.left_eye += corner;
                found.push_back(face);
            }
        }
    }
    return found;
}

bool has_large_face(const std::vector<Detection>& faces) {
    return std::any_of(faces.begin(), faces.end(),
                       [](const Detection& f) { return f.score >= sure_score && f.size() >= large_face; });
}

Detection scaled(const Detection& face, Vec2 by) {
    return {{face.box.min * by, face.box.max * by}, face.right_eye * by, face.left_eye * by, face.score};
}

} // namespace

EmbeddedDetector::EmbeddedDetector() {
    for (std::size_t i = 0; i < kept_levels; ++i)
        nets_.push_back(embedded_net(EmbeddedModel::detector));
}

std::vector<Detection> EmbeddedDetector::detect(const cv::Mat& picture, Effort effort, Looks& looks,
                                                const std::stop_token& stop) {
    const int longer = std::max(picture.cols, picture.rows);
    cv::Mat base; ///< made where it is needed
    while (looks.taken < levels.size() && !stop.stop_requested()) {
        const std::size_t level = looks.taken;
        const bool enlarges = levels[level] > longer;
        if (enlarges && level > 1)
            break;
        if (base.empty() && levels[level] <= usual_finest)
            base = shrunk_by_blocks(picture, usual_finest);
        const cv::Mat shown = resized(levels[level] > usual_finest ? picture : base, levels[level]);
        const Vec2 back(static_cast<double>(picture.cols) / shown.cols,
                        static_cast<double>(picture.rows) / shown.rows);
        const std::vector<Detection> here =
            faces_in(level < nets_.size() ? detector_answer(nets_[level], shown)
                                          : detector_answer_in_parts(shown, largest_part));
        for (const Detection& face : here)
            looks.shown.push_back(scaled(face, back));
        ++looks.taken;
        if (effort == Effort::usual && has_large_face(here))
            break;
    }
    if (const int finest = static_cast<int>(thorough_share * longer);
        effort == Effort::thorough && finest > levels.back() && looks.taken == levels.size() &&
        !stop.stop_requested()) {
        const ShrunkRows shown(picture, finest);
        const double back = static_cast<double>(picture.cols) / shown.size().width;
        cv::dnn::Net net = embedded_net(EmbeddedModel::detector);
        for (const Detection& face : faces_in_tiles(net, shown, stop))
            looks.shown.push_back(scaled(face, Vec2(back)));
        ++looks.taken;
    }
    return without_doubles(looks.shown, most_overlap);
}

} // namespace tp
