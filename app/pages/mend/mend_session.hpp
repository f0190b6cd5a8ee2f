// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/felt_change.hpp"
#include "app/pages/mend/handle_model.hpp"
#include "app/pages/mend/mend_history.hpp"
#include "app/pages/mend/mend_photo.hpp"
#include "app/pages/mend/mend_view.hpp"
#include "app/pages/mend/mend_words.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/work/newest_work.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QStringList>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tp {

/// A photograph's contours while a person mends them: everything that the mend page decides.
///
/// Places that a page gives are window pixels of its drawing surface, everything else pixels of the upright
/// photograph.
class MendSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(State state READ state NOTIFY photoChanged)
    Q_PROPERTY(QString photoName READ photoName NOTIFY photoChanged)
    Q_PROPERTY(QImage photo READ photo NOTIFY photoChanged)

    Q_PROPERTY(QPointF viewOrigin READ viewOrigin NOTIFY viewChanged)
    Q_PROPERTY(double viewScale READ viewScale NOTIFY viewChanged)
    Q_PROPERTY(QRectF photoRect READ photoRect NOTIFY viewChanged) ///< window px

    /// Names of all features of all faces, there or not.
    Q_PROPERTY(QStringList features READ features NOTIFY featuresChanged)
    Q_PROPERTY(int feature READ feature NOTIFY featureChanged)
    Q_PROPERTY(QString featureName READ featureName NOTIFY featureChanged)
    Q_PROPERTY(bool featureThere READ featureThere NOTIFY linesChanged)
    Q_PROPERTY(bool featureMended READ featureMended NOTIFY linesChanged)
    Q_PROPERTY(tp::HandleModel* handles READ handles CONSTANT)
    Q_PROPERTY(int handle READ handle NOTIFY handleChanged) ///< -1: none
    Q_PROPERTY(QString handleName READ handleName NOTIFY handleChanged)
    Q_PROPERTY(QString handlePlace READ handlePlace NOTIFY linesChanged)
    Q_PROPERTY(bool handleTurns READ handleTurns NOTIFY linesChanged) ///< a corner can be made of it, or undone
    Q_PROPERTY(bool handleIsCorner READ handleIsCorner NOTIFY linesChanged)
    Q_PROPERTY(bool wholeFeature READ wholeFeature WRITE setWholeFeature NOTIFY modeChanged)

    Q_PROPERTY(bool forceShown READ forceShown WRITE setForceShown NOTIFY modeChanged)
    Q_PROPERTY(QString change READ change NOTIFY fieldChanged) ///< how much what is felt changed
    Q_PROPERTY(bool unsaved READ unsaved NOTIFY linesChanged)
    Q_PROPERTY(bool canUndo READ canUndo NOTIFY linesChanged)
    Q_PROPERTY(bool canRedo READ canRedo NOTIFY linesChanged)
    Q_PROPERTY(bool canDiscard READ canDiscard NOTIFY linesChanged)
    Q_PROPERTY(QString sentence READ sentence NOTIFY sentenceChanged)
public:
    enum class State {
        Empty,   ///< no photograph yet
        Looking, ///< one is being read
        Ready,   ///< its contours can be mended
        Problem  ///< they cannot; `sentence` says why
    };
    Q_ENUM(State)

    /// The narrator must outlive the session.
    explicit MendSession(Narrator& narrator);
    /// What is not saved yet is saved.
    ~MendSession() override;

    State state() const { return state_; }
    QString photoName() const;
    QImage photo() const { return photo_.image; }
    QPointF viewOrigin() const { return view_.origin(); }
    double viewScale() const { return view_.scale(); }
    QRectF photoRect() const { return view_.photo_rect(); }
    const QStringList& features() const { return feature_names_; }
    int feature() const { return current_; }
    QString featureName() const { return name_of(current_); }
    bool featureThere() const { return line() != nullptr; }
    bool featureMended() const;
    HandleModel* handles() { return &handles_; }
    int handle() const { return handle_; }
    QString handleName() const;
    QString handlePlace() const;
    bool handleTurns() const;
    bool handleIsCorner() const;
    bool wholeFeature() const { return whole_; }
    void setWholeFeature(bool whole);
    bool forceShown() const { return force_shown_; }
    void setForceShown(bool shown);
    QString change() const { return change_words(felt_.difference); }
    bool unsaved() const { return unsaved_; }
    bool canUndo() const { return history_.can_undo(); }
    bool canRedo() const { return history_.can_redo(); }
    bool canDiscard() const { return opened_text_ != text_; }
    QString sentence() const { return sentence_; }

    const MendWork& work() const { return photo_.work; }
    const MendView& view() const { return view_; }
    const FeltChange& felt() const { return felt_; }
    /// The contour in hand; null where there is none.
    const MendContour* line() const;
    /// Whether the field shown belongs to the contours as they are.
    bool felt_is_current() const { return !preview_.busy() && !preview_due_; }

    /// The page comes into view, or goes: it tells where one is, or saves what is not saved.
    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();

    /// Reads a photograph and lays its contours out. What was not saved is saved first; where that is refused the
    /// photograph in hand stays.
    Q_INVOKABLE void open(const QUrl& file);
    void open_file(const QString& file);
    /// A photograph that is read already.
    void show(MendPhoto photo);

    // --- what is seen ---
    Q_INVOKABLE void setWindow(double width, double height);
    Q_INVOKABLE void zoomBy(double factor);
    Q_INVOKABLE void zoomAt(double factor, double x, double y);
    Q_INVOKABLE void panBy(double dx, double dy);
    Q_INVOKABLE void showAll();
    Q_INVOKABLE void showFeature();

    // --- what is in hand ---
    Q_INVOKABLE void chooseFeature(int index);
    Q_INVOKABLE void stepFeature(int step);
    Q_INVOKABLE void chooseHandle(int index);
    /// To the next (+1) or previous (-1) point; false where there is none left, so that the keyboard's focus may
    /// leave the surface.
    Q_INVOKABLE bool stepHandle(int step);
    /// A short press: the point there is taken in hand, or the feature whose line passes within `reach`.
    Q_INVOKABLE void tap(double x, double y, double reach);
    Q_INVOKABLE void whereAmI();

    // --- mending ---
    /// Takes the point there, within `reach`, by hand; false where there is none.
    Q_INVOKABLE bool grab(double x, double y, double reach);
    Q_INVOKABLE void dragTo(double x, double y);
    Q_INVOKABLE void drop();
    /// Puts what is dragged back; false where nothing is.
    Q_INVOKABLE bool cancelDrag();
    /// Moves the point, or the whole feature, by pixels of the photograph.
    Q_INVOKABLE void nudge(double dx, double dy);
    /// The same for a point by its number, as a screen reader moves it.
    Q_INVOKABLE void nudgeHandle(int index, double dx, double dy);
    Q_INVOKABLE void addPoint();
    Q_INVOKABLE void addPointAt(double x, double y);
    Q_INVOKABLE void deletePoint();
    Q_INVOKABLE void turnCorner();
    Q_INVOKABLE void resetFeature();
    Q_INVOKABLE void addFeature();
    Q_INVOKABLE void removeFeature();
    Q_INVOKABLE void addFace();
    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();
    /// Brings the contours to the disk; false where that is refused.
    Q_INVOKABLE bool save();
    /// As they were when the photograph was opened; can be undone.
    Q_INVOKABLE void discard();

signals:
    void photoChanged();
    void viewChanged();
    void featuresChanged();
    void featureChanged();
    void handleChanged();
    void linesChanged();
    void modeChanged();
    void fieldChanged();
    void sentenceChanged();
    /// The contours of that photograph are others now, on the disk.
    void saved(const QString& photo);

private:
    struct Place {
        std::size_t face, feature;
    };

    void tell(const QString& sentence, Priority priority);
    void become(State state);
    std::optional<Place> place_of(int index) const;
    MendFeature* own();
    const MendFeature* own() const;
    QString name_of(int index) const;
    std::optional<int> handle_at(QPointF place, double reach) const;
    std::optional<int> line_at(QPointF place, double reach) const;
    void set_handle(int handle);
    void list_features();
    void lines_changed();
    void show_handles();
    /// Remembers the state before a step, unless the run has begun.
    void step(const QString& what, const QString& run = {});
    /// The contour in hand is a person's now.
    MendContour& mend();
    void move_by(Vec2 by, const QString& run);
    void preview();
    void tell_handle();
    bool write(QString& problem);

    Narrator& narrator_;
    State state_ = State::Empty;
    QString sentence_;
    MendPhoto photo_;
    MendWork opened_;
    std::string opened_text_, text_; ///< of the sheet: as it was opened, and now
    bool unsaved_ = false;

    MendView view_;
    QStringList feature_names_;
    int current_ = -1;
    HandleModel handles_;
    int handle_ = -1;
    bool whole_ = false;
    MendHistory history_;

    struct Drag {
        Vec2 last{0.0};   ///< where the hand was, px of the photograph
        Vec2 offset{0.0}; ///< from the hand to the point it holds
        bool moved = false;
    };
    std::optional<Drag> drag_;

    bool force_shown_ = false;
    FeltChange felt_;
    bool preview_due_ = false;

    std::unique_ptr<FaceExtractor> extractor_; ///< only the loader's thread
    NewestWork preview_;
    NewestWork loader_; ///< last: its thread ends first
};

} // namespace tp
