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

PhotoRows::PhotoRows(OpenAlbum& album, FaceFinder& finder, Thumbnails& thumbnails,
                     std::function<QString()> language)
    : album_(album), finder_(finder), thumbnails_(thumbnails), language_(std::move(language)) {
    connect(&album_, &OpenAlbum::album_changed, this, &PhotoRows::refresh);
    connect(&album_, &OpenAlbum::folders_changed, this, &PhotoRows::refresh);
    connect(&finder_, &FaceFinder::judged, this, [this](const fs::path& photo) {
        if (order_ == Order::LooksWrong && !more_) // not while the rows are still those by time
            move_to_its_rank(photo);
        emit totalChanged();
    });
    connect(&thumbnails_, &Thumbnails::came, this, [this](const fs::path& photo) {
        if (const int row = row_of(photo); row >= 0)
            emit dataChanged(index(row), index(row), {PictureRole});
    });
    connect(&gathering_, &QTimer::timeout, this, &PhotoRows::gather_some);
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
    const PhotoEntry& entry = rows_[static_cast<std::size_t>(index.row())]->entry;
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
    QString words =
        summary && *summary ? CareWords::photo_details((*summary)->record, language_()) : QString();
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
    return row < 0 || row >= rowCount() ? fs::path() : rows_[static_cast<std::size_t>(row)]->entry.path;
}

/// The worst first, of equals the newest.
bool PhotoRows::stands_before(const Row& a, const Row& b) {
    return std::pair(-a.wrong, a.nth) < std::pair(-b.wrong, b.nth);
}

int PhotoRows::row_of(const fs::path& photo) const {
    const auto known = by_path_.find(photo.string());
    if (known == by_path_.end())
        return -1;
    const auto place = std::partition_point(rows_.begin(), rows_.end(), [&](const std::unique_ptr<Row>& one) {
        return stands_before(*one, *known->second);
    });
    return static_cast<int>(place - rows_.begin());
}

std::vector<PhotoEntry> PhotoRows::newest(std::size_t count, const std::optional<PlaceInList>& from) {
    auto page = album_.queries().page(AllByTime{}, from, count, Direction::backward);
    return page ? *std::move(page) : std::vector<PhotoEntry>{};
}

bool PhotoRows::canFetchMore(const QModelIndex& parent) const { return !parent.isValid() && more_; }

void PhotoRows::fetchMore(const QModelIndex& parent) {
    if (!canFetchMore(parent))
        return;
    std::vector<PhotoEntry> next =
        newest(page_size, rows_.empty() ? std::nullopt : std::optional(rows_.back()->entry.place));
    more_ = next.size() == page_size;
    if (next.empty())
        return;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(next.size()) - 1);
    const std::size_t shown = rows_.size();
    append(rows_, std::move(next));
    for (std::size_t i = shown; i < rows_.size(); ++i)
        by_path_[rows_[i]->entry.path.string()] = rows_[i].get();
    endInsertRows();
}

void PhotoRows::append(Rows& rows, std::vector<PhotoEntry> entries) {
    for (PhotoEntry& entry : entries)
        rows.push_back(std::make_unique<Row>(Row{std::move(entry), rows.size(), 0.0}));
}

void PhotoRows::setOrder(Order order) {
    if (order == order_)
        return;
    order_ = order;
    emit orderChanged();
    if (order_ == Order::NewestFirst) {
        finder_.judge({});
        gathering_.stop();
    }
    refresh();
}

void PhotoRows::refresh() {
    const auto totals = album_.index().totals();
    total_ = totals ? static_cast<int>(totals->photos) : 0;
    if (order_ == Order::LooksWrong) {
        gather();
    } else {
        const std::size_t shown = std::max(rows_.size(), page_size);
        Rows rows;
        append(rows, newest(shown, std::nullopt));
        more_ = rows.size() == shown;
        take_over(std::move(rows));
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

void PhotoRows::gather() {
    if (gathering_.isActive()) {
        gather_again_ = true;
        return;
    }
    gather_again_ = false;
    gathered_.clear();
    gathering_.start(0);
    gather_some();
}

void PhotoRows::gather_some() {
    constexpr std::size_t at_a_time = 500;
    std::vector<PhotoEntry> page =
        newest(at_a_time, gathered_.empty() ? std::nullopt : std::optional(gathered_.back()->entry.place));
    const bool last = page.size() < at_a_time;
    append(gathered_, std::move(page));
    if (!last)
        return;
    gathering_.stop();
    rank_gathered();
    if (gather_again_)
        gather();
}

/// The worst first; those that are not judged yet are asked for, newest first.
void PhotoRows::rank_gathered() {
    std::deque<fs::path> all;
    for (const std::unique_ptr<Row>& row : gathered_) {
        row->wrong = wrongness(row->entry.path);
        all.push_back(row->entry.path);
    }
    std::sort(gathered_.begin(), gathered_.end(),
              [](const auto& a, const auto& b) { return stands_before(*a, *b); });
    more_ = false;
    take_over(std::exchange(gathered_, Rows{}));
    finder_.judge(std::move(all));
    emit totalChanged();
}

/// One row goes where it belongs; the others, and who is on one of them, stay.
void PhotoRows::move_to_its_rank(const fs::path& photo) {
    const int from = row_of(photo);
    if (from < 0)
        return;
    emit dataChanged(index(from), index(from), {DetailRole});
    const Row ranked{{}, rows_[static_cast<std::size_t>(from)]->nth, wrongness(photo)};
    const auto is_before_it = [&](const std::unique_ptr<Row>& one) { return stands_before(*one, ranked); };
    const auto old = rows_.begin() + from;
    // Without itself the rows before it and those behind it are in order.
    auto place = std::partition_point(rows_.begin(), old, is_before_it);
    if (place == old)
        place = std::partition_point(old + 1, rows_.end(), is_before_it);
    const int to = static_cast<int>(place - rows_.begin()); ///< before which row it goes
    if (to == from || to == from + 1) {
        (*old)->wrong = ranked.wrong;
        return;
    }
    beginMoveRows({}, from, from, {}, to);
    (*old)->wrong = ranked.wrong;
    if (to > from)
        std::rotate(old, old + 1, place);
    else
        std::rotate(place, old, old + 1);
    endMoveRows();
}

/// Rows that are as before only tell anew what they say, so that nobody loses their place in the list.
void PhotoRows::take_over(Rows rows) {
    const bool same = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                                 [](const auto& a, const auto& b) { return a->entry.path == b->entry.path; });
    if (!same)
        beginResetModel();
    rows_ = std::move(rows);
    by_path_.clear();
    for (const std::unique_ptr<Row>& row : rows_)
        by_path_[row->entry.path.string()] = row.get();
    if (!same)
        endResetModel();
    else if (!rows_.empty())
        emit dataChanged(index(0), index(rowCount() - 1), {NameRole, DetailRole});
}

} // namespace tp
