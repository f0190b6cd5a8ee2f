// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_album.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "audio/sound/recorder.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

/// A memo spoken for the photograph that was just taken. Whatever happens to the page meanwhile, what was recorded stays with
/// the photograph.
class CaptureMemo final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool running READ running NOTIFY changed) ///< from the wish to record until it is kept
public:
    /// All must outlive it.
    CaptureMemo(CaptureAlbum& album, Recorder& recorder, CaptureTeller& teller);

    bool running() const { return running_; }

    /// `language` of what is spoken, BCP 47.
    void start(const std::filesystem::path& photo, const QString& language);
    /// Ends it and keeps it, in its own time. False: none was running, or it was asked for before.
    bool finish();

signals:
    void changed();
    /// Something about this photograph was changed on the disk.
    void touched(const std::filesystem::path& photo);

private:
    void keep(const FinishedRecording& recording);
    void end();

    CaptureAlbum& album_;
    Recorder& recorder_;
    CaptureTeller& teller_;
    std::filesystem::path photo_;
    bool running_ = false;
    bool heard_ = false;     ///< something was recorded
    bool finishing_ = false; ///< the recorder was told to end
};

} // namespace tp
