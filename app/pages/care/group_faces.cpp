// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/group_faces.hpp"

#include "app/pages/care/care_words.hpp"
#include "app/pages/care/group_rows.hpp"

#include <QImage>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

bool is_that_face(const PersonFace& one, const PersonFace& other) {
    return one.id == other.id && one.photo == other.photo;
}

} // namespace

GroupFaces::GroupFaces(Thumbnails& pictures) : pictures_(pictures) {
    connect(&pictures_, &Thumbnails::came, this, [this](const std::filesystem::path& photo) {
        for (int row = 0; row < rowCount(); ++row)
            if (face(row)->photo == photo)
                emit dataChanged(index(row), index(row), {PictureRole});
    });
}

int GroupFaces::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QHash<int, QByteArray> GroupFaces::roleNames() const {
    return {{TextRole, "name"}, {DetailRole, "detail"}, {PictureRole, "picture"}};
}

QVariant GroupFaces::data(const QModelIndex& index, int role) const {
    const PersonFace* const face = index.isValid() ? this->face(index.row()) : nullptr;
    if (face == nullptr)
        return {};
    switch (role) {
    case TextRole:
        return CareWords::file_name(face->photo);
    case DetailRole:
        return CareWords::face_details(*face, named_ && !face->said);
    case PictureRole:
        return pictures_.picture(part_of(*face));
    default:
        return {};
    }
}

const PersonFace* GroupFaces::face(int row) const {
    return row >= 0 && row < rowCount() ? &rows_[static_cast<std::size_t>(row)] : nullptr;
}

int GroupFaces::row_of(const PersonFace& face) const {
    const auto found =
        std::ranges::find_if(rows_, [&](const PersonFace& row) { return is_that_face(row, face); });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

void GroupFaces::take(const Person* person) {
    std::vector<PersonFace> faces = person ? person->faces : std::vector<PersonFace>();
    named_ = person && !person->name.empty();
    std::ranges::stable_sort(faces, {}, &PersonFace::said);
    if (std::ranges::equal(faces, rows_, is_that_face)) { // who looks at them keeps the place
        rows_ = std::move(faces);
        if (!rows_.empty())
            emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    beginResetModel();
    rows_ = std::move(faces);
    endResetModel();
}

} // namespace tp
