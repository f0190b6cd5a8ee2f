// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_scene.hpp"

#include "app/pages/lab/lab_photo.hpp"
#include "app/pages/lab/sample_scenes.hpp"
#include "audio/sentences/sentences.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QFileInfo>
#include <QLocale>

#include <stop_token>
#include <utility>

namespace tp {

namespace {

constexpr int photo_scene = 3;

} // namespace

LabScene::LabScene(const SurfaceSize& surface, const LabTuning& tuning, LabActivity& activity,
                   const Preferences& preferences, LabTeller& teller)
    : size_(surface), tuning_(tuning), activity_(activity), preferences_(preferences), teller_(teller),
      field_(this->surface(), [this] { emit fieldChanged(); }),
      extractor_(std::make_shared<std::unique_ptr<FaceExtractor>>()) {
    connect(&tuning, &LabTuning::sceneTurned, this, &LabScene::render);
    connect(&tuning, &LabTuning::changed, this, &LabScene::changed); // `fieldWords` says the greatest force
    use(0, names()[0], flatten(sample_scene(LabShape::circle, surfaceWidth(), surfaceHeight())));
}

LabScene::~LabScene() = default;

Rect LabScene::surface() const {
    const Vec2 half(0.5 * surfaceWidth(), 0.5 * surfaceHeight());
    return {-half, half};
}

QStringList LabScene::names() const {
    const QString photo =
        photo_.isEmpty() ? tr("Photograph") : tr("Photograph %1").arg(QFileInfo(photo_).fileName());
    return {tr("Circle, radius 40 mm"), tr("Triangle, 50 mm high"), tr("Curved path, 200 mm wide"), photo};
}

QString LabScene::fieldWords() const {
    const LabParameters& parameters = tuning_.parameters();
    return tr("Force field of %1: colours and arrows from 0 to %2 newtons. The scale bar is 20 mm long.")
        .arg(name_, QLocale().toString(parameters.stiffness * parameters.range, 'f', 2));
}

std::unique_ptr<HapticScene> LabScene::for_servo() const {
    return felt_scene(flat_, tuning_.parameters()).value();
}

void LabScene::use(int index, const QString& name, FlatScene flat) {
    current_ = index;
    name_ = name;
    flat_ = std::move(flat);
    render();
    emit changed();
}

void LabScene::render() {
    Result<std::unique_ptr<HapticScene>> made = felt_scene(flat_, tuning_.parameters());
    if (!made)
        return teller_.say(in_persons_language(made.error()));
    felt_ = std::move(made).value();
    field_.show(felt_);
    emit rendered();
}

void LabScene::choose(int index) {
    if (index < 0 || index >= names().size() || activity_.refuses_change())
        return;
    work_.cancel();
    if (index == photo_scene)
        return use_photo(photo_.isEmpty() ? preferences_.choices().last_photo : photo_);
    use(index, names()[index],
        flatten(sample_scene(static_cast<LabShape>(index), surfaceWidth(), surfaceHeight())));
    teller_.tell(names()[index] + '.');
}

void LabScene::openPhoto(const QUrl& file) {
    if (activity_.refuses_change())
        return;
    if (file.isLocalFile())
        use_photo(file.toLocalFile());
    else
        teller_.say(tr("Only a photograph that is a file on this computer can be opened."));
}

void LabScene::use_photo(const QString& file) {
    if (file.isEmpty())
        return teller_.say(tr("There is no photograph yet. Open one, or drop one on the page."));
    const QString name = QFileInfo(file).fileName();
    teller_.say(tr("Looking for faces in %1.").arg(name));
    work_.ask([this, file, name, path = file.toStdString(), surface = size_,
               extractor = extractor_](const std::stop_token& stop) -> LatestTask::Answer {
        auto photo = std::make_shared<LabPhoto>(read_photo(path, surface, *extractor, stop));
        return [this, photo, file, name] {
            if (!photo->problem.empty())
                return teller_.say(tr("%1: %2").arg(name, in_persons_language(photo->problem)));
            if (activity_.refuses_change())
                return;
            photo_ = file;
            use(photo_scene, name, std::move(photo->flat));
            teller_.say(
                tr("%1: %n line(s) can be felt.", nullptr, static_cast<int>(flat_.lines.size())).arg(name));
        };
    });
}

bool LabScene::cancel() {
    const bool reading = work_.busy();
    work_.cancel();
    return reading;
}

} // namespace tp
