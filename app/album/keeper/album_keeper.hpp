// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/trash.hpp"
#include "app/album/keeper/undo_history.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "core/base/result.hpp"
#include "core/files/foreign_folder.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

struct ImportedSound;
struct VideoPlace;

/// Everything that a person does to the photographs in one folder of an album and below it. Each step is on
/// the disk when it returns and can be taken back; the photograph's own bytes are never written.
///
/// A text that is returned is empty when done; else a sentence, and nothing was changed unless it says so.
/// Two programs may work on one album: what a step reads, changes and writes, no other changes meanwhile. One
/// thread at a time.
class AlbumKeeper {
public:
    explicit AlbumKeeper(std::filesystem::path album);

    // Recordings. `file` is a tag's file name.

    struct Added {
        Tag tag;
        std::string warning; ///< a sentence where not all of the sound could be read
    };
    /// Takes in any sound file that can be decoded: it becomes a FLAC among the photograph's recordings.
    /// Where the label does not say when it was recorded, the file's time does.
    Result<Added> add_recording(const std::filesystem::path& photo, const std::filesystem::path& sound,
                                const RecordingLabel& label);
    /// Takes in the sound of a short video, a file of its own or a part of one such as a motion photo. One
    /// that is longer than a minute is a film, and refused.
    Result<Added> add_video_sound(const std::filesystem::path& photo, const std::filesystem::path& file,
                                  const VideoPlace& video, const RecordingLabel& label);
    /// Behind which file a recording is listed; empty: it is the first; none: it is the last, and so it is where
    /// that file is not there.
    using Behind = std::optional<std::string>;
    /// Lists a recording that lies among the photograph's already, as the recorder leaves it, by its own
    /// comments.
    Result<Tag> list_recording(const std::filesystem::path& photo, const std::string& file,
                               const Behind& behind = {});
    /// Changes what a recording says of itself, in the sidecar and in its own comments. Until its copy with
    /// these is whole, a stop leaves all as it was.
    std::string label_recording(const std::filesystem::path& photo, const std::string& file,
                                const RecordingLabel& label, const std::stop_token& stop = {});
    /// Plays the photograph's recordings in this order from now on; those not named follow by kind.
    std::string order_recordings(const std::filesystem::path& photo, const std::vector<std::string>& files);
    /// Keeps the part from `begin_s` to `end_s`; the whole one goes to the trash.
    Result<Tag> trim_recording(const std::filesystem::path& photo, const std::string& file, double begin_s,
                               double end_s);
    std::string delete_recording(const std::filesystem::path& photo, const std::string& file);
    /// Whether the trash holds this recording.
    bool is_in_trash(const std::filesystem::path& photo, const std::string& file) const;
    /// Takes a recording whose file is gone off the photograph's list.
    std::string forget_recording(const std::filesystem::path& photo, const std::string& file);

    // Photographs.

    struct AddedPhoto {
        std::filesystem::path photo; ///< where it lies
        std::string warning; ///< a sentence where its sidecar could not be written; the photograph is kept
    };
    /// Keeps a new photograph, of which these are all bytes: under the wanted name in the album, or the next number where
    /// that or something that would be its own is there. `faces` are those of whom it is known who they are. Taken back
    /// it goes to the trash.
    Result<AddedPhoto> add_photo(const std::filesystem::path& wanted, std::string_view bytes,
                                 const std::vector<FaceRegion>& faces);
    /// How `history()` calls that step.
    static std::string words_for_added(const std::filesystem::path& photo);
    /// To the trash, with everything that is its own.
    std::string delete_photo(const std::filesystem::path& photo);
    /// The short and the long description in one language; empty takes it away.
    std::string describe(const std::filesystem::path& photo, const std::string& language,
                         const std::string& alt_text, const std::string& description);

    /// Moves what belongs to a photograph, sidecar and recordings and all, to where the photograph is now.
    /// Nothing is moved where a place is taken.
    std::string move_companions(const std::filesystem::path& from, const std::filesystem::path& to);

    // People.

    /// Says who a face is, empty: nobody knows. A face of nearly the same place is renamed, else a region is
    /// added.
    std::string name_face(const std::filesystem::path& photo, const FaceRegion& face);
    struct FaceToName {
        std::filesystem::path photo;
        FaceRegion face; ///< with the name
    };
    /// The same of several faces of one name, in one step: all of them or none.
    std::string name_faces(const std::vector<FaceToName>& faces);
    /// Another name for a person on these photographs, recordings included; where there is a person of that
    /// name already the two become one. How many photographs were changed.
    Result<std::size_t> rename_person(const std::vector<std::filesystem::path>& photos,
                                      const std::string& from, const std::string& to);

    /// Keeps how somebody says a person's name; an earlier one goes to the trash.
    std::string keep_name_recording(const std::string& person, const std::filesystem::path& sound);
    /// Gives it to another name, for a person who is called so everywhere from now on; where that name has
    /// been recorded already, this one goes to the trash. Done where there is none.
    std::string rename_name_recording(const std::string& from, const std::string& to);
    /// Where it is kept, be it there or not.
    std::filesystem::path place_of_name(const std::string& person) const;
    /// The same, if it is there.
    std::optional<std::filesystem::path> name_recording(const std::string& person) const;

    // Taking back.

    /// Puts something from the trash back to where it was, recordings back into their photograph's list.
    std::string restore(const std::string& id);
    Trash& trash() { return trash_; }
    UndoHistory& history() { return history_; }
    const std::filesystem::path& album() const { return album_; }

private:
    Result<Added> listed(const std::filesystem::path& photo, const ImportedSound& kept);
    using Change = std::function<SidecarChanges(const PhotoRecord&)>;
    /// Reads, changes and writes the sidecar; nobody of ours comes between.
    std::string change_sidecar(const std::filesystem::path& photo, const Change& change);
    struct FaceBefore {
        bool was_there = false;
        FaceRegion face;
    };
    std::string put_face(const FaceToName& face, FaceBefore* before = nullptr);
    /// As it was before put_face.
    std::string put_face_back(const FaceToName& face, const FaceBefore& before);
    /// In place of what is listed under its file's name, else there.
    std::string list(const std::filesystem::path& photo, const Tag& tag, const Behind& behind = {});
    std::string listed_behind(const std::filesystem::path& photo, const std::string& file) const;
    std::string restore(const std::string& id, const Behind& behind);
    std::string unlist(const std::filesystem::path& photo, const std::string& file);
    std::string relabel(const std::filesystem::path& photo, const std::string& file,
                        const RecordingLabel& label, const std::stop_token& stop = {});
    std::string set_orders(const std::filesystem::path& photo, const std::vector<std::string>& files);
    Result<std::string> put_recording(const std::filesystem::path& photo, const Tag& tag);
    Result<Tag> tag_of(const std::filesystem::path& photo, const std::string& file) const;
    std::string outside(const std::filesystem::path& photo) const;
    /// To the trash, with everything that is its own; the entry's id.
    Result<std::string> put_photo(const std::filesystem::path& photo);
    std::string rename_on(const std::filesystem::path& photo, const std::string& from, const std::string& to);
    /// Takes apart again what `rename_on` did to a photograph that was as `before`.
    std::string rename_back(const std::filesystem::path& photo, const PhotoRecord& before,
                            const std::string& from, const std::string& to);

    std::filesystem::path album_;
    ForeignFolder held_; ///< what is in it
    Trash trash_;
    UndoHistory history_;
};

} // namespace tp
