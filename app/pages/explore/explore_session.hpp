// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/clock_guide.hpp"
#include "app/pages/explore/dwell.hpp"
#include "app/pages/explore/fault_watch.hpp"
#include "app/pages/explore/feature_tracker.hpp"
#include "app/pages/explore/finger_servo.hpp"
#include "app/pages/explore/photo_loader.hpp"
#include "app/pages/explore/sheet_frame.hpp"
#include "app/pages/explore/touch_gestures.hpp"
#include "app/pages/explore/way_watch.hpp"
#include "app/parts/devices/device_desk.hpp"
#include "app/parts/devices/fault_words.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/photo/scene/extra_features.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sentences/sentences.hpp"
#include "audio/sound/earcon_player.hpp"
#include "core/guidance/guidance_law.hpp"
#include "core/servo/fault.hpp"

#include <QElapsedTimer>
#include <QEvent>
#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QTimer>
#include <QUrl>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

struct ExploreSettings {
    SurfaceSize surface;
    ExtraFeatures extras; ///< felt beside those that the person has chosen
    ServoSettings servo = settings_for_a_drawn_finger();
    SimulatedPlant plant;
    DeviceAccess devices;           ///< that move a real finger; without one the force is only drawn
    ServoSettings device_servo;     ///< theirs
    double dwell_s = Dwell::usual_s; ///< how long a finger stays on a feature before it is told
    std::function<double()> now;    ///< seconds; empty: real time since the session was made
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
    /// "Anna and Tom"; the file's name where nobody said who is on the photograph.
    Q_PROPERTY(QString title READ title NOTIFY photoChanged)
    Q_PROPERTY(QImage photo READ photo NOTIFY photoChanged)
    Q_PROPERTY(QRectF photoRect READ photoRect NOTIFY sceneChanged)
    Q_PROPERTY(double surfaceWidth READ surfaceWidth CONSTANT)
    Q_PROPERTY(double surfaceHeight READ surfaceHeight CONSTANT)
    /// One entry a face: {name, rect, chosen, features: [{index, name, rect}]}; a rect is what of it lies on the surface.
    Q_PROPERTY(QVariantList faces READ faces NOTIFY sceneChanged)
    Q_PROPERTY(int faceCount READ faceCount NOTIFY sceneChanged)
    Q_PROPERTY(int featureCount READ featureCount NOTIFY sceneChanged)
    Q_PROPERTY(bool zoomed READ zoomed NOTIFY sceneChanged)

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
    /// The device that moves the finger; empty where it is only drawn.
    Q_PROPERTY(QString deviceName READ deviceName NOTIFY modeChanged)
    Q_PROPERTY(double maxForce READ maxForce WRITE setMaxForce NOTIFY choicesChanged)
    /// What guides where no force does: index into guideNames.
    Q_PROPERTY(int guide READ guide WRITE setGuide NOTIFY choicesChanged)
    Q_PROPERTY(QStringList guideNames READ guideNames NOTIFY choicesChanged)
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

    /// All must outlive the session.
    ExploreSession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide, Preferences& preferences,
                   ExploreSettings settings = {});
    /// Nothing sounds behind it.
    ~ExploreSession() override;

    State state() const { return state_; }
    QString photoName() const { return photo_ ? photo_->name : QString(); }
    QString title() const;
    QImage photo() const { return photo_ ? photo_->image : QImage(); }
    QRectF photoRect() const { return photo_rect_; }
    double surfaceWidth() const { return frame_.width_mm; }
    double surfaceHeight() const { return frame_.height_mm; }
    QVariantList faces() const { return faces_; }
    int faceCount() const { return photo_ ? static_cast<int>(photo_->extraction.faces.size()) : 0; }
    int featureCount() const { return static_cast<int>(servo_.felt().lines.size()); }
    bool zoomed() const { return subject_ != Subject{}; }
    QPointF finger() const { return finger_; }
    QPointF pointer() const { return pointer_; }
    QPointF force() const { return force_; }
    double newtons() const { return std::hypot(force_.x(), force_.y()); }
    double tourProgress() const { return tour_progress_; }
    int feature() const { return tracker_.current(); }
    QString featureName() const { return label_of(tracker_.current()); }
    bool engaged() const { return servo_.engaged(); }
    bool touring() const { return servo_.leads() || !tour_left_.empty(); }
    QString faultSentence() const;
    QString deviceName() const;
    double maxForce() const;
    void setMaxForce(double newtons);
    int guide() const { return static_cast<int>(preferences_.choices().guide); }
    void setGuide(int guide);
    QStringList guideNames() const;
    QString sentence() const { return sentence_; }
    bool voiceOn() const { return narrator_.voice_on(); }
    void setVoiceOn(bool on);
    QString voiceProblem() const { return narrator_.voice_problem(); }

    /// What is felt, in the surface frame, and how a page sees that frame.
    const FlatScene& felt() const { return servo_.felt(); }
    const SheetFrame& frame() const { return frame_; }
    const Subject& subject() const { return subject_; }

    /// The page comes into sight: says where one is and what can be done. The force is as it was.
    Q_INVOKABLE void enter();
    /// The page goes out of sight: its sounds, its speech and its force end; nothing is told until `enter`.
    Q_INVOKABLE void leave();
    /// Where the sheet's top left corner lies on the screen, mm from the screen's (x right, y down), and how many real
    /// millimetres each of the sheet's is there. A calibrated device follows it once it lies still.
    Q_INVOKABLE void sheetLies(double left, double top, double scale);
    /// Asks to go where one came from.
    Q_INVOKABLE void back() { emit backAsked(); }

    /// Reads a photograph and makes it felt; `sentence` says what was found. Returns at once.
    Q_INVOKABLE void open(const QUrl& file);
    void open_file(const QString& file);
    /// Where a file dialog begins: the user's pictures.
    Q_INVOKABLE QUrl picturesFolder() const;
    /// A photograph that is loaded already.
    void show(std::shared_ptr<const LoadedPhoto> photo);
    /// Tells something that went wrong on the page itself.
    Q_INVOKABLE void tellProblem(const QString& sentence);

    /// The hand comes in there (mouse).
    Q_INVOKABLE void touchDown(double x, double y);
    /// The hand is there now; the same place again is no movement.
    Q_INVOKABLE void moveTo(double x, double y);
    /// The mouse is off the surface.
    Q_INVOKABLE void handGone();
    /// The hand moves by so many millimetres (arrow keys).
    Q_INVOKABLE void nudge(double dx, double dy);
    /// Fingers on a touchscreen; `id` tells them apart. One explores, several make gestures (TouchGestures).
    Q_INVOKABLE void fingerDown(int id, double x, double y);
    Q_INVOKABLE void fingerMoved(int id, double x, double y);
    Q_INVOKABLE void fingerUp(int id);
    Q_INVOKABLE void fingersCancelled();

    /// To the next (+1) or previous (-1) feature; false where there is none left, so that the keyboard's
    /// focus may leave the surface.
    Q_INVOKABLE bool stepFeature(int step);
    Q_INVOKABLE void goToFeature(int index);
    /// Fits one face into the surface; -1: all of them.
    Q_INVOKABLE void chooseFace(int index);
    /// All faces, the first, the second, …, all faces.
    Q_INVOKABLE void nextFace();
    /// The face under the finger, its eyes, its mouth, everything again (zoom_steps.hpp).
    Q_INVOKABLE void zoomIn();
    Q_INVOKABLE void zoomOut();
    /// To what lies at a place; out where nothing does.
    Q_INVOKABLE void zoomHere(double x, double y);

    /// Starts the tour round the current feature, or ends it.
    Q_INVOKABLE void toggleTour();
    /// Starts the tour of every feature of the face under the finger, each named before; or ends it.
    Q_INVOKABLE void toggleFaceTour();
    /// Stops what sounds or moves: tour, guide, force, the search for faces in a photograph just opened. False where
    /// nothing did.
    Q_INVOKABLE bool stop();
    /// The same; where there is nothing to stop the force comes back.
    Q_INVOKABLE void stopOrStart();
    Q_INVOKABLE void engage();
    /// Face, feature, clock direction and distance; without a photograph, what can be done.
    Q_INVOKABLE void whereAmI();
    /// The next kind of guide, and says which.
    Q_INVOKABLE void nextGuide();

signals:
    void photoChanged();
    void sceneChanged();
    void handMoved();
    void featureChanged();
    void modeChanged();
    void choicesChanged();
    void sentenceChanged();
    void voiceChanged();
    void backAsked();

private:
    enum class Hand { pointing, touching, away };

    // the photograph and what of it is felt
    void become(State state);
    void build(bool fresh);
    void list_faces();
    bool eventFilter(QObject* watched, QEvent* event) override;
    void zoom_to(const Subject& subject);
    QString zoom_sentence() const;
    /// A zoom is being told and the hand has rested since: what it is drawn to then is told afterwards.
    bool tells_a_zoom(double now) const;
    QString where_one_is() const;
    QString person_of(std::size_t face) const;
    QString name_of_face(std::size_t face) const;
    QString label_of(int feature) const;
    ExtraFeatures extras() const;
    void choices_changed();

    // tour and force
    int tour_feature() const;
    void lead_on(double now);
    void end_tour(const QString& sentence);
    void stop_everything();
    void stop_looking();

    // the device
    void leave_device();
    void want_device();
    void devices_seen();
    void use_device(OpenDevice& open);
    void fit_to_reach(std::vector<Vec2> reach);
    std::optional<Affine> on_the_sheet(const Calibration& calibration) const;
    void device_refused(const QString& sentence);
    void device_gone();
    void follow_sheet();

    // the hand
    void poll();
    Vec2 felt_place() const;
    /// Nobody's hand is on the surface: what rests there is not told.
    bool lifted() const {
        return !servo_.real() && (hand_kind_ == Hand::away || (hand_kind_ == Hand::touching && !finger_down_));
    }
    bool grabs(Vec2 to);
    void lift();
    void perform(TouchGestures::Gesture gesture);
    void hear(Vec2 place, double now);
    void follow_finger(Vec2 place, double now);
    void guide_finger(Vec2 place, double now);
    void say_clock(const ClockGuide::Word& word);
    double guide_level(double distance) const;
    bool guides() const;
    void set_feature(int index);
    void watch_faults(Fault fault, double now);

    double now() const;
    void tell(const QString& sentence, Priority priority);
    void murmur(const QString& words);

    ExploreSettings settings_;
    SheetFrame frame_;
    Narrator& narrator_;
    EarconPlayer& earcons_;
    SonifiedGuide& guide_;
    Preferences& preferences_;
    FingerServo servo_;
    FeatureTracker tracker_;
    FaultWatch faults_;
    Dwell dwell_;
    WayWatch way_;
    ClockGuide clock_guide_;
    TouchGestures gestures_;

    State state_ = State::Empty;
    QString sentence_;
    QString found_; ///< what was found in the photograph, or why nothing
    std::shared_ptr<const LoadedPhoto> loaded_; ///< as it came
    std::shared_ptr<const LoadedPhoto> photo_;  ///< with the extras that the person wants
    Subject subject_;
    std::vector<SceneFeature> features_;     ///< one for each line that is felt
    std::vector<Rect> face_rects_;           ///< where each face lies, surface frame
    std::unique_ptr<const GuidanceLaw> law_; ///< the exact one, for distance and direction; null: nothing is felt
    Affine photo_to_surface_;
    QRectF photo_rect_;
    QVariantList faces_;
    int last_feature_ = -1; ///< the one that was stepped to or felt last

    QPointF finger_, pointer_, force_;
    Hand hand_kind_ = Hand::pointing;
    bool finger_down_ = false;
    bool hushed_ = false;     ///< stopped by the person: the guide waits for the next touch
    double moved_at_ = -1e9;  ///< s, when the hand last moved
    double zoomed_at_ = -1e9, zoom_told_at_ = -1e9; ///< s, the last zoom, and when its sentence has been spoken
    Vec2 zoomed_from_{0.0};   ///< where the finger was then, surface frame
    double tour_progress_ = 0.0;
    std::deque<int> tour_left_;      ///< features of the tour of a face, the next one first
    double tour_goes_on_at_ = 0.0;   ///< s, when its name has been spoken
    bool toured_before_tap_ = false; ///< what the first of two taps has stopped
    std::optional<Vec2> hand_;       ///< surface frame, where mouse or touch was last
    std::optional<Vec2> grab_from_;  ///< where it was when a tour began
    bool here_ = true;               ///< the page is in sight
    bool force_wanted_ = true;       ///< when it comes back into sight

    Affine screen_to_surface_;     ///< mm
    QTimer sheet_settles_;         ///< since it was last told to lie elsewhere
    std::optional<Affine> device_sheet_; ///< screen_to_surface_ as a calibrated device in use follows it
    QString device_about_;         ///< of the one that moves the finger
    std::string refused_;          ///< name of the one that could not be opened; it is not asked again by itself
    bool device_expected_ = false; ///< the person has just come: a device that is there gets the force at once
    Vec2 device_was_at_{0.0};      ///< surface frame

    QTimer timer_;
    QElapsedTimer clock_;
    DeviceDesk desk_;
    PhotoLoader loader_; ///< last: its thread ends first
};

} // namespace tp
