// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/name_languages.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "app/pages/care/keeper_steps.hpp"

#include <QObject>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tp {

/// A photograph and whose album it is in.
struct PhotoPlace {
    std::filesystem::path photo;
    AlbumKeeper* keeper = nullptr;
};

/// The photograph that is cared for now and what is known of it, kept true with every step on it.
class CaredPhoto final : public QObject {
    Q_OBJECT
public:
    /// As KeeperSteps::Step, with the photograph that it is about.
    using PhotoStep = std::function<std::string(AlbumKeeper&, const std::filesystem::path& photo)>;

    /// The steps must outlive it.
    explicit CaredPhoto(KeeperSteps& steps, QObject* parent = nullptr) : QObject(parent), steps_(steps) {}

    /// `opened` follows, and `changed` when its record was read.
    void open(const PhotoPlace& place);
    void close() { open({}); }

    bool is_open() const { return place_.keeper != nullptr; }
    const PhotoPlace& place() const { return place_; }
    /// A step is being taken back or done again, after which it may lie elsewhere.
    bool may_move() const { return steps_.steps_back(); }
    /// As read last, where it can be; empty until it was read for the first time.
    const PhotoRecord& record() const { return record_; }
    /// The languages of names in its album, read together with the record.
    const std::vector<NameLanguage>& name_languages() const { return name_languages_; }

    /// A step on a photograph, this one or one that was open when the step was begun; then the record is read anew and
    /// `touched` is told, whether the step was done or not.
    void change(const PhotoPlace& place, PhotoStep step, KeeperSteps::Then then);
    /// The record is read again, for somebody else has changed it.
    void read_again();

signals:
    /// Another photograph, or none.
    void opened();
    /// What is known of it may have changed.
    void changed();
    /// The languages of names in this album were read, before `changed` is told and before the answer to a step.
    void name_languages_read(const std::filesystem::path& album, const std::vector<tp::NameLanguage>& names);
    /// Its record is there and cannot be read now: why, in the person's language.
    void unread(const QString& why);
    /// A step on this photograph ended.
    void touched(const std::filesystem::path& photo);

private:
    void go(const PhotoPlace& place, PhotoStep step, KeeperSteps::Then then);

    KeeperSteps& steps_;
    PhotoPlace place_;
    PhotoRecord record_;
    std::vector<NameLanguage> name_languages_;
};

} // namespace tp
