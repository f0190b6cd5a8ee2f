// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/recording_list.hpp"
#include "audio/sound/recorder_take.hpp"

#include <QtQml/qqmlregistration.h>

#include <functional>
#include <string>

namespace tp {

/// A recording being made for the photograph, anew or in place of another: begun, paused, finished, or thrown away after
/// asking. Whatever happens to the page meanwhile, what was recorded stays with the photograph that it was begun for. What the
/// recorder does for it is a RecorderTake's.
///
/// |         | start, startAgain | askDiscard | keepOn  | discard | kept, failed |
/// |---------|-------------------|------------|---------|---------|--------------|
/// | None    | Running           |            |         |         |              |
/// | Running |                   | Asking     |         |         | None         |
/// | Asking  |                   |            | Running | None    | None         |
class Take final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// Index in RecordingList::kinds of what the next one will be.
    Q_PROPERTY(int kind READ kind WRITE setKind NOTIFY changed)
    Q_PROPERTY(bool running READ running NOTIFY changed) ///< from the wish to record until it is kept or gone
    Q_PROPERTY(bool paused READ paused NOTIFY changed)
    Q_PROPERTY(bool asking READ asking NOTIFY changed) ///< whether it may be thrown away
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed)
    Q_PROPERTY(QString time READ time NOTIFY timeChanged)
    Q_PROPERTY(double level READ level NOTIFY levelChanged) ///< 0–1 for a meter, −60 to 0 dBFS
    Q_PROPERTY(QString levelText READ levelText NOTIFY levelChanged)
public:
    enum class State {
        None,    ///< nothing is recorded
        Running, ///< it is recorded, paused or made into a file
        Asking   ///< it is paused, and asked whether it may be thrown away
    };

    /// All must outlive it. `language` of what is spoken, BCP 47.
    Take(CaredPhoto& photo, RecordingList& list, Recorder& recorder, CareTeller& teller,
         std::function<QString()> language);

    int kind() const { return kind_; }
    void setKind(int kind);
    State state() const { return state_; }
    bool running() const { return state_ != State::None; }
    bool paused() const { return running() && recorder_.state() == RecorderState::paused; }
    bool asking() const { return state_ == State::Asking; }
    QString stateText() const;
    QString time() const;
    double level() const;
    QString levelText() const;

    Q_INVOKABLE void start();
    /// Records the chosen recording anew; the old one goes to the trash when the new one is kept.
    Q_INVOKABLE void startAgain();
    Q_INVOKABLE void pauseOrGoOn();
    Q_INVOKABLE void finish();
    /// Pauses and asks; then discard() or keepOn().
    Q_INVOKABLE void askDiscard();
    Q_INVOKABLE void discard();
    Q_INVOKABLE void keepOn();

signals:
    void changed();
    void timeChanged();
    void levelChanged();
    /// The microphone listens from now on: everything else should be silent.
    void begins();

private:
    void begin(const RecordingLabel& label, const std::string& instead_of);
    void keep(const FinishedRecording& recording);
    void become(State state);

    CaredPhoto& photo_;
    RecordingList& list_;
    Recorder& recorder_;
    CareTeller& teller_;
    std::function<QString()> language_;
    RecorderTake take_;
    int kind_ = 0;
    State state_ = State::None;
    PhotoPlace place_;        ///< that it was begun for
    std::string instead_of_;  ///< file of the recording that it replaces; empty: none
};

} // namespace tp
