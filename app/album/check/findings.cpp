// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/findings.hpp"

#include "audio/recordings/byte_source.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace tp {

std::string_view name_of(Finding::Kind kind) {
    constexpr std::array<std::string_view, 17> names{"half_written",
                                                     "unfinished_recording",
                                                     "unlisted_recording",
                                                     "missing_recording",
                                                     "unreadable_recording",
                                                     "unreadable_sidecar",
                                                     "left_behind",
                                                     "conflict_copy",
                                                     "changed_photo",
                                                     "open_to_others",
                                                     "unfinished_import",
                                                     "damaged_trash",
                                                     "link",
                                                     "no_file",
                                                     "import_list",
                                                     "damaged_name_language",
                                                     "unreadable_folder"};
    return names[static_cast<std::size_t>(kind)];
}

void Findings::add(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence) {
    all_.push_back({kind, file, sentence, {}, false, {}});
}

void Findings::add(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence,
                   const std::string& mend, const Mending& mending) {
    Finding finding{kind, file, sentence, mend, false, {}};
    if (mends_) {
        finding.problem = mending();
        finding.mended = finding.problem.empty();
    }
    all_.push_back(std::move(finding));
}

bool Findings::add_folder(const std::filesystem::path& folder, int error) {
    if (error == 0 || error == ENOENT || error == ENOTDIR || error == ELOOP || error == ENXIO)
        return false;
    const bool is_refused = error == EACCES || error == EPERM;
    const bool is_told = std::any_of(all_.begin(), all_.end(), [&](const Finding& one) {
        return one.kind == Finding::Kind::unreadable_folder && one.file == folder;
    });
    if (!is_told)
        add(Finding::Kind::unreadable_folder, folder,
            is_refused ? "The folder " + quoted(folder) + " cannot be read."
                       : "The folder " + quoted(folder) + " cannot be read: " + reason_of(error));
    return true;
}

void Findings::add_damaged(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence,
                           const std::string& mend, const Mending& mending) {
    if (const std::string fault = fault_in_reading(file); !fault.empty())
        add(kind, file, quoted(file) + " cannot be read: " + fault);
    else
        add(kind, file, sentence, mend, mending);
}

} // namespace tp
