// SPDX-License-Identifier: Apache-2.0
#include "app/photo/sight/photo_look.hpp"

#include "app/photo/sight/look.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/identity/face_describer.hpp"
#include "faces/identity/unfit.hpp"

#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int colours_side_px = 512; ///< of the picture by which light and colours are told

static_assert(static_cast<int>(NoGuess::blurred) == static_cast<int>(Unfit::blurred));

class PhotoLook {
public:
    Looked operator()(const std::filesystem::path& photo, Marks marks, const std::stop_token& stop) {
        try {
            if (!extractor_) {
                Result<FaceExtractor> made = FaceExtractor::create();
                if (!made)
                    return {};
                extractor_ = std::make_shared<FaceExtractor>(std::move(made).value());
            }
            const Extraction found = extractor_->extract(photo, stop);
            if (found.width <= 0 || stop.stop_requested())
                return {};
            const Result<cv::Mat> picture = read_picture_to_fit(photo, {colours_side_px, colours_side_px});
            if (!picture)
                return {};
            Looked looked{look_at(turned(*picture, found.turned_degrees), found), {}};
            if (marks == Marks::yes)
                looked.marks = marks_of(photo, found);
            return looked;
        } catch (const std::exception&) { // out of memory, mostly
            return {};
        }
    }

private:
    /// In the whole picture, in which the faces were found: a small face has no pixels to spare.
    std::vector<FaceMark> marks_of(const std::filesystem::path& photo, const Extraction& found) {
        if (found.faces.empty())
            return {};
        const Result<cv::Mat> picture = read_picture(photo);
        if (!picture)
            return std::vector(found.faces.size(), FaceMark{NoGuess::no_contours, {}});
        const cv::Mat upright = turned(*picture, found.turned_degrees);
        std::vector<FaceMark> marks;
        for (const Face& face : found.faces)
            marks.push_back(mark_of(upright, face));
        return marks;
    }
    FaceMark mark_of(const cv::Mat& picture, const Face& face) {
        const Unfit unfit = unfit_for_guessing(picture, face);
        if (unfit != Unfit::no)
            return {static_cast<NoGuess>(unfit), {}};
        if (!describer_)
            describer_ = std::make_shared<FaceDescriber>();
        const auto numbers = describer_->describe(picture, face);
        const auto descriptor = numbers ? descriptor_of(*numbers) : std::nullopt;
        if (!descriptor)
            return {NoGuess::no_numbers, {}};
        return {NoGuess::none,
                std::string(reinterpret_cast<const char*>(descriptor->data()), descriptor->size())};
    }

    std::shared_ptr<FaceExtractor> extractor_; ///< shared, because a Look can be copied
    std::shared_ptr<FaceDescriber> describer_;
};

} // namespace

Look photo_look() { return PhotoLook(); }

} // namespace tp
