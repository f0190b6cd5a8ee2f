// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/import_sources.hpp"
#include "app/album/keeper/reply.hpp"
#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

struct ImportProgress {
    std::size_t done = 0, total = 0; ///< photographs
    std::uintmax_t bytes_done = 0, bytes_total = 0;
    std::filesystem::path current;      ///< empty at the end
    std::optional<double> seconds_left; ///< by the speed so far; none in the first second
};

/// Where a camera put the sound of a photograph.
enum class SoundOrigin {
    sound_file,   ///< IMG_1.WAV beside IMG_1.JPG
    motion_photo, ///< a video inside the photograph's own file
    live_photo,   ///< IMG_1.MOV beside IMG_1.HEIC
};

/// "sound_file", …: as in JSON.
std::string_view name_of(SoundOrigin source);

/// The ambient recording that a camera's sound became.
struct TakenSound {
    std::string recording; ///< its file name among the photograph's recordings
    SoundOrigin source = SoundOrigin::sound_file;
};

/// What became of one photograph that was to be imported.
struct ImportedPhoto {
    enum class Fate {
        imported,
        duplicate, ///< the album holds these bytes already, in `place`, which `reply` was brought to
        failed,    ///< `problem` says why; the rest was imported all the same
    };
    std::filesystem::path source;
    std::filesystem::path place;
    Fate fate = Fate::imported;
    std::string problem; ///< where imported: what did not come along
    std::optional<TakenSound> sound = {};
    Reply reply = {};
};

struct ImportReport {
    std::string id; ///< under which an import that was stopped goes on
    std::vector<ImportedPhoto> photos;
    bool stopped = false;
    std::size_t count(ImportedPhoto::Fate fate) const;
    /// How many were in the album already and got something new.
    std::size_t count_replies() const;
};

/// What an import is given; all but `known` may be empty.
struct ImportTools {
    /// Where the album already has a photograph of this SHA-256, if it does.
    std::function<std::optional<std::filesystem::path>(const std::string& hash)> known;
    std::function<void(const ImportProgress&)> progress; ///< before each photograph, and at the end
    std::function<void(const ImportedPhoto&)> done;      ///< after each
    std::stop_token stop;
    Unpacking unpacking = {}; ///< before the first photograph
};

// Copies photographs with all that is theirs into a folder of an album: from folders, whose own folders are
// kept, a camera's card, single files, .touchphoto bundles or ZIP files. A sound of the photograph's name
// (IMG_1.WAV) becomes its ambient recording, and so does the sound of a motion photo's or a Live Photo's
// video. To a photograph that the album holds already, what the other copy has beside it is brought: a reply is merged.
//
// What is to be imported is on the disk before the first byte is copied, so that an import that was stopped, killed or cut off goes
// on where it was. Links are left alone, in the sources too. A photograph is copied after its companions: where it is, everything of
// it is. The sources are only read.

/// `into` is a folder relative to the album's; empty: the album's own. An error only where nothing could be
/// begun.
Result<ImportReport> import_photos(const std::filesystem::path& album, const std::filesystem::path& into,
                                   const std::vector<std::filesystem::path>& sources,
                                   const ImportTools& tools);

/// Goes on with an import that was not finished.
Result<ImportReport> go_on_importing(const std::filesystem::path& album, const std::string& id,
                                     const ImportTools& tools);

/// Where an import that was not finished takes photographs from, and the folder of the album that they go to: to be told before it
/// goes on.
struct UnfinishedImport {
    std::vector<std::filesystem::path> sources;
    std::filesystem::path into; ///< absolute
};
Result<UnfinishedImport> unfinished_import(const std::filesystem::path& album, const std::string& id);

/// The lists of imports that lie in the album itself: an older program's, or somebody else's, whose import would bring this person's
/// photographs into that somebody's album. None is followed.
std::vector<std::filesystem::path> import_lists_in_album(const std::filesystem::path& album);
std::string words_for_list_in_album(const std::filesystem::path& list);

/// The imports that were not finished, oldest first, as this person's own state folder knows them.
std::vector<std::string> unfinished_imports(const std::filesystem::path& album);

/// Gives one up; what it brought stays, what was unpacked for it goes.
std::string give_up_import(const std::filesystem::path& album, const std::string& id);

} // namespace tp
