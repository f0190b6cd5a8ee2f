// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace tp {

/// Which files of a bundle are part of it, by their names: photographs outside hidden folders, and what an
/// import takes along with one: sidecars, mended contours, recordings, the sound or film that a camera
/// stored beside it. All else is somebody's own and stays packed.
class BundleParts {
public:
    /// A file that the bundle holds.
    void add(const std::filesystem::path& file);

    bool has_photo() const { return !photos_.empty(); }
    /// Once all files were added.
    bool hold(const std::filesystem::path& file) const;

private:
    std::set<std::filesystem::path> photos_;
    std::set<std::filesystem::path> stems_; ///< of the photographs, in lower case
};

} // namespace tp
