// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/finding.hpp"
#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

struct CheckReport {
    std::size_t photos = 0, recordings = 0;
    std::vector<Finding> findings;
    std::vector<std::string> told; ///< what merging sync conflicts left for a person to know
    bool stopped = false;
};

struct CheckOptions {
    bool mend = false;
    bool hashes = true; ///< reads every photograph whole
    std::function<void(std::size_t photos, const std::filesystem::path& current)> report = {};
};

/// Goes through a folder of an album and everything below it and compares what is there with what is
/// promised. Without `mend` nothing is written. With it nothing is deleted but half-written files: what has
/// to make way goes to the trash.
Result<CheckReport> check_album(const std::filesystem::path& album, const CheckOptions& options = {},
                                const std::stop_token& stop = {});

} // namespace tp
