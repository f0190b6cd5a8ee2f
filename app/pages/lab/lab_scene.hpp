// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_field.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "app/pages/lab/lab_tuning.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/parts/work/latest_task.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <memory>

namespace tp {

class FaceExtractor;

/// What is felt on the surface: a sample shape or a photograph, and the picture of its force field.
class LabScene final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(int current READ current NOTIFY changed) ///< index into `names`
    Q_PROPERTY(QStringList names READ names NOTIFY changed)
    Q_PROPERTY(double surfaceWidth READ surfaceWidth CONSTANT)   ///< mm
    Q_PROPERTY(double surfaceHeight READ surfaceHeight CONSTANT) ///< mm
    /// The force field over the surface with its legend below, at the scale of setFieldScale.
    Q_PROPERTY(QImage field READ field NOTIFY fieldChanged)
    Q_PROPERTY(int legendPixels READ legendPixels CONSTANT)
    Q_PROPERTY(QString fieldWords READ fieldWords NOTIFY changed)
public:
    /// All must outlive it.
    LabScene(const SurfaceSize& surface, const LabTuning& tuning, LabActivity& activity,
             const Preferences& preferences, LabTeller& teller);
    ~LabScene() override;

    int current() const { return current_; }
    QStringList names() const;
    double surfaceWidth() const { return size_.width_mm; }
    double surfaceHeight() const { return size_.height_mm; }
    QImage field() const { return field_.image(); }
    int legendPixels() const { return LabField::legend_pixels; }
    QString fieldWords() const;

    /// Whole, its middle at 0, y up; mm.
    Rect surface() const;
    const SurfaceSize& size() const { return size_; }
    const QString& name() const { return name_; }
    const FlatScene& flat() const { return flat_; }
    /// The same as the servo renders, for the page's own questions.
    const HapticScene& felt() const { return *felt_; }
    /// One for the servo.
    std::unique_ptr<HapticScene> for_servo() const;

    Q_INVOKABLE void choose(int index);
    Q_INVOKABLE void openPhoto(const QUrl& file);
    /// Pixels a millimetre at which the field is drawn.
    Q_INVOKABLE void setFieldScale(double pixels_per_mm) { field_.set_scale(pixels_per_mm); }
    /// A photograph that is being read is not wanted any more; false where none is.
    bool cancel();

signals:
    void changed();
    void fieldChanged();
    /// Another scene is felt, or the same under another law.
    void rendered();

private:
    void use(int index, const QString& name, FlatScene flat);
    void use_photo(const QString& file);
    void render();

    SurfaceSize size_;
    const LabTuning& tuning_;
    LabActivity& activity_;
    const Preferences& preferences_;
    LabTeller& teller_;
    int current_ = 0;
    QString name_;
    FlatScene flat_;
    std::shared_ptr<const HapticScene> felt_;
    QString photo_; ///< file; empty: none was opened
    LabField field_;
    std::shared_ptr<std::unique_ptr<FaceExtractor>> extractor_; ///< what is in it belongs to work_'s thread
    LatestTask work_;                                           ///< last: it ends first
};

} // namespace tp
