// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <QString>
#include <QStringList>

#include <filesystem>
#include <string>

namespace tp {

/// Recordings and tables of the lab in their folder, each with a setup of the same name beside it.
class LabFiles {
public:
    /// The folder is made when it is needed.
    explicit LabFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    QString folder_words() const { return path_words(folder_); }
    /// Why there can be no folder; empty where it is there now.
    std::string make_folder() const;
    /// Names of the recordings, the newest first.
    QStringList recordings() const;
    std::filesystem::path recording(const QString& name) const { return folder_ / name.toStdString(); }
    /// A file with this ending, by a name that neither a recording nor a table nor a setup has; the end of a sentence where
    /// the disk does not tell.
    Result<std::filesystem::path> new_file(const char* ending) const;

    /// A path as the system writes it.
    static QString path_words(const std::filesystem::path& file);

private:
    std::filesystem::path folder_;
};

} // namespace tp
