// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/browse_session.hpp"
#include "app/parts/controls/notification_announcer.hpp"
#include "audio/sound/earcons.hpp"
#include "audio/speech/recording_voice.hpp"
#include "drawn_album.hpp"
#include "fake_loudspeaker.hpp"
#include "inline_filler.hpp"

#include <QLocale>
#include <QString>
#include <QTest>

#include <cmath>
#include <memory>
#include <optional>

namespace tp::testing {

inline const QString garden_words = "Anna and Tom, May 2026, Vienna; 2 recording(s).";

/// A drawn album, with a voice and loudspeakers that a test hears.
struct BrowseSounds {
    DrawnAlbum drawn;
    RecordingVoice voice;
    NotificationAnnouncer announcer;
    Narrator narrator{voice, announcer};
    FakeLoudspeaker loudspeaker, earcon_loudspeaker;
    InlineFiller filler;
    Player player{loudspeaker, filler};
    EarconPlayer earcons{earcon_loudspeaker};

    BrowseSounds() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom)); }

    /// What was said last.
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    /// The earcon that was played since this was asked last; none: none, or several at once.
    std::optional<Earcon> earcon() {
        earcon_loudspeaker.heard.clear();
        earcon_loudspeaker.play(0.4);
        const std::vector<float>& heard = earcon_loudspeaker.heard;
        for (const Earcon one : every_earcon) {
            const auto samples = samples_of(one);
            bool same = samples.size() <= heard.size();
            for (std::size_t i = 0; same && i < heard.size(); ++i)
                same = std::abs(heard[i] - (i < samples.size() ? samples[i] : 0.0F)) < 1e-4F;
            if (same)
                return one;
        }
        return std::nullopt;
    }
    /// The strongest tone in the last so many seconds of what was heard of recordings, Hz by its zero
    /// crossings; 0: silence.
    double tone(double seconds) {
        const std::vector<float>& heard = loudspeaker.heard;
        const auto count = std::min(heard.size(), static_cast<std::size_t>(seconds * sound_rate));
        int crossings = 0;
        for (std::size_t i = heard.size() - count + 1; i < heard.size(); ++i)
            crossings += (heard[i - 1] < 0.0F) != (heard[i] < 0.0F) ? 1 : 0;
        return 0.5 * crossings / seconds;
    }
};

/// The browse page's session over it.
struct BrowseBench : BrowseSounds {
    std::unique_ptr<BrowseSession> session;

    /// As at a start of the program, with the page shown.
    void start() {
        drawn.open();
        session = std::make_unique<BrowseSession>(*drawn.album, narrator, earcons, player, drawn.preferences);
        session->enter();
    }
    void go_to(const std::filesystem::path& photo) {
        if (!session->trail()->show(QString::fromStdString(photo.string())))
            qFatal("no photograph %s", photo.c_str());
        voice.clear();
        earcon();
    }
};

} // namespace tp::testing
