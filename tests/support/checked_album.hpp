// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/album_check.hpp"
#include "audio/recordings/recording_file.hpp"

#include <filesystem>
#include <vector>

namespace tp::test {

/// What a check finds; that it could not be made is a finding too.
inline CheckReport checked(const std::filesystem::path& album, bool mend) {
    CheckOptions options;
    options.mend = mend;
    const auto report = check_album(album, options);
    return report
               ? *report
               : CheckReport{
                     0, 0, {{Finding::Kind::damaged_trash, album, report.error(), {}, false, {}}}, {}, false};
}

/// All FLAC files of the album, the trash too.
inline std::vector<std::filesystem::path> sounds_in(const std::filesystem::path& album) {
    std::vector<std::filesystem::path> sounds;
    for (const auto& file : std::filesystem::recursive_directory_iterator(album))
        if (file.is_regular_file() && about_recording(file.path()).ok())
            sounds.push_back(file.path());
    return sounds;
}

} // namespace tp::test
