// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/photo_loader.hpp"

#include "app/album/metadata/read_record.hpp"
#include "app/photo/people/face_names.hpp"
#include "app/photo/picture/overlay.hpp"
#include "app/photo/scene/corrections.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QFileInfo>

#include <exception>
#include <string>

namespace tp {

namespace {

constexpr int longest_shown_px = 2400;

QImage for_the_screen(const cv::Mat& picture) { return to_image(not_larger_than(picture, longest_shown_px)); }

LoadedPhoto read_and_find(const QString& file, std::unique_ptr<FaceExtractor>& extractor,
                          const std::stop_token& stop) {
    LoadedPhoto photo;
    photo.name = QFileInfo(file).fileName();
    photo.file = file;
    const Result<cv::Mat> picture = read_picture(file.toStdString());
    if (!picture) {
        photo.extraction.problem = picture.error();
        return photo;
    }
    if (!extractor) {
        Result<FaceExtractor> made = FaceExtractor::create();
        if (!made) {
            photo.extraction.problem = made.error();
            photo.image = for_the_screen(*picture);
            return photo;
        }
        extractor = std::make_unique<FaceExtractor>(std::move(made).value());
    }
    photo.extraction = with_corrections(extractor->extract(*picture, stop), file.toStdString());
    photo.image = for_the_screen(turned(*picture, photo.extraction.turned_degrees));
    if (const Result<PhotoRecord> record = read_record(file.toStdString()))
        for (const std::string& name : names_of_faces(photo.extraction, *record))
            photo.names.push_back(QString::fromStdString(name).simplified());
    return photo;
}

} // namespace

PhotoLoader::PhotoLoader() = default;

PhotoLoader::~PhotoLoader() = default;

void PhotoLoader::load(const QString& file) {
    work_.ask([this, file](const std::stop_token& stop) -> LatestTask::Answer {
        auto photo = std::make_shared<LoadedPhoto>();
        try {
            *photo = read_and_find(file, extractor_, stop);
        } catch (const std::exception&) { // out of memory, mostly
            photo->extraction = {};
            photo->extraction.problem =
                "This picture could not be worked on. It may be too large for this computer.";
        }
        return [this, photo] { emit loaded(photo); };
    });
}

} // namespace tp
