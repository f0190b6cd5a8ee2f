// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_album.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "audio/sound/recorder_take.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

/// A memo spoken for the photograph that was just taken. Whatever happens to the page meanwhile, what was recorded stays with
/// the photograph. Its states are a take's (RecorderTake).
class CaptureMemo final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool running READ running NOTIFY changed) ///< from the wish to record until it is kept
public:
    /// All must outlive it.
    CaptureMemo(CaptureAlbum& album, Recorder& recorder, CaptureTeller& teller);

    bool running() const { return take_.running(); }

    /// `language` of what is spoken, BCP 47.
    void start(const std::filesystem::path& photo, const QString& language);
    /// Ends it and keeps it, in its own time. False: none was running, or it was asked for before.
    bool finish() { return take_.finish(); }

signals:
    void changed();
    /// Something about this photograph was changed on the disk.
    void touched(const std::filesystem::path& photo);

private:
    void keep(const FinishedRecording& recording);

    CaptureAlbum& album_;
    CaptureTeller& teller_;
    RecorderTake take_;
    std::filesystem::path photo_;
};

} // namespace tp
