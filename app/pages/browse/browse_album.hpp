// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What the browse page shows of the album as a whole: whether there is a photograph, and how far its scan
/// is.
///
/// | a photograph is known | folders are chosen | a scan goes on | state     |
/// |-----------------------|--------------------|----------------|-----------|
/// | yes                   |                    |                | Ready     |
/// | no                    | no                 |                | NoFolders |
/// | no                    | yes                | yes            | Looking   |
/// | no                    | yes                | no             | Empty     |
class BrowseAlbum final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(State state READ state NOTIFY stateChanged)
    /// What is to be done where there is no photograph.
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY stateChanged)
    Q_PROPERTY(bool scanning READ scanning NOTIFY scanChanged)
    Q_PROPERTY(QString scanText READ scanText NOTIFY scanChanged)
    /// 0 … 1; below 0: nobody knows.
    Q_PROPERTY(double scanValue READ scanValue NOTIFY scanChanged)
public:
    enum class State {
        NoFolders, ///< a person has chosen no folder yet
        Looking,   ///< none was found yet, and the scan goes on
        Empty,     ///< there is no photograph in the folders
        Ready
    };
    Q_ENUM(State)

    /// `album` must outlive this.
    explicit BrowseAlbum(OpenAlbum& album);

    State state() const { return state_; }
    bool ready() const { return state_ == State::Ready; }
    QString emptyText() const;
    bool scanning() const { return album_.scanning(); }
    QString scanText() const;
    double scanValue() const;

    OpenAlbum& open() { return album_; }
    /// `has_photo`: one is shown. Whether the state is another now.
    bool look(bool has_photo);

signals:
    void stateChanged();
    void scanChanged();

private:
    OpenAlbum& album_;
    State state_ = State::Looking;
};

} // namespace tp
