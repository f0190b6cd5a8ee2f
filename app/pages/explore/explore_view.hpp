// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_choices.hpp"
#include "app/pages/explore/explore_settings.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/photo_loader.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/sheet_frame.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/geometry/transform.hpp"
#include "core/guidance/guidance_law.hpp"
#include "faces/base/face.hpp"

#include <QImage>
#include <QObject>
#include <QRectF>
#include <QString>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace tp {

/// What is shown and felt: a photograph, its faces, and where they lie on the surface. QML places are in the
/// sheet's frame (see SheetFrame).
///
/// |         | load    | found | nothing | give_up                         |
/// |---------|---------|-------|---------|---------------------------------|
/// | Empty   | Looking | Ready | Problem |                                 |
/// | Looking | Looking | Ready | Problem | what was open before, else Empty |
/// | Ready   | Looking | Ready | Problem |                                 |
/// | Problem | Looking | Ready | Problem |                                 |
///
/// Looking into a photograph is loading one for whoever decides whether to show it, to look into another, or to turn back.
class ExploreView final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(State state READ state NOTIFY photoChanged)
    Q_PROPERTY(QString photoName READ photoName NOTIFY photoChanged)
    /// "Anna and Tom"; the file's name where nobody said who is on the photograph.
    Q_PROPERTY(QString title READ title NOTIFY photoChanged)
    Q_PROPERTY(QImage photo READ photo NOTIFY photoChanged)
    Q_PROPERTY(QRectF photoRect READ photoRect NOTIFY sceneChanged)
    /// mm
    Q_PROPERTY(double surfaceWidth READ surfaceWidth CONSTANT)
    Q_PROPERTY(double surfaceHeight READ surfaceHeight CONSTANT)
    /// One entry a face: {name, rect, chosen, features: [{index, name, rect}]}; a rect is what of it lies on
    /// the surface.
    Q_PROPERTY(QVariantList faces READ faces NOTIFY sceneChanged)
    Q_PROPERTY(int faceCount READ faceCount NOTIFY sceneChanged)
    Q_PROPERTY(int featureCount READ featureCount NOTIFY sceneChanged)
public:
    enum class State {
        Empty,   ///< no photograph yet
        Looking, ///< one is being read
        Ready,   ///< there is something to feel
        Problem  ///< there is not; the words say why
    };
    Q_ENUM(State)

    /// All must outlive this.
    ExploreView(const ExploreSettings& settings, FingerServo& servo, ExploreWords& words,
                ExploreChoices& choices);

    State state() const { return state_; }
    bool ready() const { return state_ == State::Ready; }
    QString photoName() const { return photo_ ? photo_->name : QString(); }
    /// The photograph that is open; empty: none, or none that is a file.
    QString file() const { return photo_ ? photo_->file : QString(); }
    QString title() const;
    QImage photo() const { return photo_ ? photo_->image : QImage(); }
    QRectF photoRect() const { return photo_rect_; }
    double surfaceWidth() const { return frame_.width_mm; }
    double surfaceHeight() const { return frame_.height_mm; }
    const QVariantList& faces() const { return faces_; }
    int faceCount() const { return photo_ ? static_cast<int>(photo_->extraction.faces.size()) : 0; }
    int featureCount() const { return static_cast<int>(servo_.felt().lines.size()); }

    /// Reads a photograph and makes it felt. Returns at once.
    void load(const QString& file);
    /// Reads one, which `looked_into` then hands over instead. Returns at once.
    void look_into(const QString& file);
    /// That is what it does.
    bool looking_into() const { return looking_into_; }
    /// There is something on it for the finger.
    bool can_be_felt(const LoadedPhoto& photo) const;
    /// A photograph that is loaded already; `before` is said before what was found.
    void show(std::shared_ptr<const LoadedPhoto> photo, const QString& before = {});
    /// Looks no further: back to what was open before.
    void turn_back();
    /// The same. Returns the sentence for that.
    QString give_up();
    /// Fits that into the surface; false, and nothing has changed, where it is too small for that. Only where
    /// Ready.
    bool fit(const Subject& subject);
    /// The device in use reaches only that polygon, surface frame, mm; empty: everything.
    void reach(std::vector<Vec2> reach);
    /// Says everything anew in another language.
    void retranslate();

    /// What is felt, in the surface frame, and how a page sees that frame.
    const FlatScene& felt() const { return servo_.felt(); }
    const SheetFrame& frame() const { return frame_; }
    const Subject& subject() const { return subject_; }
    /// What was found; only where there is a photograph.
    const Extraction& extraction() const { return photo_->extraction; }
    /// One for each line that is felt.
    const std::vector<SceneFeature>& features() const { return features_; }
    const SceneFeature& feature(int index) const { return features_[static_cast<std::size_t>(index)]; }
    const Polyline& line(int feature) const { return servo_.felt().lines[static_cast<std::size_t>(feature)]; }
    /// Where each face lies, surface frame.
    const std::vector<Rect>& face_places() const { return face_places_; }
    /// The nearest line of all that are felt; only where Ready.
    Guidance nearest(Vec2 place) const { return law_->at(place); }

    /// What the photograph is, or what can be done where there is none.
    QString where_one_is() const;
    /// Whose face it is; empty where nobody said.
    QString person_of(std::size_t face) const;
    /// "Anna", "face 2", "the face".
    QString name_of_face(std::size_t face) const;
    /// "left eye of Anna"; empty for none.
    QString label_of(int feature) const;

signals:
    void photoChanged();
    void sceneChanged();
    void looked_into(std::shared_ptr<const tp::LoadedPhoto> photo);
    /// What is felt is about to be another: who leads the finger along a line lets go.
    void replacing();
    /// It is another: what counted its features begins anew. Before photoChanged and sceneChanged.
    void replaced();
    /// A photograph that nobody has felt yet is Ready. After those.
    void fresh();

private:
    void become(State state);
    void forget_scene();
    void begin_to_look();
    std::shared_ptr<const LoadedPhoto> with_wanted_extras(const LoadedPhoto& photo) const;
    void build(bool anew);
    void list_faces();
    void take_extras();

    FingerServo& servo_;
    ExploreWords& words_;
    ExploreChoices& choices_;
    SurfaceSize surface_;
    SheetFrame frame_;

    State state_ = State::Empty;
    bool looking_into_ = false;
    QString found_;                             ///< what was found in the photograph, or why nothing
    std::shared_ptr<const LoadedPhoto> loaded_; ///< as it came
    std::shared_ptr<const LoadedPhoto> photo_;  ///< with the extras that the person wants
    Subject subject_;
    std::vector<SceneFeature> features_;
    std::vector<Rect> face_places_;
    std::unique_ptr<const GuidanceLaw>
        law_; ///< the exact one, for distance and direction; null: nothing is felt
    Affine photo_to_surface_;
    QRectF photo_rect_;
    QVariantList faces_;
    PhotoLoader loader_; ///< last: its thread ends first
};

} // namespace tp
