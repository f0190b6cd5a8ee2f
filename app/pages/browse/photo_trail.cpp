// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/photo_trail.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

std::optional<std::size_t> PhotoTrail::found_at(const Found& found, const PhotoEntry& photo) const {
    const auto at = std::find_if(found.begin(), found.end(),
                                 [&](const PhotoEntry& one) { return one.path == photo.path; });
    return at == found.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - found.begin()));
}

Result<std::optional<PhotoEntry>> PhotoTrail::beside(const PhotoEntry& photo, Direction direction) const {
    if (const auto* const list = std::get_if<PhotoList>(&way_))
        return AlbumQueries(*index_).neighbour(*list, photo.place, direction);
    const Found& found = std::get<Found>(way_);
    const auto at = found_at(found, photo);
    if (!at)
        return std::optional<PhotoEntry>{};
    if (direction == Direction::backward)
        return *at == 0 ? std::nullopt : std::optional(found[*at - 1]);
    return *at + 1 == found.size() ? std::nullopt : std::optional(found[*at + 1]);
}

Result<bool> PhotoTrail::step(Direction direction) {
    if (!here_)
        return to_end(direction);
    Result<std::optional<PhotoEntry>> next = beside(*here_, direction);
    if (!next)
        return Error{next.error()};
    if (!*next)
        return false;
    here_ = std::move(**next);
    position_ = direction == Direction::forward ? position_ + 1 : position_ - 1;
    return true;
}

Result<bool> PhotoTrail::to_end(Direction direction) {
    std::optional<PhotoEntry> end;
    if (const auto* const list = std::get_if<PhotoList>(&way_)) {
        Result<std::vector<PhotoEntry>> page = AlbumQueries(*index_).page(*list, {}, 1, direction);
        if (!page)
            return Error{page.error()};
        if (!page->empty())
            end = std::move(page->front());
    } else if (const Found& found = std::get<Found>(way_); !found.empty()) {
        end = direction == Direction::forward ? found.front() : found.back();
    }
    const bool moved = end && (!here_ || end->path != here_->path);
    here_ = std::move(end);
    if (std::string error = recount(); !error.empty())
        return Error{std::move(error)};
    return moved;
}

Result<bool> PhotoTrail::to(const PhotoEntry& photo) {
    if (const auto* const found = std::get_if<Found>(&way_); found != nullptr && !found_at(*found, photo))
        return false;
    here_ = photo;
    if (std::string error = recount(); !error.empty())
        return Error{std::move(error)};
    return true;
}

std::string PhotoTrail::recount() {
    position_ = 0;
    if (const auto* const list = std::get_if<PhotoList>(&way_)) {
        AlbumQueries queries(*index_);
        Result<std::size_t> all = queries.count_before(*list, {});
        if (!all)
            return all.error();
        count_ = *all;
        if (!here_)
            return {};
        const Result<std::size_t> before = queries.count_before(*list, here_->place);
        if (!before)
            return before.error();
        position_ = *before + 1;
        return {};
    }
    const Found& found = std::get<Found>(way_);
    count_ = found.size();
    if (here_)
        if (const auto at = found_at(found, *here_))
            position_ = *at + 1;
    return {};
}

Result<bool> PhotoTrail::look_again(const std::string& sha256) {
    const std::optional<PhotoEntry> was = std::exchange(here_, std::nullopt);
    bool same = false;
    if (auto* const found = std::get_if<Found>(&way_)) {
        Found still;
        std::size_t place = 0; // among those that are still there
        for (const PhotoEntry& photo : *found) {
            const bool this_one = was && photo.path == was->path;
            Result<std::optional<PhotoEntry>> now = find_again(photo, this_one ? sha256 : std::string());
            if (!now)
                return Error{now.error()};
            if (this_one)
                place = still.size();
            same = same || (this_one && *now);
            if (*now)
                still.push_back(std::move(**now));
        }
        *found = std::move(still);
        if (was && !found->empty())
            here_ = (*found)[std::min(place, found->size() - 1)];
    } else if (was) {
        const PhotoList& list = std::get<PhotoList>(way_);
        Result<std::optional<PhotoEntry>> now = find_again(*was, sha256);
        if (now && *now && !is_in(list, **now))
            now = std::optional<PhotoEntry>{};
        same = now && *now;
        for (const Direction direction : {Direction::forward, Direction::backward})
            if (now && !*now)
                now = AlbumQueries(*index_).neighbour(list, was->place, direction);
        if (!now)
            return Error{now.error()};
        here_ = std::move(*now);
    }
    if (std::string error = recount(); !error.empty())
        return Error{std::move(error)};
    return same;
}

/// By its path, else by its bytes, since other programs rename photographs.
Result<std::optional<PhotoEntry>> PhotoTrail::find_again(const PhotoEntry& photo,
                                                         const std::string& sha256) const {
    AlbumQueries queries(*index_);
    Result<std::optional<PhotoEntry>> now = queries.find(photo.path);
    return now && !*now && !sha256.empty() ? queries.with_content(sha256) : std::move(now);
}

bool PhotoTrail::is_in(const PhotoList& list, const PhotoEntry& photo) const {
    PlaceInList before = photo.place;
    --before.id;
    const Result<std::vector<PhotoEntry>> there = AlbumQueries(*index_).page(list, before, 1);
    return there && !there->empty() && there->front().id == photo.id;
}

std::vector<fs::path> PhotoTrail::ahead(bool backwards) const {
    std::vector<fs::path> paths;
    if (!here_)
        return paths;
    const Direction likely = backwards ? Direction::backward : Direction::forward;
    const Direction other = backwards ? Direction::forward : Direction::backward;
    PhotoEntry at = *here_;
    for (int i = 0; i < 2; ++i) {
        const auto next = beside(at, likely);
        if (!next || !*next)
            break;
        at = **next;
        paths.push_back(at.path);
    }
    if (const auto next = beside(*here_, other); next && *next)
        paths.push_back((*next)->path);
    return paths;
}

} // namespace tp
