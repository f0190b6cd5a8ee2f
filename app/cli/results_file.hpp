// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/files/open_file.hpp"

#include <QByteArray>

#include <chrono>
#include <filesystem>
#include <string>
#include <unordered_set>
#include <utility>

namespace tp {

/// The lines of `faces --json` in a file that a batch which was stopped, killed or cut off from power goes on
/// from. One process writes to it at a time.
class ResultsFile {
public:
    /// Opens or makes the file and reads which photographs it holds. A last line without its end is dropped.
    /// An error, and the file as it was, where it holds anything that is not such a line, cannot be written,
    /// or is being written by another process.
    static Result<ResultsFile> open(const std::filesystem::path& file);
    bool holds(const std::string& photo) const { return photos_.contains(photo); }

    /// Appends the line of a photograph. It survives this process at once, a power cut within a second. The
    /// sentence that says why it could not be written; empty: it was.
    std::string append(const std::string& photo, const QByteArray& line);
    /// Brings all lines to the disk; as append.
    std::string sync();

private:
    ResultsFile(std::filesystem::path file, OpenFile open) : file_(std::move(file)), open_(std::move(open)) {}
    std::string read();
    std::string unwritable(int error) const;

    std::filesystem::path file_;
    OpenFile open_;
    std::unordered_set<std::string> photos_;
    std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

} // namespace tp
