// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// Something in an album's folder that is not as it is promised to be.
struct Finding {
    enum class Kind {
        half_written,         ///< a temporary file that a killed program left; nothing in it was acknowledged
        unfinished_recording, ///< a recording that a crash stopped
        unlisted_recording,   ///< a recording that its photograph or person does not know of
        missing_recording,    ///< a listed recording without its file
        unreadable_recording,
        unreadable_sidecar,
        left_behind,   ///< a sidecar, contours or recordings whose photograph is not beside them, or a
                       ///< name of nobody
        conflict_copy, ///< another machine changed the same sidecar
        changed_photo, ///< its bytes are not those that its sidecar knew
        open_to_others, ///< recordings that other people on this machine may hear, or words of a photograph that they may not see
        unfinished_import,
        damaged_trash,
        link, ///< a link that somebody put there; nothing follows it
        no_file, ///< what has the name of a photograph or of something of one's, and is no file: a pipe, a device
        import_list,           ///< a list of what to import that lies in the album, which nobody follows
        damaged_name_language, ///< a file of a name's language that cannot be read or does not have its place
        unreadable_folder,     ///< what is in it is not known, and so not checked
    };
    Kind kind = Kind::half_written;
    std::filesystem::path file;
    std::string sentence; ///< what is wrong
    std::string mend;     ///< what mending does, "It is deleted."; empty: only a person can decide
    bool mended = false;
    std::string problem; ///< why it could not be mended
};

/// "half_written", …: as in JSON.
std::string_view name_of(Finding::Kind kind);

} // namespace tp
