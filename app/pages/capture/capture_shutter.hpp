// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/shutter/burst.hpp"
#include "app/capture/shutter/taken_look.hpp"
#include "app/pages/capture/capture_album.hpp"
#include "app/pages/capture/capture_teller.hpp"

#include <QImage>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tp {

/// The shutter: of the frames round it the best is kept and told; the others can be looked through and kept too, until the
/// page is left or the next photograph is taken.
class CaptureShutter final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool taking READ taking NOTIFY changed)  ///< from the shutter until it is on the disk
    Q_PROPERTY(QString taken READ taken NOTIFY changed) ///< what the last one shows; empty: none was taken
    Q_PROPERTY(int count READ count NOTIFY changed)     ///< frames of the last burst
    Q_PROPERTY(int shown READ shown NOTIFY changed)     ///< which of them is looked at, from 0 on; −1: none
    Q_PROPERTY(QVariant picture READ picture NOTIFY changed) ///< a QImage: that frame
    Q_PROPERTY(bool canUndo READ can_undo NOTIFY changed)
public:
    /// What is known when the shutter acts.
    struct Moment {
        std::vector<CameraFrame> frames; ///< the last ones, the oldest first
        HeldCamera held;
        std::string device; ///< what the camera is called
    };

    /// `people`: who may be known. The others must outlive it.
    CaptureShutter(CaptureAlbum& album, std::shared_ptr<const KnownPeople> people, CaptureTeller& teller);

    bool taking() const { return taking_; }
    const QString& taken() const { return taken_; }
    int count() const { return static_cast<int>(order_.size()); }
    int shown() const { return shown_; }
    QVariant picture() const { return picture_; }
    bool can_undo() const { return album_.steps() > 0; }
    /// The photograph that was kept last; empty: none, or it was deleted again.
    const std::filesystem::path& photo() const { return photo_; }

    void take(Moment moment);
    /// The next or the one before of the burst, the best first.
    Q_INVOKABLE void look(int step);
    /// Keeps the one that is looked at, beside the first.
    Q_INVOKABLE void keepShown();
    /// Nothing is looked at any more. False: nothing was.
    bool look_away();
    /// Takes back what was done last: the photograph is deleted again.
    Q_INVOKABLE void undo();
    /// The burst is forgotten.
    void forget();

signals:
    void changed();
    /// The photograph that the shutter acted for is on the disk; or it could not be kept.
    void kept(const std::filesystem::path& photo);
    void not_kept();
    /// Something about this photograph was changed on the disk.
    void touched(const std::filesystem::path& photo);

private:
    struct Nets;
    struct Work;
    void finish(const std::shared_ptr<Work>& work, const QString& problem);
    void pack();
    void describe(std::size_t frame);

    CaptureAlbum& album_;
    CaptureTeller& teller_;
    std::shared_ptr<Nets> nets_; ///< of the album's thread alone
    bool taking_ = false;
    QString taken_;
    std::filesystem::path photo_;
    std::shared_ptr<const Burst> burst_;
    std::string device_;
    std::vector<std::size_t> order_; ///< frames of the burst, the best first
    int shown_ = -1;
    QImage picture_;
    quint64 run_ = 0; ///< answers about another burst are not heard
    QThreadPool packing_; ///< last: it ends before what its work is for
};

} // namespace tp
