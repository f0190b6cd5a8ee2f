// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/reply.hpp"

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "app/album/metadata/read_record.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>

namespace tp {

namespace fs = std::filesystem;

namespace {

class TakenReply {
public:
    TakenReply(AlbumKeeper& keeper, const fs::path& photo) : keeper_(keeper), photo_(photo) {}

    Reply run(const fs::path& other, const std::vector<Companion>& beside_other) {
        take_recordings(tags_folder(other));
        for (const Companion& companion : beside_other)
            if (companion.suffix.ends_with(".xmp") && !conflict_original(companion.file.filename().string()))
                take_words(companion.file);
        list_the_rest();
        return std::move(reply_);
    }

private:
    void tell(const std::string& sentence) {
        if (!sentence.empty())
            reply_.told.push_back(sentence);
    }

    void take_recordings(const fs::path& from) {
        const fs::path to = tags_folder(photo_);
        int error = 0;
        const std::vector<FolderEntry> entries = entries_of(from, &error);
        if (error != 0 && error != ENOENT)
            tell("The recordings of " + quoted(photo_.filename()) +
                 " were not imported: " + reason_of(error));
        for (const FolderEntry& entry : entries) {
            if (entry.link || entry.facts.kind != FileFacts::Kind::file || is_temporary(entry.name) ||
                !std::string_view(entry.name).ends_with(".flac"))
                continue;
            if (name_taken(to / entry.name)) {
                const auto here = content_hash(to / entry.name), there = content_hash(from / entry.name);
                if (here && there && *here != *there)
                    tell("The recording " + quoted(fs::path(entry.name)) + " of " +
                         quoted(photo_.filename()) + " is another one in the album; that one stays.");
                continue;
            }
            if (keeper_.is_in_trash(photo_, entry.name))
                continue;
            std::string reason = make_folder(to, Readers::owner_only);
            if (reason.empty())
                reason = copy_whole(from / entry.name, to / entry.name, Readers::owner_only);
            if (reason.empty())
                reply_.recordings.push_back(entry.name);
            else
                tell("The recording " + quoted(fs::path(entry.name)) + " of " + quoted(photo_.filename()) +
                     " was not imported: " + reason);
        }
    }

    /// Of its list of recordings those that are there.
    void take_words(const fs::path& sidecar) {
        const auto merge = merge_sidecar(photo_, sidecar, false, [this](const Tag& tag) {
            return name_taken(tags_folder(photo_) / tag.file);
        });
        if (!merge)
            return tell(merge.error());
        reply_.words = reply_.words || merge->changed;
        for (const std::string& sentence : merge->told)
            tell(sentence);
    }

    /// Recordings of which no sidecar speaks say themselves what they are.
    void list_the_rest() {
        const auto record = read_record(photo_);
        for (const std::string& file : reply_.recordings) {
            const auto listed = [&](const Tag& tag) { return tag.file == file; };
            if (!record || std::ranges::none_of(record->tags, listed))
                tell(keeper_.list_recording(photo_, file).error());
        }
    }

    AlbumKeeper& keeper_;
    const fs::path& photo_;
    Reply reply_;
};

} // namespace

Reply take_reply(AlbumKeeper& keeper, const fs::path& photo, const fs::path& other,
                 const std::vector<Companion>& beside_other) {
    return TakenReply(keeper, photo).run(other, beside_other);
}

} // namespace tp
