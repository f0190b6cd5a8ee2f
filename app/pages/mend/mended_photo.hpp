// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_file.hpp"
#include "app/pages/mend/mend_photo.hpp"
#include "app/pages/mend/mend_work.hpp"

#include <QImage>
#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <string>

namespace tp {

/// The photograph whose contours are mended, one for all parts of the page, and what can be done with it. Who looks away while
/// another one is read has again what there was to work on.
///
/// |         | look    | show: usable | show: not usable | look_away                    |
/// |---------|---------|--------------|------------------|------------------------------|
/// | Empty   | Looking | Ready        | Problem          |                              |
/// | Looking |         | Ready        | Problem          | Ready; Empty: there was none |
/// | Ready   | Looking |              | Problem          |                              |
/// | Problem | Looking | Ready        |                  |                              |
class MendedPhoto : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(State state READ state NOTIFY stateChanged)
    Q_PROPERTY(QString name READ name NOTIFY stateChanged) ///< without its folder; empty: there is none
public:
    enum class State {
        Empty,   ///< no photograph yet
        Looking, ///< one is being read
        Ready,   ///< its contours can be mended
        Problem  ///< they cannot; `problem` says why
    };
    Q_ENUM(State)

    State state() const { return state_; }
    bool ready() const { return state_ == State::Ready; }
    QString name() const;
    const QImage& picture() const { return photo_.image; }
    /// As read_for_mending says it.
    const std::string& problem() const { return photo_.problem; }
    /// There is something to work on, even while another photograph is being read.
    bool usable() const { return photo_.usable; }
    const MendWork& work() const { return photo_.work; }
    MendFile& file() { return photo_.contours; }

    /// Another one is being read.
    void look();
    /// That is not wanted any more.
    void look_away();
    void show(MendPhoto photo);
    /// Does something to the contours. A step that a person can take back goes through MendHistory.
    void change(const std::function<void(MendWork&)>& change);

signals:
    void stateChanged();
    /// Another photograph is here; `changed` follows.
    void replaced();
    /// The contours are others.
    void changed();

private:
    void become(State state);

    State state_ = State::Empty;
    MendPhoto photo_;
};

} // namespace tp
