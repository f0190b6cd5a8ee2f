// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_editing.hpp"

#include "app/pages/mend/mend_words.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tp {

MendEditing::MendEditing(const MendedPhoto& photo, MendView& view, MendSelection& selection,
                         MendHistory& history, const MendDrag& drag, Narrator& narrator)
    : photo_(photo), view_(view), selection_(selection), history_(history), drag_(drag), narrator_(narrator) {
}

/// A step that changes the contour in hand, which is a person's then.
void MendEditing::mend(const QString& what, const std::function<void(MendContour&)>& change,
                       const QString& run) {
    history_.step(
        what,
        [&](MendWork& work) {
            MendFeature& feature = selection_.own_in(work);
            feature.mended = true;
            change(*feature.line);
        },
        run);
}

// --- moving ---

void MendEditing::move_by(Vec2 by, const QString& run) {
    if (!is_finite(by))
        return;
    const QString name = selection_.featureName();
    if (selection_.wholeFeature()) {
        mend(
            tr("the %1 was moved").arg(name), [by](MendContour& line) { move_all(line, by); }, run);
        return tell(tr("%1: %2.").arg(name, place_words(bounds_of(*selection_.line()).centre())));
    }
    const std::size_t node = selection_.node();
    mend(
        tr("a point of the %1 was moved").arg(name),
        [by, node](MendContour& line) { move_node(line, node, line.nodes[node].at + by); }, run);
    view_.bring_in_sight(selection_.line()->nodes[node].at);
    tell(tr("%1.").arg(selection_.handlePlace()));
}

void MendEditing::nudge(double dx, double dy) {
    if (!photo_.ready() || drag_.state() != MendDrag::State::Free)
        return;
    if (!selection_.line())
        return selection_.whereAmI();
    const bool whole = selection_.wholeFeature();
    if (!whole && selection_.handle() < 0)
        return tell(tr("No point is selected. Tab goes from point to point."));
    move_by({dx, dy}, QStringLiteral("nudge %1 %2 %3")
                          .arg(selection_.feature())
                          .arg(whole ? -1 : selection_.handle())
                          .arg(whole));
}

void MendEditing::nudgeHandle(int index, double dx, double dy) {
    if (index < 0 || index >= selection_.handles()->rowCount())
        return;
    if (index != selection_.handle())
        selection_.take_handle(index);
    nudge(dx, dy);
}

// --- points ---

void MendEditing::add_point(const std::function<std::size_t(MendContour&)>& add) {
    std::size_t node = 0;
    mend(tr("a point of the %1 was added").arg(selection_.featureName()),
         [&node, &add](MendContour& line) { node = add(line); });
    selection_.take_handle(static_cast<int>(node));
    tell(tr("Added. %1: %2.").arg(selection_.handleName(), selection_.handlePlace()));
}

void MendEditing::addPoint() {
    if (!selection_.line())
        return selection_.whereAmI();
    const auto behind = static_cast<std::size_t>(std::max(selection_.handle(), 0));
    add_point([behind](MendContour& line) { return add_node_after(line, behind); });
}

void MendEditing::addPointAt(double x, double y) {
    if (selection_.line())
        add_point([place = view_.to_photo({x, y})](MendContour& line) { return add_node_near(line, place); });
}

void MendEditing::deletePoint() {
    if (!selection_.line() || selection_.handle() < 0)
        return tell(tr("No point is selected. Tab goes from point to point."));
    MendContour left = *selection_.line();
    if (!delete_node(left, selection_.node()))
        return tell(tr("The %1 needs its last points. The whole feature can be removed.")
                        .arg(selection_.featureName()));
    mend(tr("a point of the %1 was deleted").arg(selection_.featureName()),
         [&left](MendContour& line) { line = std::move(left); });
    tell(tr("Deleted. Selected: %1.").arg(selection_.handleName()));
}

void MendEditing::turnCorner() {
    if (!selection_.handleTurns())
        return tell(tr("This point cannot be a corner."));
    mend(tr("a point of the %1 was converted").arg(selection_.featureName()),
         [this](MendContour& line) { toggle_corner(line, selection_.node()); });
    tell(selection_.handleIsCorner() ? tr("A corner now.") : tr("Smooth now."));
}

// --- features ---

void MendEditing::resetFeature() {
    if (!selection_.own())
        return;
    const QString name = selection_.featureName();
    if (!selection_.featureMended())
        return tell(tr("The %1 is as the program found it.").arg(name));
    history_.step(tr("the %1 was reset").arg(name), [this](MendWork& work) {
        MendFeature& feature = selection_.own_in(work);
        feature.line = feature.found_felt ? feature.found : std::nullopt;
        feature.mended = false;
    });
    selection_.fitIntoView();
    tell(selection_.line() ? tr("The %1 is as the program found it again.").arg(name)
                           : tr("The %1 is gone again, because the program did not find it.").arg(name));
}

void MendEditing::addFeature() {
    if (!selection_.own())
        return;
    const QString name = selection_.featureName();
    if (selection_.line())
        return tell(tr("The %1 is there already.").arg(name));
    history_.step(tr("the %1 was added").arg(name), [this](MendWork& work) {
        MendFeature& feature = selection_.own_in(work);
        feature.line = feature.found ? *feature.found : template_for(*selection_.face(), feature.name);
        feature.mended = !feature.found_felt;
    });
    selection_.take_handle(-1);
    selection_.fitIntoView();
    tell(selection_.own()->found ? tr("The %1 is there, as the program found it.").arg(name)
                                 : tr("The %1 was added in its usual shape. Move it into place.").arg(name));
}

void MendEditing::removeFeature() {
    if (!selection_.line())
        return selection_.whereAmI();
    history_.step(tr("the %1 was removed").arg(selection_.featureName()), [this](MendWork& work) {
        MendFeature& feature = selection_.own_in(work);
        feature.line.reset();
        feature.mended = true;
    });
    selection_.take_handle(-1);
    tell(tr("The %1 was removed. It will not be felt.").arg(selection_.featureName()));
}

void MendEditing::addFace() {
    if (!photo_.ready())
        return;
    history_.step(tr("a face was added"), [this](MendWork& work) {
        work.faces.push_back(
            usual_face(view_.to_photo(view_.middle()), 0.5 * std::min(work.height, 1.25 * work.width)));
    });
    const MendFace& face = photo_.work().faces.back();
    selection_.take_feature(
        static_cast<int>(selection_.features().size() - static_cast<qsizetype>(face.features.size())));
    view_.show(face.box);
    tell(tr("A face of the usual shape was added. Move its features into place."));
}

} // namespace tp
