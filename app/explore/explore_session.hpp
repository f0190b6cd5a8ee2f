// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/explore/fault_watch.hpp"
#include "app/explore/feature_tracker.hpp"
#include "app/explore/finger_servo.hpp"
#include "app/narration/narrator.hpp"
#include "app/explore/photo_loader.hpp"
#include "app/explore/sheet_frame.hpp"
#include "app/scene/extra_features.hpp"

#include <QElapsedTimer>
#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QTimer>
#include <QUrl>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace tp {

struct ExploreSettings {
    SurfaceSize surface;
    ExtraFeatures extras;
    ServoSettings servo = settings_for_a_drawn_finger();
    SimulatedPlant plant;
};

/// A photograph being felt: everything that the explore page decides. The page only binds and draws.
///
/// Places are in the sheet's frame (see SheetFrame), forces in newtons with y down, as they are drawn.
class ExploreSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(State state READ state NOTIFY photoChanged)
    Q_PROPERTY(QString photoName READ photoName NOTIFY photoChanged)
    Q_PROPERTY(QImage photo READ photo NOTIFY photoChanged)
    Q_PROPERTY(QRectF photoRect READ photoRect NOTIFY sceneChanged)
    Q_PROPERTY(double surfaceWidth READ surfaceWidth CONSTANT)
    Q_PROPERTY(double surfaceHeight READ surfaceHeight CONSTANT)
    /// One entry a face: {name, rect, chosen, features: [{index, name, rect}]}.
    Q_PROPERTY(QVariantList faces READ faces NOTIFY sceneChanged)
    Q_PROPERTY(int faceCount READ faceCount NOTIFY sceneChanged)
    Q_PROPERTY(int featureCount READ featureCount NOTIFY sceneChanged)

    Q_PROPERTY(QPointF finger READ finger NOTIFY handMoved)
    Q_PROPERTY(QPointF pointer READ pointer NOTIFY handMoved)
    Q_PROPERTY(QPointF force READ force NOTIFY handMoved)
    Q_PROPERTY(double newtons READ newtons NOTIFY handMoved)
    Q_PROPERTY(double tourProgress READ tourProgress NOTIFY handMoved)

    Q_PROPERTY(int feature READ feature NOTIFY featureChanged)
    Q_PROPERTY(QString featureName READ featureName NOTIFY featureChanged)
    Q_PROPERTY(bool engaged READ engaged NOTIFY modeChanged)
    Q_PROPERTY(bool touring READ touring NOTIFY modeChanged)
    Q_PROPERTY(QString faultSentence READ faultSentence NOTIFY modeChanged)
    Q_PROPERTY(double maxForce READ maxForce WRITE setMaxForce NOTIFY modeChanged)
    Q_PROPERTY(QString sentence READ sentence NOTIFY sentenceChanged)
    Q_PROPERTY(bool voiceOn READ voiceOn WRITE setVoiceOn NOTIFY voiceChanged)
    Q_PROPERTY(QString voiceProblem READ voiceProblem NOTIFY voiceChanged)
public:
    enum class State {
        Empty,   ///< no photograph yet
        Looking, ///< one is being read
        Ready,   ///< there is something to feel
        Problem  ///< there is not; `sentence` says why
    };
    Q_ENUM(State)

    /// The narrator must outlive the session.
    explicit ExploreSession(Narrator& narrator, ExploreSettings settings = {});

    State state() const { return state_; }
    QString photoName() const { return photo_ ? photo_->name : QString(); }
    QImage photo() const { return photo_ ? photo_->image : QImage(); }
    QRectF photoRect() const { return photo_rect_; }
    double surfaceWidth() const { return frame_.width_mm; }
    double surfaceHeight() const { return frame_.height_mm; }
    QVariantList faces() const { return faces_; }
    int faceCount() const { return photo_ ? static_cast<int>(photo_->extraction.faces.size()) : 0; }
    int featureCount() const { return static_cast<int>(servo_.felt().lines.size()); }
    QPointF finger() const { return finger_; }
    QPointF pointer() const { return pointer_; }
    QPointF force() const { return force_; }
    double newtons() const { return std::hypot(force_.x(), force_.y()); }
    double tourProgress() const { return tour_progress_; }
    int feature() const { return tracker_.current(); }
    QString featureName() const { return name_of(tracker_.current()); }
    bool engaged() const { return servo_.engaged(); }
    bool touring() const { return servo_.leads(); }
    QString faultSentence() const { return QString::fromUtf8(tp::sentence(faults_.shown())); }
    double maxForce() const { return max_force_; }
    void setMaxForce(double newtons);
    QString sentence() const { return sentence_; }
    bool voiceOn() const { return narrator_.voice_on(); }
    void setVoiceOn(bool on) { narrator_.set_voice_on(on); }
    QString voiceProblem() const { return narrator_.voice_problem(); }

    /// What is felt, in the surface frame, and how a page sees that frame.
    const FlatScene& felt() const { return servo_.felt(); }
    const SheetFrame& frame() const { return frame_; }

    /// Reads a photograph and makes it felt; `sentence` says what was found. Returns at once.
    Q_INVOKABLE void open(const QUrl& file);
    void open_file(const QString& file);
    /// Where a file dialog begins: the user's pictures.
    Q_INVOKABLE QUrl picturesFolder() const;
    /// A photograph that is loaded already.
    void show(std::shared_ptr<const LoadedPhoto> photo);
    /// Tells something that went wrong on the page itself.
    Q_INVOKABLE void tellProblem(const QString& sentence);

    /// The finger is set down there (a touch begins, the mouse comes in).
    Q_INVOKABLE void touchDown(double x, double y);
    /// The hand is there now; the same place again is no movement.
    Q_INVOKABLE void moveTo(double x, double y);
    /// The hand moves by so many millimetres (arrow keys).
    Q_INVOKABLE void nudge(double dx, double dy);

    /// To the next (+1) or previous (-1) feature; false where there is none left, so that the keyboard's
    /// focus may leave the surface.
    Q_INVOKABLE bool stepFeature(int step);
    Q_INVOKABLE void goToFeature(int index);
    /// Fits one face into the surface; -1: all of them.
    Q_INVOKABLE void chooseFace(int index);
    /// All faces, the first, the second, …, all faces.
    Q_INVOKABLE void nextFace();

    /// Starts the tour round the current feature, or ends it.
    Q_INVOKABLE void toggleTour();
    /// Everything stops: tour, speech, force, the search for faces in a photograph just opened. Where it is
    /// stopped already, the force comes back.
    Q_INVOKABLE void stopOrStart();
    Q_INVOKABLE void engage();
    Q_INVOKABLE void whereAmI();

signals:
    void photoChanged();
    void sceneChanged();
    void handMoved();
    void featureChanged();
    void modeChanged();
    void sentenceChanged();
    void voiceChanged();

private:
    void poll();
    void follow_finger(Vec2 finger);
    void watch_faults(Fault fault);
    void tell(const QString& sentence, Priority priority);
    void become(State state);
    void build();
    void list_faces(const BuiltScene& built);
    void set_feature(int index);
    void stop_everything();
    void stop_looking();
    void end_tour(const QString& sentence);
    bool grabs(Vec2 to);
    int tour_feature() const;
    QString name_of(int feature) const;

    ExploreSettings settings_;
    SheetFrame frame_;
    Narrator& narrator_;
    FingerServo servo_;
    FeatureTracker tracker_;
    FaultWatch faults_;

    State state_ = State::Empty;
    QString sentence_;
    std::shared_ptr<const LoadedPhoto> photo_;
    QRectF photo_rect_;
    QVariantList faces_;
    std::optional<std::size_t> chosen_face_;
    int last_feature_ = -1; ///< the one that was stepped to or felt last
    double max_force_;

    QPointF finger_, pointer_, force_;
    double tour_progress_ = 0.0;
    std::optional<Vec2> hand_;      ///< surface frame, where mouse or touch was last
    std::optional<Vec2> grab_from_; ///< where it was when a tour began

    QTimer timer_;
    QElapsedTimer clock_;
    PhotoLoader loader_; ///< last: its thread ends first
};

} // namespace tp
