// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/printed_photo.hpp"

#include "app/album/metadata/read_record.hpp"
#include "app/photo/people/face_names.hpp"
#include "app/photo/scene/corrections.hpp"
#include "faces/extract/face_extractor.hpp"

#include <cstddef>
#include <stop_token>
#include <utility>

namespace tp {

PrintedPhoto::Subject PrintedPhoto::read_subject(const std::filesystem::path& photo) {
    auto extractor = FaceExtractor::create();
    if (!extractor) {
        Subject none;
        none.extraction.problem = extractor.error();
        return none;
    }
    Subject subject{with_corrections(extractor->extract(photo), photo), {}};
    if (const auto record = read_record(photo))
        subject.names = names_of_faces(subject.extraction, *record);
    return subject;
}

PrintedPhoto::PrintedPhoto(Read read) : read_(std::move(read)) {}

void PrintedPhoto::open(const std::filesystem::path& photo) {
    file_ = photo;
    looking_ = true;
    subject_ = {};
    reading_.ask([this, photo](const std::stop_token&) -> LatestTask::Answer {
        return [this, subject = read_(photo)] {
            subject_ = subject;
            looking_ = false;
            emit changed();
            emit taken();
        };
    });
    emit changed();
}

QStringList PrintedPhoto::faces() const {
    const std::size_t count = subject_.extraction.faces.size();
    QStringList list{count == 1 ? tr("The face") : tr("All faces")};
    for (std::size_t i = 0; count > 1 && i < count; ++i)
        list << (i < subject_.names.size() && !subject_.names[i].empty()
                     ? QString::fromStdString(subject_.names[i])
                     : tr("Face %1").arg(i + 1));
    return list;
}

} // namespace tp
