// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace tp::test {

/// A folder for what a fuzzer must write, in memory where there is a place for that; gone with the object.
class MemoryFolder {
public:
    MemoryFolder() {
        std::error_code error;
        const bool memory = std::filesystem::is_directory("/dev/shm", error);
        std::string name =
            ((memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path()) /
             "fuzzed-XXXXXX")
                .string();
        if (::mkdtemp(name.data()) == nullptr)
            std::abort();
        path_ = name;
    }
    ~MemoryFolder() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    /// The file of that name, which holds these bytes now; its folder is made.
    std::filesystem::path file(const std::filesystem::path& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace tp::test
