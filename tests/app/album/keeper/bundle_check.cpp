// SPDX-License-Identifier: Apache-2.0
#include "bundle_check.hpp"

#include "app/album/keeper/bundle.hpp"
#include "made_zip.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <vector>

namespace tp::test {

namespace fs = std::filesystem;

namespace {

const BundleLimits limits{1 << 16, 64, 200.0};

/// A folder in memory where there is one, gone with the program. The bundle is unpacked some folders deep, so
/// that what climbs out of it is seen.
class Place {
public:
    Place() {
        std::error_code error;
        const bool memory = fs::is_directory("/dev/shm", error);
        std::string name =
            ((memory ? fs::path("/dev/shm") : fs::temp_directory_path()) / "bundle-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            qFatal("no folder to unpack in");
        folder_ = name;
    }
    ~Place() { fs::remove_all(folder_); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    fs::path bundle() const { return folder_ / "bundle"; }
    fs::path out() const { return folder_ / "a" / "b" / "out"; }
    /// Empties the folders and leaves the bundle.
    void empty() const {
        fs::remove_all(folder_ / "a");
        fs::create_directories(out().parent_path());
    }
    /// What lies in it beside the bundle and below `out`.
    std::size_t outside() const {
        std::size_t count = 0;
        for (auto file = fs::recursive_directory_iterator(folder_);
             file != fs::recursive_directory_iterator(); ++file) {
            if (file->path() == out())
                file.disable_recursion_pending();
            else
                ++count;
        }
        return count;
    }

private:
    fs::path folder_;
};

bool climbs(const std::string& name) {
    const fs::path path = name;
    return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

/// The entries of such a list.
std::vector<ZipEntry> entries_in(std::string_view list) {
    std::vector<ZipEntry> entries;
    while (!list.empty()) {
        const std::string_view line = list.substr(0, list.find('\n'));
        list.remove_prefix(std::min(list.size(), line.size() + 1));
        const std::string_view written = line.substr(std::min<std::size_t>(line.size(), 1));
        const std::string name(written.substr(0, written.find('\0'))); // as it comes into the zip
        if (line.starts_with('d'))
            entries.push_back({name, "", AE_IFDIR});
        else if (line.starts_with('l'))
            entries.push_back({name, "", AE_IFLNK, "/etc/passwd"});
        else if (line.starts_with('f'))
            entries.push_back({name, std::string(line)});
    }
    return entries;
}

/// What lies below the folder, and what is wrong with it.
struct Unpacked {
    std::size_t files = 0; ///< and folders
    std::string complaint;
};

Unpacked unpacked_in(const fs::path& folder) {
    Unpacked found;
    std::uintmax_t total = 0;
    for (const auto& file : fs::recursive_directory_iterator(folder)) {
        struct stat about {};
        if (::lstat(file.path().c_str(), &about) != 0 || (!S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode)))
            found.complaint = "something else than a file or folder came out";
        else if ((about.st_mode & 077u) != 0)
            found.complaint = "others may read what came out";
        if (S_ISREG(about.st_mode))
            total += static_cast<std::uintmax_t>(about.st_size);
        ++found.files;
    }
    if (total > limits.most_bytes)
        found.complaint = "more came out than the limit";
    return found;
}

} // namespace

std::string complaint_about_bundle(std::string_view bytes) {
    static const Place place;
    const bool zip = bytes.starts_with("PK");
    const std::vector<ZipEntry> entries = zip ? std::vector<ZipEntry>{} : entries_in(bytes);
    if (zip)
        std::ofstream(place.bundle(), std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    else
        write_zip(place.bundle(), entries);

    place.empty();
    const std::string problem = unpack_bundle(place.bundle(), place.out(), limits);
    if (place.outside() != 3) // the bundle, a and b
        return "something came out elsewhere";
    const Unpacked out = unpacked_in(place.out());
    if (!out.complaint.empty())
        return out.complaint;
    if (!problem.empty())
        return problem.starts_with("The bundle ") && problem.ends_with('.') && problem.size() > 30
                   ? std::string{}
                   : "refused without words: " + problem;
    if (out.files == 0)
        return "nothing came out of it, and nobody was told";
    for (const ZipEntry& entry : entries)
        if (entry.type == AE_IFREG && climbs(entry.name))
            return "a name that leads elsewhere was let in: " + entry.name;
    return {};
}

} // namespace tp::test
