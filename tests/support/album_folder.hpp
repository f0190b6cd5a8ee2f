// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/durable_file.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>

#include <filesystem>
#include <map>
#include <string>

namespace tp {

/// A folder of files made by a test.
class AlbumFolder {
public:
    AlbumFolder() = default;
    /// QTemporaryDir leaves files behind whose names are not UTF-8.
    ~AlbumFolder() { std::filesystem::remove_all(path()); }
    std::filesystem::path path() const { return dir_.path().toStdString(); }
    std::filesystem::path operator/(const std::filesystem::path& name) const { return path() / name; }

    std::filesystem::path write(const std::filesystem::path& name, const std::string& bytes) const {
        const std::filesystem::path file = path() / name;
        if (!make_folder(file.parent_path()).empty() || !replace_file(file, bytes).empty())
            qFatal("cannot write %s", file.c_str());
        return file;
    }
    std::string read(const std::filesystem::path& name) const {
        const auto bytes = read_whole(path() / name, 1 << 24);
        return bytes ? *bytes : "error: " + bytes.error();
    }
    /// Name below the folder → bytes, of every file.
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& file : std::filesystem::recursive_directory_iterator(path()))
            if (file.is_regular_file()) {
                const auto name = file.path().lexically_relative(path());
                all[name.string()] = read(name);
            }
        return all;
    }

private:
    QTemporaryDir dir_;
};

} // namespace tp
