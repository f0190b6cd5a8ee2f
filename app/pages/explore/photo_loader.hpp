// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/work/latest_task.hpp"
#include "faces/base/face.hpp"

#include <QImage>
#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace tp {

class FaceExtractor;

/// A photograph and what was found on it.
struct LoadedPhoto {
    QString name;          ///< of the file, without its folder
    QImage image;          ///< upright, shrunk to what a screen can show; null where it could not be read
    Extraction extraction; ///< places in pixels of the whole picture; `problem` where it could not be read
    std::vector<QString> names =
        {};            ///< of the people, one for each face, as the photograph's metadata and its sidecar
                       ///< say; empty where nobody said
    QString file = {}; ///< as it was asked for; empty: it is none
};

/// Reads photographs and finds their faces on a thread of its own.
class PhotoLoader final : public QObject {
    Q_OBJECT
public:
    PhotoLoader();
    ~PhotoLoader() override;

    /// `loaded` follows, unless a newer load() comes first: then only that one is answered.
    void load(const QString& file);
    /// The photograph that was asked for is not wanted any more: nothing is answered.
    void cancel() { work_.cancel(); }

signals:
    void loaded(std::shared_ptr<const tp::LoadedPhoto> photo);

private:
    std::unique_ptr<FaceExtractor> extractor_; ///< only the work's thread
    LatestTask work_;                          ///< last: it ends first
};

} // namespace tp
