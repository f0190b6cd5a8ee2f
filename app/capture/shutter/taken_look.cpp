// SPDX-License-Identifier: Apache-2.0
#include "app/capture/shutter/taken_look.hpp"

#include "app/album/metadata/photo_record.hpp"
#include "app/photo/sight/look.hpp"
#include "core/base/result.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core.hpp>

#include <exception>
#include <utility>

namespace tp {

namespace {

double mean_of(const cv::Mat& picture) {
    const cv::Scalar bgr = cv::mean(picture);
    return (0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2]) / 255.0; // luma of ITU-R BT.601
}

} // namespace

TakenSight TakenLook::see(const cv::Mat& picture) {
    if (picture.empty() || picture.type() != CV_8UC3)
        return {};
    try {
        if (!extractor_) {
            Result<FaceExtractor> made = FaceExtractor::create();
            if (!made)
                return {};
            extractor_ = std::move(made).value();
        }
        Extraction found = extractor_->extract(picture);
        if (found.turned_degrees != 0) { // the picture is kept as it is: a face that lies in it is nobody's
            found = {};
            found.width = picture.cols;
            found.height = picture.rows;
        }
        TakenSight sight{look_at(picture, found), {}};
        if (mean_of(picture) < dark_picture)
            sight.seen.light = Light::dark;
        const Vec2 size(picture.cols, picture.rows);
        for (const Face& face : found.faces)
            if (std::string name = namer_.name(picture, face); !name.empty())
                sight.known.push_back({{face.box.min / size, face.box.max / size}, std::move(name)});
        return sight;
    } catch (const std::exception&) { // out of memory, mostly
        return {};
    }
}

PhotoView taken_view(const TakenSight& sight, QLocale::Language language) {
    PhotoRecord record;
    for (const NamedFace& face : sight.known)
        if (!face.name.empty()) {
            const Vec2 centre = face.box.centre();
            record.faces.push_back({centre.x, centre.y, face.box.width(), face.box.height(), face.name});
        }
    return view_of(sight.seen, record, language);
}

} // namespace tp
