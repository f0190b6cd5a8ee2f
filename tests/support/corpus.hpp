// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace tp::test {

/// Text or bytes that is known to reach somewhere.
struct Seed {
    std::string name;
    std::string text;
};

/// The files of a folder, in the order of their names.
inline std::vector<Seed> corpus(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Seed> seeds;
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        seeds.push_back({file.filename().string(), {std::istreambuf_iterator<char>(stream), {}}});
    }
    return seeds;
}

} // namespace tp::test
