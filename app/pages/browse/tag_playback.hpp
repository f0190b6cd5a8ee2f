// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/player.hpp"

#include <QObject>
#include <QString>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace tp {

/// The recordings of one photograph being heard: all in order, with what comes next told between two, or one
/// alone. While one sounds the narrator is silent. Belongs to the page's thread.
class TagPlayback final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this, which has the player to itself.
    TagPlayback(Player& player, Narrator& narrator, Preferences& preferences, QObject* parent = nullptr);
    ~TagPlayback() override;

    /// The recordings of a photograph in the order in which they are played. Others than before: silence.
    void set_tags(const std::filesystem::path& photo, std::vector<Tag> tags);
    const std::vector<Tag>& tags() const { return tags_; }

    /// Plays, pauses, goes on: all of them, or only the one that is named. False where there is nothing to
    /// play.
    bool toggle(std::optional<std::size_t> only);
    void pause();
    /// Silence, and the next `toggle` begins anew; false where there was silence already.
    bool stop();

    bool playing() const; ///< also while it is told what comes
    bool paused() const { return player_.state() == Player::State::paused && !telling_; }
    /// Of the one that plays or is paused; none where nothing is.
    std::optional<std::size_t> current() const;
    double position_s() const { return player_.position_s(); }
    double duration_s() const;

signals:
    void changed();
    void progress();
    /// All that was to be played has been heard.
    void ended();

private:
    void start(std::optional<std::size_t> only);
    void tell_next(std::size_t next);
    void follow_speed();

    Player& player_;
    Narrator& narrator_;
    Preferences& preferences_;
    std::filesystem::path photo_;
    std::vector<Tag> tags_;
    std::map<std::filesystem::path, double> left_; ///< where recordings were left, seconds
    std::optional<std::size_t> only_;
    bool telling_ = false; ///< what comes next
};

} // namespace tp
