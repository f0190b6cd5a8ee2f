// SPDX-License-Identifier: Apache-2.0
#include "app/shell/voice_names.hpp"

#include "audio/sentences/sentences.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaObject>

#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

struct FoundNames {
    std::map<fs::path, std::vector<NameLanguage>> albums;
    std::vector<std::string> problems;
};

FoundNames names_of(const std::vector<fs::path>& folders) {
    FoundNames found;
    for (const fs::path& folder : folders) {
        std::error_code error;
        const fs::path real = fs::canonical(folder, error);
        if (error)
            continue; // not there now
        AlbumKeeper keeper(real);
        found.albums[real] = NameLanguages(keeper).all(&found.problems);
    }
    return found;
}

} // namespace

VoiceNames::VoiceNames(Voice& voice, Preferences& preferences) : voice_(voice), preferences_(preferences) {
    pool_.setMaxThreadCount(1);
    connect(&preferences_, &Preferences::changed, this, &VoiceNames::follow_preferences);
    follow_preferences();
}

VoiceNames::~VoiceNames() { pool_.waitForDone(); }

void VoiceNames::follow_preferences() {
    if (preferences_.choices().folders == chosen_)
        return;
    chosen_ = preferences_.choices().folders;
    albums_.clear();
    told_.clear();
    read();
}

void VoiceNames::read() {
    again_ = std::exchange(reading_, true);
    if (again_)
        return;
    std::vector<fs::path> folders;
    for (const QString& folder : chosen_)
        folders.emplace_back(folder.toStdString());
    pool_.start([this, folders = std::move(folders)] {
        QMetaObject::invokeMethod(
            this,
            [this, found = names_of(folders)] {
                reading_ = false;
                if (again_) // what was read may be older than what was heard of meanwhile
                    return read();
                for (const auto& [album, names] : found.albums)
                    albums_[album] = names;
                tell();
                for (const std::string& problem : found.problems)
                    if (told_.insert(problem).second)
                        emit said(in_persons_language(problem));
            },
            Qt::QueuedConnection);
    });
}

void VoiceNames::settle(int most_ms) {
    if (pool_.waitForDone(most_ms))
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
}

void VoiceNames::know(const fs::path& album, const std::vector<NameLanguage>& names) {
    albums_[album] = names;
    again_ = reading_;
    tell();
}

void VoiceNames::tell() {
    SpokenNames names;
    std::set<std::string> known;
    for (const auto& [album, people] : albums_)
        for (const NameLanguage& name : people)
            if (known.insert(name.person).second)
                names.push_back({QString::fromStdString(name.person), QString::fromStdString(name.language)});
    voice_.set_name_languages(names);
}

} // namespace tp
