// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// The sound halves of a camera's pairs in one folder: IMG_1.WAV was recorded with IMG_1.JPG (DCF's rule that
/// files of one object share their name). Read once, asked for each photograph.
class CameraSounds {
public:
    /// A folder that cannot be read has none. `ends`: what their names end in, in lower case.
    explicit CameraSounds(const std::filesystem::path& folder,
                          const std::vector<std::string>& ends = {".wav"});

    /// The file beside that photograph, upper and lower case (of ASCII) being the same; where two would
    /// do, the one that is spelled like the photograph, else the first by name.
    std::optional<std::filesystem::path> of(const std::filesystem::path& photo) const;

private:
    std::multimap<std::string, std::filesystem::path>
        sounds_; ///< by their name in lower case, without its end
};

/// The same for one photograph.
std::optional<std::filesystem::path> sound_beside(const std::filesystem::path& photo);

/// The film of a Live Photo, by the same rule: IMG_1.MOV or IMG_1.MP4 beside IMG_1.HEIC or IMG_1.JPG.
std::optional<std::filesystem::path> video_beside(const std::filesystem::path& photo);

} // namespace tp
