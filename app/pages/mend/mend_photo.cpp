// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_photo.hpp"

#include "app/photo/picture/overlay.hpp"
#include "app/photo/scene/corrections.hpp"
#include "core/files/durable_file.hpp"
#include "core/svg/contour_sheet.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"

#include <exception>
#include <utility>

namespace tp {

namespace {

constexpr int longest_shown_px = 4096;

MendPhoto read(const QString& file, std::unique_ptr<FaceExtractor>& extractor, const std::stop_token& stop) {
    MendPhoto photo;
    photo.file = file;
    const std::filesystem::path path = file.toStdString();
    const Result<cv::Mat> picture = read_picture(path);
    if (!picture) {
        photo.problem = picture.error();
        return photo;
    }
    if (!extractor) {
        Result<FaceExtractor> made = FaceExtractor::create();
        if (!made) {
            photo.problem = made.error();
            return photo;
        }
        extractor = std::make_unique<FaceExtractor>(std::move(made).value());
    }
    const Extraction found = extractor->extract(*picture, stop);
    photo.image = to_image(not_larger_than(turned(*picture, found.turned_degrees), longest_shown_px));
    Extraction shown = found;
    if (!is_gone(correction_file(path))) {
        // A file that cannot be used is not written over: somebody's work is in it.
        const Result<ContourSheet> sheet = read_sheet(correction_file(path), ContourSheet::Unit::pixel);
        Result<Extraction> mended = sheet ? corrected(found, *sheet) : Error{sheet.error()};
        if (!mended) {
            photo.problem = "The mended contours in " + correction_file(path).filename().string() +
                            " cannot be used: " + mended.error();
            return photo;
        }
        shown = std::move(mended).value();
    }
    photo.work = work_on(found, shown);
    Result<MendFile> contours = MendFile::open(path, photo.work);
    if (!contours) {
        photo.problem = contours.error();
        return photo;
    }
    photo.contours = std::move(contours).value();
    photo.usable = true;
    return photo;
}

} // namespace

MendPhoto read_for_mending(const QString& file, std::unique_ptr<FaceExtractor>& extractor,
                           const std::stop_token& stop) noexcept {
    try {
        return read(file, extractor, stop);
    } catch (const std::exception&) { // out of memory, mostly
        MendPhoto photo;
        photo.file = file;
        photo.problem = "This picture could not be worked on. It may be too large for this computer.";
        return photo;
    }
}

} // namespace tp
