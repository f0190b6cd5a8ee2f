// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/repair_folder.hpp"

#include "audio/recordings/part_lock.hpp"
#include "audio/recordings/recording_file.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

RepairedPart repaired(const fs::path& part) {
    using Outcome = RepairedPart::Outcome;
    const std::string name = "The recording " + quoted(part.filename());
    const auto failed = [&](const std::string& reason) {
        return RepairedPart{
            part, Outcome::failed, {}, name + " was not finished and cannot be repaired: " + reason};
    };
    const auto lock = PartLock::take(part);
    if (!lock)
        return failed(lock.error());
    if (!*lock)
        return {part, Outcome::in_use, {}, name + " is being made."};
    const auto flac = finish_part(part, **lock, std::nullopt);
    if (!flac)
        return failed(flac.error());
    if (!*flac)
        return {part, Outcome::empty, {}, name + " was not finished and held no sound."};
    return {part, Outcome::stored, **flac,
            name + " was not finished; what was recorded is in " + quoted((*flac)->filename()) + "."};
}

} // namespace

Result<std::vector<RepairedPart>> repair_folder(const fs::path& folder) {
    int error = 0;
    std::vector<fs::path> parts;
    for (const FolderEntry& entry : entries_of(folder, &error))
        if (entry.name.ends_with(wav_part_end))
            parts.push_back(folder / entry.name);
    if (error != 0)
        return Error{"The folder " + quoted(folder) + " cannot be read: " + reason_of(error)};
    std::vector<RepairedPart> result;
    for (const fs::path& part : parts)
        result.push_back(repaired(part));
    return result;
}

} // namespace tp
