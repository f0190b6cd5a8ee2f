// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/group_rows.hpp"

#include "app/pages/care/care_words.hpp"

#include <QImage>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

bool is_same(const Person& a, const Person& b) {
    return std::ranges::find_first_of(a.groups, b.groups) != a.groups.end() ||
           (!a.name.empty() && a.name == b.name);
}

} // namespace

PicturePart part_of(const PersonFace& face) { return {face.photo, face.part, face.turned_degrees}; }

GroupRows::GroupRows(Thumbnails& pictures) : pictures_(pictures) {
    connect(&pictures_, &Thumbnails::came, this, [this](const std::filesystem::path& photo) {
        for (int row = 0; row < rowCount(); ++row) {
            const std::vector<PersonFace>& faces = rows_[static_cast<std::size_t>(row)].faces;
            const std::size_t shown = std::min(pictures_shown, faces.size());
            for (std::size_t i = 0; i < shown; ++i)
                if (faces[i].photo == photo)
                    emit dataChanged(index(row), index(row), {FirstRole + static_cast<int>(i)});
        }
    });
}

int GroupRows::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QHash<int, QByteArray> GroupRows::roleNames() const {
    return {{TextRole, "name"},
            {DetailRole, "detail"},
            {FirstRole, "first"},
            {SecondRole, "second"},
            {ThirdRole, "third"}};
}

QVariant GroupRows::data(const QModelIndex& index, int role) const {
    const Person* const person = index.isValid() ? this->person(index.row()) : nullptr;
    if (person == nullptr)
        return {};
    switch (role) {
    case TextRole:
        return CareWords::person(*person);
    case DetailRole:
        return CareWords::person_details(*person);
    default:
        const auto i = static_cast<std::size_t>(role - FirstRole);
        return i < std::min(pictures_shown, person->faces.size())
                   ? pictures_.picture(part_of(person->faces[i]))
                   : QImage();
    }
}

const Person* GroupRows::person(int row) const {
    return row >= 0 && row < rowCount() ? &rows_[static_cast<std::size_t>(row)] : nullptr;
}

int GroupRows::row_of(GroupId group) const {
    const auto found = std::ranges::find_if(
        rows_, [&](const Person& row) { return std::ranges::count(row.groups, group) > 0; });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

void GroupRows::begin_anew() {
    beginResetModel();
    rows_.clear();
    endResetModel();
}

void GroupRows::take(const std::shared_ptr<const People>& people) {
    std::vector<const Person*> coming;
    for (const Person& person : people->persons)
        coming.push_back(&person);
    for (int row = 0; row < rowCount();) {
        Person& old = rows_[static_cast<std::size_t>(row)];
        const auto same =
            std::ranges::find_if(coming, [&](const Person* person) { return is_same(*person, old); });
        if (same == coming.end()) {
            beginRemoveRows({}, row, row);
            rows_.erase(rows_.begin() + row);
            endRemoveRows();
            continue;
        }
        old = **same;
        coming.erase(same);
        emit dataChanged(index(row), index(row));
        ++row;
    }
    if (coming.empty())
        return;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(coming.size()) - 1);
    for (const Person* person : coming)
        rows_.push_back(*person);
    endInsertRows();
}

} // namespace tp
