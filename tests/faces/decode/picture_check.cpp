// SPDX-License-Identifier: Apache-2.0
#include "picture_check.hpp"

#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"

#include <functional>

namespace tp::test {

namespace {

constexpr double most_px = 1e6;            ///< decoded
constexpr std::size_t most_seen = 1 << 14; ///< px in which faces are looked for
constexpr std::size_t seldom = 8; ///< of so many pictures one is searched, so that a search gets round

bool is_sentence(const std::string& text) { return text.size() > 10 && text.ends_with('.'); }

FaceExtractor& extractor() {
    static FaceExtractor one = FaceExtractor::create().value();
    return one;
}

cv::Size size_as_turned(const cv::Mat& picture, int degrees) {
    return degrees % 180 == 0 ? picture.size() : cv::Size(picture.rows, picture.cols);
}

std::string complaint_about(const Extraction& found, const cv::Mat& picture) {
    if (cv::Size(found.width, found.height) != size_as_turned(picture, found.turned_degrees))
        return "the size is another";
    if (!found.problem.empty() && !is_sentence(found.problem))
        return "no sentence: " + found.problem;
    const double far = 4.0 * std::max(picture.cols, picture.rows);
    for (const Face& face : found.faces) {
        if (face.contours.size() != 5)
            return "a face without its five contours";
        for (const Contour& contour : face.contours)
            for (const Piece& piece : contour.pieces)
                if (!is_finite(piece) || length(end_of(piece)) > far)
                    return contour.name + " leaves the picture";
        if (!face.problem.empty() && !is_sentence(face.problem))
            return "no sentence: " + face.problem;
    }
    return {};
}

} // namespace

std::string complaint_about_search_in(const cv::Mat& picture) {
    return complaint_about(extractor().extract(picture), picture);
}

std::string complaint_about_picture(std::string_view text) {
    const Bytes bytes(text.begin(), text.end());
    const Result<cv::Mat> picture = decode_picture(bytes, most_px);
    if (!picture)
        return is_sentence(picture.error()) ? "" : "no sentence: " + picture.error();
    if (picture->empty() || picture->type() != CV_8UC3)
        return "decoded to something else than 8-bit colours";
    if (static_cast<double>(picture->total()) > most_px)
        return "larger than allowed";
    if (picture->total() > most_seen || std::hash<std::string_view>{}(text) % seldom != 0)
        return {};
    return complaint_about_search_in(*picture);
}

} // namespace tp::test
