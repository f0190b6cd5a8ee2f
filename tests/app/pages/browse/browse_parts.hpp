// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/browse_album.hpp"
#include "app/pages/browse/browse_details.hpp"
#include "app/pages/browse/browse_lists.hpp"
#include "app/pages/browse/browse_playback.hpp"
#include "app/pages/browse/browse_teller.hpp"
#include "app/pages/browse/browse_trail.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "browse_bench.hpp"

#include <QSize>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <QVariantMap>

#include <cmath>
#include <filesystem>
#include <optional>

namespace tp::testing {

/// The parts of a BrowseSession without it, over a drawn album.
struct BrowseParts : BrowseSounds {
    struct Parts {
        BrowseTeller teller;
        TagPlayback tags;
        BrowseAlbum album;
        BrowseTrail trail;
        BrowseDetails details;
        BrowsePlayback playback;
        BrowseLists lists;

        explicit Parts(BrowseParts& bench)
            : teller(bench.narrator, bench.earcons),
              tags(bench.player, bench.narrator, bench.drawn.preferences), album(*bench.drawn.album),
              trail(album, teller, tags, bench.drawn.preferences),
              details(album, trail, teller, tags, QSize(1920, 1200)),
              playback(trail, details, teller, tags, bench.player, bench.drawn.preferences),
              lists(album, trail, details, teller, tags) {
            trail.look_at_album();
        }
    };
    std::optional<Parts> parts;

    /// As at a start of the program, with the page shown and nothing told of it.
    void start() {
        drawn.open();
        parts.emplace(*this);
        parts->trail.enter();
        voice.clear();
    }
    BrowseAlbum& album() { return parts->album; }
    BrowseTrail& trail() { return parts->trail; }
    BrowseDetails& details() { return parts->details; }
    BrowsePlayback& playback() { return parts->playback; }
    BrowseLists& lists() { return parts->lists; }

    void go_to(const std::filesystem::path& photo) {
        if (!trail().show(QString::fromStdString(photo.string())))
            qFatal("no photograph %s", photo.c_str());
        voice.clear();
        earcon();
    }
    bool near(double tone_hz, double expected) const { return std::abs(tone_hz - expected) < 15.0; }
    QStringList row_texts() {
        QStringList texts;
        for (const QVariant& row : lists().rows())
            texts << row.toMap()["text"].toString();
        return texts;
    }
};

/// Five photographs, and one is at the garden.
struct PartsAtGarden : BrowseParts {
    DrawnAlbum::Five five = drawn.five();
    PartsAtGarden() {
        start();
        go_to(five.garden);
    }
};

} // namespace tp::testing
