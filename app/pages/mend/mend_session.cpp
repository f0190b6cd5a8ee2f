// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_session.hpp"

#include "app/pages/mend/mend_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/geometry/flatten.hpp"
#include "core/svg/contour_sheet.hpp"

#include <QFileInfo>

#include <algorithm>
#include <limits>

namespace tp {

namespace {

QPointF point(Vec2 place) { return {place.x, place.y}; }

std::string text_of(const MendWork& work) { return sheet_to_svg(sheet_of(work)); }

} // namespace

MendSession::MendSession(Narrator& narrator) : narrator_(narrator) {}

MendSession::~MendSession() {
    QString problem;
    write(problem);
}

void MendSession::tell(const QString& sentence, Priority priority) {
    if (sentence_ != sentence) {
        sentence_ = sentence;
        emit sentenceChanged();
    }
    narrator_.tell(sentence, priority);
}

// --- the photograph ---

QString MendSession::photoName() const { return QFileInfo(photo_.file).fileName(); }

void MendSession::open(const QUrl& file) {
    if (file.isLocalFile())
        open_file(file.toLocalFile());
    else
        tell(tr("Only a photograph that is a file on this computer can be opened."), Priority::message);
}

void MendSession::open_file(const QString& file) {
    if (!save())
        return;
    state_ = State::Looking;
    emit photoChanged();
    tell(tr("Looking for faces…"), Priority::message);
    loader_.ask([this, file](const std::stop_token& stop) -> NewestWork::Answer {
        auto photo = std::make_shared<MendPhoto>(read_for_mending(file, extractor_, stop));
        return [this, photo] { show(std::move(*photo)); };
    });
}

void MendSession::become(State state) {
    state_ = state;
    emit photoChanged();
    emit viewChanged();
}

void MendSession::show(MendPhoto photo) {
    QString refused; // of a photograph that was shown while another was not saved
    if (!write(refused))
        return tell(refused, Priority::message);
    photo_ = std::move(photo);
    drag_.reset();
    history_.clear();
    felt_ = {};
    opened_ = photo_.work;
    opened_text_ = text_ = text_of(photo_.work);
    view_.set_photo(photo_.work.width, photo_.work.height);
    current_ = -1;
    handle_ = -1;
    become(photo_.usable ? State::Ready : State::Problem);
    list_features();
    if (!photo_.usable) {
        lines_changed();
        return enter();
    }
    current_ = feature_names_.isEmpty() ? -1 : 0;
    emit featureChanged();
    lines_changed();
    showFeature();
    enter();
}

void MendSession::enter() {
    switch (state_) {
    case State::Empty:
        return tell(tr("Here the contours of a photograph are mended. There is no photograph yet."), Priority::message);
    case State::Looking:
        return tell(tr("Looking for faces…"), Priority::message);
    case State::Problem:
        return tell(tr("%1: %2", "a photograph and what is wrong with it")
                        .arg(photoName(), in_persons_language(photo_.problem)),
                    Priority::message);
    case State::Ready:
        break;
    }
    if (photo_.work.faces.empty())
        return tell(tr("No face was found in %1. One of usual shape can be added and put in place.").arg(photoName()),
                    Priority::message);
    tell(tr("Contours of %1. In hand: %2. Tab goes from point to point, the arrow keys move it.")
             .arg(photoName(), featureName()),
         Priority::message);
}

void MendSession::leave() {
    cancelDrag();
    if (state_ == State::Looking) {
        loader_.cancel();
        become(photo_.usable ? State::Ready : State::Empty);
    }
    save();
}

// --- what is seen ---

void MendSession::setWindow(double width, double height) {
    view_.set_window(width, height);
    emit viewChanged();
}

void MendSession::zoomBy(double factor) {
    const QPointF keep =
        line() && handle_ >= 0
            ? view_.to_window(line()->nodes[static_cast<std::size_t>(handle_)].at)
            : view_.middle();
    zoomAt(factor, keep.x(), keep.y());
}

void MendSession::zoomAt(double factor, double x, double y) {
    if (!(factor > 0.0))
        return;
    view_.zoom(factor, {x, y});
    emit viewChanged();
}

void MendSession::panBy(double dx, double dy) {
    view_.pan({dx, dy});
    emit viewChanged();
}

void MendSession::showAll() {
    view_.show_all();
    emit viewChanged();
}

void MendSession::showFeature() {
    if (line())
        view_.show(bounds_of(*line()));
    else if (const auto place = place_of(current_))
        view_.show(photo_.work.faces[place->face].box);
    else
        view_.show_all();
    emit viewChanged();
}

// --- what is in hand ---

std::optional<MendSession::Place> MendSession::place_of(int index) const {
    int left = index;
    for (std::size_t face = 0; left >= 0 && face < photo_.work.faces.size(); ++face) {
        const int count = static_cast<int>(photo_.work.faces[face].features.size());
        if (left < count)
            return Place{face, static_cast<std::size_t>(left)};
        left -= count;
    }
    return std::nullopt;
}

const MendFeature* MendSession::own() const {
    const auto place = place_of(current_);
    return place ? &photo_.work.faces[place->face].features[place->feature] : nullptr;
}

MendFeature* MendSession::own() { return const_cast<MendFeature*>(std::as_const(*this).own()); }

const MendContour* MendSession::line() const {
    const MendFeature* feature = own();
    return feature && feature->line ? &*feature->line : nullptr;
}

bool MendSession::featureMended() const { return own() && own()->mended; }

QString MendSession::name_of(int index) const {
    const auto place = place_of(index);
    if (!place)
        return {};
    const bool several = photo_.work.faces.size() > 1;
    return feature_words(photo_.work.faces[place->face].features[place->feature].name,
                         several ? static_cast<int>(place->face) : -1);
}

void MendSession::list_features() {
    QStringList names;
    for (int i = 0; place_of(i); ++i)
        names << name_of(i);
    if (names != feature_names_) {
        feature_names_ = names;
        emit featuresChanged();
    }
}

void MendSession::chooseFeature(int index) {
    if (!place_of(index))
        return;
    cancelDrag();
    history_.end_run();
    current_ = index;
    handle_ = -1;
    emit featureChanged();
    show_handles();
    emit linesChanged();
    showFeature();
    if (line())
        tell(tr("%1, %n point(s).", nullptr, static_cast<int>(line()->nodes.size())).arg(featureName()),
             Priority::touch);
    else
        tell(tr("%1: not there. It can be added.").arg(featureName()), Priority::touch);
}

void MendSession::stepFeature(int step) {
    const int count = static_cast<int>(feature_names_.size());
    if (count > 0)
        chooseFeature((std::max(current_, 0) + step + count) % count);
}

QString MendSession::handleName() const {
    return line() && handle_ >= 0 ? node_words(*line(), static_cast<std::size_t>(handle_)) : QString();
}

QString MendSession::handlePlace() const {
    return line() && handle_ >= 0 ? place_words(line()->nodes[static_cast<std::size_t>(handle_)].at) : QString();
}

bool MendSession::handleIsCorner() const {
    return line() && handle_ >= 0 &&
           line()->nodes[static_cast<std::size_t>(handle_)].kind == MendNode::Kind::corner;
}

bool MendSession::handleTurns() const {
    if (!line() || handle_ < 0)
        return false;
    MendContour trial = *line();
    return toggle_corner(trial, static_cast<std::size_t>(handle_));
}

void MendSession::set_handle(int handle) {
    handle_ = handle;
    emit handleChanged();
    emit linesChanged();
}

void MendSession::chooseHandle(int index) {
    if (!line() || index < 0 || index >= handles_.rowCount())
        return;
    history_.end_run();
    set_handle(index);
    view_.bring_in_sight(line()->nodes[static_cast<std::size_t>(index)].at);
    emit viewChanged();
    tell_handle();
}

void MendSession::tell_handle() {
    tell(tr("%1: %2.").arg(handleName(), handlePlace()), Priority::touch);
}

bool MendSession::stepHandle(int step) {
    const int count = handles_.rowCount();
    const int next = handle_ < 0 ? (step > 0 ? 0 : count - 1) : handle_ + step;
    if (count == 0 || next < 0 || next >= count) {
        set_handle(-1);
        return false;
    }
    chooseHandle(next);
    return true;
}

std::optional<int> MendSession::handle_at(QPointF place, double reach) const {
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

std::optional<int> MendSession::line_at(QPointF place, double reach) const {
    std::optional<int> best;
    double nearest = reach / view_.scale();
    const Vec2 at = view_.to_photo(place);
    for (int i = 0; const auto own_place = place_of(i); ++i) {
        const MendFeature& feature = photo_.work.faces[own_place->face].features[own_place->feature];
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

void MendSession::tap(double x, double y, double reach) {
    if (const auto handle = handle_at({x, y}, reach))
        return chooseHandle(*handle);
    const auto other = line_at({x, y}, reach);
    if (other && *other != current_)
        chooseFeature(*other);
}

void MendSession::whereAmI() {
    if (state_ != State::Ready || !own())
        return enter();
    if (!line())
        return tell(tr("%1: not there. It can be added.").arg(featureName()), Priority::touch);
    if (handle_ < 0)
        return tell(tr("%1, %n point(s), none in hand.", nullptr, static_cast<int>(line()->nodes.size()))
                        .arg(featureName()),
                    Priority::touch);
    tell(tr("%1 of the %2: %3.").arg(handleName(), featureName(), handlePlace()), Priority::touch);
}

void MendSession::setWholeFeature(bool whole) {
    if (whole == whole_)
        return;
    whole_ = whole;
    history_.end_run();
    emit modeChanged();
    tell(whole ? tr("The whole feature moves.") : tr("One point moves."), Priority::touch);
}

// --- mending ---

void MendSession::step(const QString& what, const QString& run) { history_.before(photo_.work, what, run); }

MendContour& MendSession::mend() {
    own()->mended = true;
    return *own()->line;
}

void MendSession::show_handles() {
    std::vector<HandleModel::Row> rows;
    if (const MendContour* contour = line())
        for (std::size_t i = 0; i < contour->nodes.size(); ++i)
            rows.push_back({point(contour->nodes[i].at), node_words(*contour, i)});
    handles_.set(std::move(rows));
    if (handle_ >= handles_.rowCount())
        handle_ = handles_.rowCount() - 1;
    emit handleChanged();
}

void MendSession::lines_changed() {
    text_ = text_of(photo_.work);
    unsaved_ = photo_.usable && photo_.contours.differs(photo_.work);
    show_handles();
    emit linesChanged();
    preview();
}

bool MendSession::grab(double x, double y, double reach) {
    if (state_ != State::Ready || !line())
        return false;
    const Vec2 hand = view_.to_photo({x, y});
    const auto handle = handle_at({x, y}, reach);
    if (!handle && !(whole_ && line_at({x, y}, reach) == current_))
        return false;
    history_.end_run();
    if (handle)
        set_handle(*handle);
    drag_ = Drag{hand, handle ? line()->nodes[static_cast<std::size_t>(*handle)].at - hand : Vec2(0.0), false};
    return true;
}

void MendSession::dragTo(double x, double y) {
    if (!drag_ || !line())
        return;
    const Vec2 hand = view_.to_photo({x, y});
    if (hand == drag_->last)
        return;
    const QString run = QStringLiteral("drag");
    step(whole_ ? tr("the %1 was moved").arg(featureName()) : tr("a point of the %1 was moved").arg(featureName()),
         run);
    drag_->moved = true;
    if (whole_)
        move_all(mend(), hand - drag_->last);
    else
        move_node(mend(), static_cast<std::size_t>(handle_), hand + drag_->offset);
    drag_->last = hand;
    lines_changed();
}

void MendSession::drop() {
    if (!drag_)
        return;
    const bool moved = drag_->moved;
    drag_.reset();
    history_.end_run();
    if (moved && !whole_)
        tell_handle();
    else if (moved)
        tell(tr("%1 moved.").arg(featureName()), Priority::touch);
    else
        tell_handle();
}

bool MendSession::cancelDrag() {
    if (!drag_)
        return false;
    const bool moved = drag_->moved;
    drag_.reset();
    if (moved) {
        history_.take_back(photo_.work);
        lines_changed();
        tell(tr("Put back."), Priority::touch);
    }
    return true;
}

void MendSession::move_by(Vec2 by, const QString& run) {
    if (!line() || (!whole_ && handle_ < 0) || !is_finite(by))
        return;
    const QString name = featureName();
    step(whole_ ? tr("the %1 was moved").arg(name) : tr("a point of the %1 was moved").arg(name), run);
    if (whole_) {
        move_all(mend(), by);
    } else {
        const auto node = static_cast<std::size_t>(handle_);
        move_node(mend(), node, line()->nodes[node].at + by);
        view_.bring_in_sight(line()->nodes[node].at);
        emit viewChanged();
    }
    lines_changed();
    if (whole_)
        tell(tr("%1: %2.").arg(name, place_words(bounds_of(*line()).centre())), Priority::touch);
    else
        tell(tr("%1.").arg(handlePlace()), Priority::touch);
}

void MendSession::nudge(double dx, double dy) {
    if (state_ != State::Ready || drag_)
        return;
    if (!line())
        return whereAmI();
    if (!whole_ && handle_ < 0)
        return tell(tr("No point is in hand. Tab goes from point to point."), Priority::touch);
    move_by({dx, dy}, QStringLiteral("nudge %1 %2 %3").arg(current_).arg(whole_ ? -1 : handle_).arg(whole_));
}

void MendSession::nudgeHandle(int index, double dx, double dy) {
    if (index < 0 || index >= handles_.rowCount())
        return;
    if (index != handle_)
        set_handle(index);
    nudge(dx, dy);
}

void MendSession::addPoint() {
    if (!line())
        return whereAmI();
    step(tr("a point of the %1 was added").arg(featureName()));
    const std::size_t node = add_node_after(mend(), static_cast<std::size_t>(std::max(handle_, 0)));
    lines_changed();
    set_handle(static_cast<int>(node));
    tell(tr("Added. %1: %2.").arg(handleName(), handlePlace()), Priority::touch);
}

void MendSession::addPointAt(double x, double y) {
    if (!line())
        return;
    step(tr("a point of the %1 was added").arg(featureName()));
    const std::size_t node = add_node_near(mend(), view_.to_photo({x, y}));
    lines_changed();
    set_handle(static_cast<int>(node));
    tell(tr("Added. %1: %2.").arg(handleName(), handlePlace()), Priority::touch);
}

void MendSession::deletePoint() {
    if (!line() || handle_ < 0)
        return tell(tr("No point is in hand. Tab goes from point to point."), Priority::touch);
    MendContour left = *line();
    if (!delete_node(left, static_cast<std::size_t>(handle_)))
        return tell(tr("The %1 needs its last points. The whole feature can be removed.").arg(featureName()),
                    Priority::touch);
    step(tr("a point of the %1 was deleted").arg(featureName()));
    mend() = std::move(left);
    lines_changed();
    tell(tr("Deleted. In hand: %1.").arg(handleName()), Priority::touch);
}

void MendSession::turnCorner() {
    if (!handleTurns())
        return tell(tr("This point can be no corner."), Priority::touch);
    step(tr("a point of the %1 was turned").arg(featureName()));
    toggle_corner(mend(), static_cast<std::size_t>(handle_));
    lines_changed();
    tell(handleIsCorner() ? tr("A corner now.") : tr("Smooth now."), Priority::touch);
}

void MendSession::resetFeature() {
    if (!own())
        return;
    if (!own()->mended)
        return tell(tr("The %1 is as the program found it.").arg(featureName()), Priority::touch);
    step(tr("the %1 was reset").arg(featureName()));
    own()->line = own()->found_felt ? own()->found : std::nullopt;
    own()->mended = false;
    lines_changed();
    showFeature();
    tell(line() ? tr("The %1 is as the program found it again.").arg(featureName())
                : tr("The %1 is gone again: the program did not find it.").arg(featureName()),
         Priority::touch);
}

void MendSession::addFeature() {
    const auto place = place_of(current_);
    if (!place)
        return;
    if (line())
        return tell(tr("The %1 is there already.").arg(featureName()), Priority::touch);
    step(tr("the %1 was added").arg(featureName()));
    const MendFace& face = photo_.work.faces[place->face];
    own()->line = own()->found ? *own()->found : template_for(face, own()->name);
    own()->mended = !own()->found_felt;
    handle_ = -1;
    lines_changed();
    showFeature();
    tell(own()->found ? tr("The %1 is there, as the program found it.").arg(featureName())
                      : tr("The %1 was added in its usual shape. Move it into place.").arg(featureName()),
         Priority::touch);
}

void MendSession::removeFeature() {
    if (!line())
        return whereAmI();
    step(tr("the %1 was removed").arg(featureName()));
    own()->line.reset();
    own()->mended = true;
    handle_ = -1;
    lines_changed();
    tell(tr("The %1 is removed. It will not be felt.").arg(featureName()), Priority::touch);
}

void MendSession::addFace() {
    if (state_ != State::Ready)
        return;
    step(tr("a face was added"));
    const double height = 0.5 * std::min(photo_.work.height, 1.25 * photo_.work.width);
    photo_.work.faces.push_back(usual_face(view_.to_photo(view_.middle()), height));
    list_features();
    current_ = static_cast<int>(feature_names_.size() - static_cast<int>(photo_.work.faces.back().features.size()));
    handle_ = -1;
    emit featureChanged();
    lines_changed();
    view_.show(photo_.work.faces.back().box);
    emit viewChanged();
    tell(tr("A face of usual shape was added. Move its features into place."), Priority::touch);
}

void MendSession::undo() {
    cancelDrag();
    const QString what = history_.undo(photo_.work);
    if (what.isEmpty())
        return tell(tr("There is nothing to undo."), Priority::touch);
    list_features();
    current_ = std::min(current_, static_cast<int>(feature_names_.size()) - 1);
    emit featureChanged();
    lines_changed();
    tell(tr("Undone: %1.").arg(what), Priority::touch);
}

void MendSession::redo() {
    cancelDrag();
    const QString what = history_.redo(photo_.work);
    if (what.isEmpty())
        return tell(tr("There is nothing to do again."), Priority::touch);
    list_features();
    emit featureChanged();
    lines_changed();
    tell(tr("Done again: %1.").arg(what), Priority::touch);
}

// --- the disk ---

bool MendSession::write(QString& problem) {
    if (!photo_.usable || !photo_.contours.differs(photo_.work))
        return true;
    problem = in_persons_language(photo_.contours.save(photo_.work));
    if (problem.isEmpty())
        emit saved(photo_.file);
    return problem.isEmpty();
}

bool MendSession::save() {
    if (!unsaved_)
        return true;
    QString problem;
    if (!write(problem)) {
        tell(tr("%1 Your work is kept here; nothing is lost.").arg(problem), Priority::message);
        return false;
    }
    unsaved_ = false;
    emit linesChanged();
    const auto& aside = photo_.contours.kept_aside();
    tell(aside.empty() ? tr("The contours are saved.")
                       : tr("The contours are saved. Another program had changed them; what it wrote is kept as %1.")
                             .arg(QString::fromStdString(aside.filename().string())),
         Priority::message);
    return true;
}

void MendSession::discard() {
    if (!canDiscard())
        return tell(tr("Nothing was changed."), Priority::touch);
    cancelDrag();
    step(tr("all changes were discarded"));
    photo_.work = opened_;
    list_features();
    current_ = std::min(current_, static_cast<int>(feature_names_.size()) - 1);
    handle_ = -1;
    emit featureChanged();
    lines_changed();
    tell(tr("All changes are discarded: the contours are as they were opened."), Priority::message);
}

// --- what is felt ---

void MendSession::setForceShown(bool shown) {
    if (shown == force_shown_)
        return;
    force_shown_ = shown;
    emit modeChanged();
    preview();
    tell(shown ? tr("The force is shown.") : tr("The force is hidden."), Priority::touch);
}

void MendSession::preview() {
    if (state_ != State::Ready)
        return;
    preview_due_ = preview_.busy(); // then the contours as they are by its end are next
    if (preview_due_)
        return;
    preview_.ask([this, work = photo_.work](const std::stop_token&) -> NewestWork::Answer {
        return [this, felt = felt_change(found_faces(work), faces_of(work))] {
            felt_ = felt;
            emit fieldChanged();
            if (preview_due_)
                preview();
        };
    });
}

} // namespace tp
