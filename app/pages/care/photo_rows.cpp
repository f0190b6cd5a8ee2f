// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/photo_rows.hpp"

#include "app/pages/care/care_words.hpp"

#include <QHash>
#include <QImage>
#include <QLocale>
#include <QModelIndex>

#include <algorithm>
#include <deque>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

PhotoRows::PhotoRows(OpenAlbum& album, FaceFinder& finder, Thumbnails& thumbnails, std::function<QString()> language)
    : album_(album), finder_(finder), thumbnails_(thumbnails), language_(std::move(language)) {
    connect(&album_, &OpenAlbum::album_changed, this, &PhotoRows::refresh);
    connect(&album_, &OpenAlbum::folders_changed, this, &PhotoRows::refresh);
    connect(&finder_, &FaceFinder::judged, this, [this](const fs::path& photo) {
        if (order_ == Order::LooksWrong)
            move_to_its_rank(photo);
        emit totalChanged();
    });
    connect(&thumbnails_, &Thumbnails::came, this, [this](const fs::path& photo) {
        if (const int row = row_of(photo); row >= 0)
            emit dataChanged(index(row), index(row), {PictureRole});
    });
    refresh();
}

int PhotoRows::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QHash<int, QByteArray> PhotoRows::roleNames() const {
    return {{NameRole, "name"}, {DetailRole, "detail"}, {PictureRole, "picture"}};
}

QVariant PhotoRows::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const PhotoEntry& entry = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
    case NameRole:
        return CareWords::file_name(entry.path);
    case DetailRole:
        return detail(entry);
    case PictureRole:
        return thumbnails_.picture({entry.path});
    default:
        return {};
    }
}

QString PhotoRows::detail(const PhotoEntry& entry) const {
    const auto summary = album_.queries().summary(entry.id);
    QString words = summary && *summary ? CareWords::photo_details((*summary)->record, language_()) : QString();
    if (order_ != Order::LooksWrong)
        return words;
    const auto judgement = finder_.last_judgement(entry.path);
    const QString looks =
        !judgement              ? tr("Not checked yet.")
        : judgement->faces == 0 ? tr("No face found.")
        : judgement->doubtful
            ? tr("Faces look wrong: %1 % off.")
                  .arg(QLocale().toString(judgement->expected_error_percent, 'f', 1))
            : tr("Faces about %1 % off.").arg(QLocale().toString(judgement->expected_error_percent, 'f', 1));
    return (looks + ' ' + words).trimmed();
}

fs::path PhotoRows::photo(int row) const {
    return row < 0 || row >= rowCount() ? fs::path() : rows_[static_cast<std::size_t>(row)].path;
}

int PhotoRows::row_of(const fs::path& photo) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const PhotoEntry& one) { return one.path == photo; });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

std::vector<PhotoEntry> PhotoRows::newest(std::size_t count, const std::optional<PlaceInList>& from) {
    auto page = album_.queries().page(AllByTime{}, from, count, Direction::backward);
    return page ? *std::move(page) : std::vector<PhotoEntry>{};
}

bool PhotoRows::canFetchMore(const QModelIndex& parent) const { return !parent.isValid() && more_; }

void PhotoRows::fetchMore(const QModelIndex& parent) {
    if (!canFetchMore(parent))
        return;
    std::vector<PhotoEntry> next = newest(page_size, rows_.empty() ? std::nullopt : std::optional(rows_.back().place));
    more_ = next.size() == page_size;
    if (next.empty())
        return;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(next.size()) - 1);
    std::move(next.begin(), next.end(), std::back_inserter(rows_));
    endInsertRows();
}

void PhotoRows::setOrder(Order order) {
    if (order == order_)
        return;
    order_ = order;
    emit orderChanged();
    if (order_ == Order::NewestFirst)
        finder_.judge({});
    refresh();
}

void PhotoRows::refresh() {
    const auto totals = album_.index().totals();
    total_ = totals ? static_cast<int>(totals->photos) : 0;
    if (order_ == Order::LooksWrong) {
        list_by_judgement();
    } else {
        const std::size_t shown = std::max(rows_.size(), page_size);
        std::vector<PhotoEntry> entries = newest(shown, std::nullopt);
        more_ = entries.size() == shown;
        take_over(std::move(entries));
    }
    emit totalChanged();
}

/// Higher for a photograph whose faces look more wrong; then those that nobody has looked at yet, then those without a
/// face.
double PhotoRows::wrongness(const fs::path& photo) const {
    constexpr double doubt = 1000.0; // a stated reason weighs more than any figure
    const auto judgement = finder_.last_judgement(photo);
    return !judgement              ? 0.0
           : judgement->faces == 0 ? -1.0
                                   : judgement->expected_error_percent + (judgement->doubtful ? doubt : 0.0);
}

/// All photographs, the worst first; those that are not judged yet are asked for, newest first.
void PhotoRows::list_by_judgement() {
    constexpr std::size_t at_a_time = 500;
    std::deque<fs::path> all;
    std::vector<std::pair<double, PhotoEntry>> ranked;
    std::optional<PlaceInList> from;
    for (std::vector<PhotoEntry> page = newest(at_a_time, from); !page.empty(); page = newest(at_a_time, from)) {
        from = page.back().place;
        for (PhotoEntry& entry : page) {
            all.push_back(entry.path);
            const double wrong = wrongness(entry.path);
            ranked.emplace_back(wrong, std::move(entry));
        }
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<PhotoEntry> entries;
    for (auto& [wrong, entry] : ranked)
        entries.push_back(std::move(entry));
    more_ = false;
    take_over(std::move(entries));
    finder_.judge(std::move(all));
}

/// One row goes where it belongs; the others, and who is on one of them, stay.
void PhotoRows::move_to_its_rank(const fs::path& photo) {
    const int from = row_of(photo);
    if (from < 0)
        return;
    emit dataChanged(index(from), index(from), {DetailRole});
    const double wrong = wrongness(photo);
    const auto before = [&](const PhotoEntry& one) { return one.path != photo && wrongness(one.path) >= wrong; };
    const auto to = static_cast<int>(std::count_if(rows_.begin(), rows_.end(), before));
    if (to == from || !beginMoveRows({}, from, from, {}, to > from ? to + 1 : to))
        return;
    PhotoEntry entry = rows_[static_cast<std::size_t>(from)];
    rows_.erase(rows_.begin() + from);
    rows_.insert(rows_.begin() + to, std::move(entry));
    endMoveRows();
}

/// Rows that are as before only tell anew what they say, so that nobody loses their place in the list.
void PhotoRows::take_over(std::vector<PhotoEntry> entries) {
    const bool same = std::equal(entries.begin(), entries.end(), rows_.begin(), rows_.end(),
                                 [](const PhotoEntry& a, const PhotoEntry& b) { return a.path == b.path; });
    if (same) {
        rows_ = std::move(entries);
        if (!rows_.empty())
            emit dataChanged(index(0), index(rowCount() - 1), {NameRole, DetailRole});
        return;
    }
    beginResetModel();
    rows_ = std::move(entries);
    endResetModel();
}

} // namespace tp
