// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_album.hpp"
#include "app/pages/capture/capture_choices.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "audio/sound/moment_recorder.hpp"

#include <QDateTime>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <map>

namespace tp {

/// The sound round a photograph, where the person chose that it is kept: the microphone is on while the camera is, which is
/// told and shown; what no shutter asked for is forgotten.
class CaptureMoment final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool hears READ hears NOTIFY changed) ///< the microphone is on
public:
    /// All must outlive it.
    CaptureMoment(CaptureAlbum& album, CaptureChoices& choices, MomentRecorder& recorder,
                  CaptureTeller& teller);

    bool hears() const { return recorder_.hears(); }
    /// Sound that belongs to a photograph is not over, or not listed among its recordings.
    bool keeping() const { return !kept_.empty(); }

    /// The camera is on, or off; so is the microphone, where it is wanted.
    void begin();
    void end();
    /// The shutter acts; `keep` or `drop` follows.
    void shutter();
    /// The photograph lies there.
    void keep(const std::filesystem::path& photo);
    void drop();

signals:
    void changed();
    /// Something about this photograph was changed on the disk.
    void touched(const std::filesystem::path& photo);

private:
    void follow_choice();
    void list(quint64 number, const FinishedRecording& recording);

    CaptureAlbum& album_;
    CaptureChoices& choices_;
    MomentRecorder& recorder_;
    CaptureTeller& teller_;
    bool begun_ = false;
    bool listens_ = false;
    quint64 number_ = 0; ///< of the photograph that is being taken; 0: nothing of it is heard
    QDateTime acted_;    ///< its shutter
    std::map<quint64, std::filesystem::path> kept_; ///< whose sound is not over yet
};

} // namespace tp
