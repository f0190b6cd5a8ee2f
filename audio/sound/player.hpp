// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/playback_order.hpp"
#include "audio/sound/playback_stream.hpp"
#include "audio/sound/sound_output.hpp"
#include "audio/sound/stream_filler.hpp"

#include <QObject>
#include <QString>

#include <cstddef>
#include <memory>
#include <vector>

namespace tp {

/// Plays a list of recordings, one after the other with a short silence between. Lives on the page's thread
/// and never blocks it. Where it is, is always where the listener is: what was decoded and not heard does not
/// count.
///
/// A loudspeaker that goes away is waited for, and the recording goes on from what was heard last. A
/// recording that cannot be read costs a sentence; the next one plays.
class Player final : public QObject {
    Q_OBJECT
public:
    enum class State {
        stopped,
        playing, ///< also in the silence before a recording
        paused,
        waiting, ///< for a loudspeaker; it then goes on by itself
    };
    Q_ENUM(State)

    /// Both must outlive the player, which has them to itself.
    Player(SoundOutput& output, StreamFiller& filler, QObject* parent = nullptr);

    /// Stops. They are played as they come here; see playback_order().
    void set_list(std::vector<PlayItem> list);
    const std::vector<PlayItem>& list() const { return list_; }

    State state() const { return state_; }
    std::size_t current() const { return current_; } ///< index in the list
    double position_s() const;                       ///< in the current recording, at speed 1
    double duration_s() const;                       ///< of the current recording; 0 before it was opened
    /// A recording is to be heard now: nothing should be said. (Not in the silence before one.)
    bool sounding() const { return state_ == State::playing && begun_; }
    double speed() const { return speed_; }

    /// Goes on where it was left.
    void play();
    /// Plays one of the list, from where it was left.
    void play_at(std::size_t index);
    void pause();
    /// Silence; `play` goes on from here.
    void stop();
    void next();
    /// To the beginning of this one; in its first seconds to the one before.
    void previous();
    /// 0.5–2, at once; the pitch is kept.
    void set_speed(double speed);

signals:
    void state_changed();
    void sounding_changed(bool sounding);
    void position_changed();
    void began(std::size_t index);
    void ended(std::size_t index);
    /// The silence before recording `next` has begun. Who wants to say something in it pauses and then plays.
    void gap(std::size_t next);
    /// There is nothing further: the last one has ended, or was asked to be passed.
    void list_end();
    /// Where a recording was left, to be handed in as PlayItem::resume_at_s another time; 0 when it was
    /// heard to its end.
    void left(std::size_t index, double position_s);
    /// A whole sentence for the listener.
    void said(const QString& sentence);

private:
    void begin(std::size_t index, double position_s, double silence_s);
    void end_current();
    void fall_silent();
    void leave_current();
    void become(State state, bool begun);
    void ready(quint64 run);
    void progress(quint64 run);
    void unreadable(quint64 run, const QString& sentence);
    void gone(quint64 run);
    void moved(quint64 run);
    void came();

    SoundOutput& output_;
    StreamFiller& filler_;
    std::vector<PlayItem> list_;
    State state_ = State::stopped;
    bool begun_ = false; ///< of the current recording something was heard since `begin`
    std::size_t current_ = 0;
    double speed_ = 1.0;
    quint64 run_ = 0; ///< of the stream that is played; older ones are no longer listened to
    std::shared_ptr<PlaybackStream> stream_; ///< null unless playing
    bool ready_ = false;                     ///< stream_ is open
    double position_s_ = 0.0;                ///< where stream_ began; without a stream, where it was left
    double silence_s_ = 0.0;                 ///< before stream_
    double duration_s_ = 0.0;
    bool told_ = false; ///< that there is no loudspeaker, since something was heard
};

} // namespace tp
