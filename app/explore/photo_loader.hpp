// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/face.hpp"

#include <QImage>
#include <QObject>
#include <QString>
#include <QThread>

#include <atomic>
#include <memory>
#include <stop_token>
#include <vector>

namespace tp {

class FaceExtractor;

/// A photograph and what was found on it.
struct LoadedPhoto {
    QString name;          ///< of the file, without its folder
    QImage image;          ///< upright, shrunk to what a screen can show; null where it could not be read
    Extraction extraction; ///< places in pixels of the whole picture; `problem` where it could not be read
    std::vector<QString> names = {}; ///< of the people, one for each face, as the photograph's metadata and its sidecar
                                     ///< say; empty where nobody said
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
    void cancel();

signals:
    void loaded(std::shared_ptr<const tp::LoadedPhoto> photo);

private:
    void work(quint64 request, const QString& file, const std::stop_token& stop);

    QThread thread_;
    QObject* worker_; ///< the place on thread_ where work is done; thread_ deletes it
    std::atomic<quint64> newest_{0};
    std::stop_source stop_;                    ///< of the newest request
    std::unique_ptr<FaceExtractor> extractor_; ///< only thread_
};

} // namespace tp
