// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_work.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace tp {

/// The file of a photograph's mended contours while somebody works on them.
///
/// Contours that are again as they were when the file was opened give the very bytes that it had then, be they
/// of a drawing program; without a mended contour there is no file.
class MendFile {
public:
    MendFile() = default;
    /// `opened`: what the contours were when the file was read; an error where it is there and cannot be read.
    static Result<MendFile> open(const std::filesystem::path& photo, const MendWork& opened);

    const std::filesystem::path& path() const { return path_; }
    /// Whether `work` says something else than the file.
    bool differs(const MendWork& work) const { return bytes_for(work) != there_; }
    /// Brings `work` to the disk. Empty when it is there; else the sentence that says why not, and the file is
    /// as it was. A file that another program changed meanwhile is kept beside it, under the name that
    /// `kept_aside` then says.
    std::string save(const MendWork& work);
    const std::filesystem::path& kept_aside() const { return kept_aside_; }

private:
    using Bytes = std::optional<std::string>; ///< none: no file
    Bytes bytes_for(const MendWork& work) const;
    std::string keep_what_others_wrote();

    std::filesystem::path path_, kept_aside_;
    std::string opened_text_; ///< of the sheet when the file was opened
    Bytes opened_, there_;
};

} // namespace tp
