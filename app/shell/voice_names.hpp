// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/name_languages.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/speech/voice.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tp {

/// Tells the voice in what language the people of the person's albums are named, for every page. Belongs to
/// the page's thread; the albums are read on one of its own, when it begins, when other folders are chosen,
/// and when asked to.
class VoiceNames final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive it.
    VoiceNames(Voice& voice, Preferences& preferences);
    /// Waits until a reading that has begun is over.
    ~VoiceNames() override;

    /// All albums are read again.
    void read();
    /// Waits until what is being read has been told, at most so long; for who speaks before any event was handled.
    void settle(int most_ms);
    /// All that is known of this album by now; the voice is told before this returns. Where two albums say
    /// different things of a name, the first in the order of their paths is heard.
    void know(const std::filesystem::path& album, const std::vector<NameLanguage>& names);

signals:
    /// A sentence about a file that cannot be read; each once.
    void said(const QString& sentence);

private:
    void follow_preferences();
    void tell();

    Voice& voice_;
    Preferences& preferences_;
    QStringList chosen_; ///< folders as the preferences have them
    std::map<std::filesystem::path, std::vector<NameLanguage>> albums_;
    std::set<std::string> told_;
    bool reading_ = false;
    bool again_ = false; ///< something changed since the reading began
    QThreadPool pool_;   ///< of one thread
};

} // namespace tp
