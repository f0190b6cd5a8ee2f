// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_selection.hpp"

#include "app/pages/mend/mend_words.hpp"
#include "core/geometry/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tp {

MendSelection::MendSelection(const MendedPhoto& photo, MendView& view, Narrator& narrator)
    : photo_(photo), view_(view), narrator_(narrator) {
    connect(&photo, &MendedPhoto::replaced, this, &MendSelection::begin_anew);
    connect(&photo, &MendedPhoto::changed, this, &MendSelection::follow);
}

void MendSelection::begin_anew() {
    feature_ = photo_.usable() && place_of(0) ? 0 : -1;
    handle_ = -1;
}

/// The contours are others.
void MendSelection::follow() {
    QStringList names;
    for (int i = 0; place_of(i); ++i)
        names << name_of(i);
    feature_ = std::min(feature_, static_cast<int>(names.size()) - 1);
    const bool others = names != feature_names_;
    feature_names_ = names;
    show_handles();
    if (others)
        emit featuresChanged();
    emit changed();
}

void MendSelection::show_handles() {
    std::vector<HandleModel::Row> rows;
    if (const MendContour* contour = line())
        for (std::size_t i = 0; i < contour->nodes.size(); ++i) {
            const Vec2 at = contour->nodes[i].at;
            rows.push_back({{at.x, at.y}, node_words(*contour, i)});
        }
    handles_.set(std::move(rows));
    handle_ = std::min(handle_, handles_.rowCount() - 1);
}

// --- features ---

std::optional<MendSelection::Place> MendSelection::place_of(int index) const {
    const std::vector<MendFace>& faces = photo_.work().faces;
    int left = index;
    for (std::size_t face = 0; left >= 0 && face < faces.size(); ++face) {
        const int count = static_cast<int>(faces[face].features.size());
        if (left < count)
            return Place{face, static_cast<std::size_t>(left)};
        left -= count;
    }
    return std::nullopt;
}

const MendFace* MendSelection::face() const {
    const auto place = place_of(feature_);
    return place ? &photo_.work().faces[place->face] : nullptr;
}

const MendFeature* MendSelection::own() const {
    const auto place = place_of(feature_);
    return place ? &photo_.work().faces[place->face].features[place->feature] : nullptr;
}

MendFeature& MendSelection::own_in(MendWork& work) const {
    const Place place = place_of(feature_).value();
    return work.faces[place.face].features[place.feature];
}

const MendContour* MendSelection::line() const {
    const MendFeature* feature = own();
    return feature && feature->line ? &*feature->line : nullptr;
}

QString MendSelection::name_of(int index) const {
    const auto place = place_of(index);
    if (!place)
        return {};
    const std::vector<MendFace>& faces = photo_.work().faces;
    return feature_words(faces[place->face].features[place->feature].name,
                         faces.size() > 1 ? static_cast<int>(place->face) : -1);
}

void MendSelection::take_feature(int index) {
    feature_ = index;
    handle_ = -1;
    show_handles();
    emit changed();
}

void MendSelection::chooseFeature(int index) {
    if (!place_of(index))
        return;
    emit leavingFeature();
    emit leavingPoint();
    take_feature(index);
    fitIntoView();
    if (line())
        narrator_.tell(
            tr("%1, %n point(s).", nullptr, static_cast<int>(line()->nodes.size())).arg(featureName()),
            Priority::touch);
    else
        narrator_.tell(tr("%1: missing. It can be added.").arg(featureName()), Priority::touch);
}

void MendSelection::stepFeature(int step) {
    const int count = static_cast<int>(feature_names_.size());
    if (count > 0)
        chooseFeature((std::max(feature_, 0) + step + count) % count);
}

void MendSelection::setWholeFeature(bool whole) {
    if (whole == whole_)
        return;
    whole_ = whole;
    emit leavingPoint();
    emit changed();
    narrator_.tell(whole ? tr("The whole feature moves.") : tr("One point moves."), Priority::touch);
}

// --- points ---

QString MendSelection::handleName() const {
    return line() && handle_ >= 0 ? node_words(*line(), node()) : QString();
}

QString MendSelection::handlePlace() const {
    return line() && handle_ >= 0 ? place_words(line()->nodes[node()].at) : QString();
}

bool MendSelection::handleIsCorner() const {
    return line() && handle_ >= 0 && line()->nodes[node()].kind == MendNode::Kind::corner;
}

bool MendSelection::handleTurns() const {
    if (!line() || handle_ < 0)
        return false;
    MendContour trial = *line();
    return toggle_corner(trial, node());
}

void MendSelection::take_handle(int index) {
    handle_ = index;
    emit changed();
}

void MendSelection::chooseHandle(int index) {
    if (!line() || index < 0 || index >= handles_.rowCount())
        return;
    emit leavingPoint();
    take_handle(index);
    view_.bring_in_sight(line()->nodes[node()].at);
    tell_handle();
}

void MendSelection::tell_handle() {
    if (line() && handle_ >= 0)
        narrator_.tell(tr("%1: %2.").arg(handleName(), handlePlace()), Priority::touch);
}

bool MendSelection::stepHandle(int step) {
    const int count = handles_.rowCount();
    const int next = handle_ < 0 ? (step > 0 ? 0 : count - 1) : handle_ + step;
    if (count == 0 || next < 0 || next >= count) {
        take_handle(-1);
        return false;
    }
    chooseHandle(next);
    return true;
}

// --- places ---

std::optional<int> MendSelection::handle_at(QPointF place, double reach) const {
    std::optional<int> best;
    double nearest = reach;
    if (const MendContour* contour = line())
        for (std::size_t i = 0; i < contour->nodes.size(); ++i) {
            const QPointF away = view_.to_window(contour->nodes[i].at) - place;
            if (const double distance = std::hypot(away.x(), away.y()); distance <= nearest) {
                nearest = distance;
                best = static_cast<int>(i);
            }
        }
    return best;
}

std::optional<int> MendSelection::line_at(QPointF place, double reach) const {
    std::optional<int> best;
    double nearest = reach / view_.scale();
    const Vec2 at = view_.to_photo(place);
    for (int i = 0; const auto own_place = place_of(i); ++i) {
        const MendFeature& feature = photo_.work().faces[own_place->face].features[own_place->feature];
        if (!feature.line)
            continue;
        const double distance = distance_to(flatten(contour_of(*feature.line), {0.1, 5.0}), at);
        if (distance <= nearest) {
            nearest = distance;
            best = i;
        }
    }
    return best;
}

void MendSelection::tap(double x, double y, double reach) {
    if (const auto handle = handle_at({x, y}, reach))
        return chooseHandle(*handle);
    const auto other = line_at({x, y}, reach);
    if (other && *other != feature_)
        chooseFeature(*other);
}

void MendSelection::whereAmI() {
    if (!photo_.ready() || !own()) {
        emit nothingInHand();
        return;
    }
    if (!line())
        return narrator_.tell(tr("%1: missing. It can be added.").arg(featureName()), Priority::touch);
    if (handle_ < 0)
        return narrator_.tell(
            tr("%1, %n point(s), none selected.", nullptr, static_cast<int>(line()->nodes.size()))
                .arg(featureName()),
            Priority::touch);
    narrator_.tell(tr("%1 of the %2: %3.").arg(handleName(), featureName(), handlePlace()), Priority::touch);
}

void MendSelection::zoomBy(double factor) {
    const QPointF keep = line() && handle_ >= 0 ? view_.to_window(line()->nodes[node()].at) : view_.middle();
    view_.zoomAt(factor, keep.x(), keep.y());
}

void MendSelection::fitIntoView() {
    if (line())
        view_.show(bounds_of(*line()));
    else if (face())
        view_.show(face()->box);
    else
        view_.showAll();
}

} // namespace tp
