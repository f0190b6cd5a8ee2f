// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/findings.hpp"

#include <array>
#include <utility>

namespace tp {

std::string_view name_of(Finding::Kind kind) {
    constexpr std::array<std::string_view, 16> names{"half_written",
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
                                                     "damaged_name_language"};
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

} // namespace tp
