// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/open_file.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace tp {

// What the system does with names of files, for the rest of this room and for who must tell its errors apart. What others need
// is in durable_file.hpp and new_file.hpp. Those that return a number return 0, or the system's `errno`.

/// Of what the name leads to, be it by links; none, and `errno`, where it leads to nothing. Of a name in a ForeignFolder as
/// `facts_of_name`.
std::optional<FileFacts> facts_of(const std::filesystem::path& file);
/// Of a photograph, which may be a link itself in a ForeignFolder too.
std::optional<FileFacts> facts_of_photo(const std::filesystem::path& file);
/// Of what has the name, be it a link.
std::optional<FileFacts> facts_of_name(const std::filesystem::path& file);

/// Gives a file another name, which whatever had it loses.
int rename_over(const std::filesystem::path& from, const std::filesystem::path& to);
/// Gives a file another name that nothing has; EEXIST otherwise.
int rename_to_free(const std::filesystem::path& from, const std::filesystem::path& to);
/// The same of a file or folder.
int move_to_free(const std::filesystem::path& from, const std::filesystem::path& to);
/// Each file has the other's name from then on; EINVAL or ENOSYS where that cannot be done in one step.
int swap_names(const std::filesystem::path& one, const std::filesystem::path& other);
int remove_name(const std::filesystem::path& file) noexcept;
/// Removes an empty folder.
int remove_directory(const std::filesystem::path& folder);

/// Whether others than its owner may do anything with a file or folder; false of a link.
bool open_to_others(const std::filesystem::path& file);
/// From then on its owner may read and write a file, and look into a folder, and nobody else; EMLINK of a file that has other
/// names, which may be somebody's who knows why.
int only_for_owner(const std::filesystem::path& file);

/// Whether a folder itself says who may read what is made in it (POSIX: its default access control list,
/// or the mount of a file system without rights, such as exFAT).
bool names_its_readers(const std::filesystem::path& folder);
/// Whether others than its owner may do with a file what they may not do with `other`; false of a link.
bool more_open_than(const std::filesystem::path& file, const std::filesystem::path& other);
/// From then on they may not.
int no_more_open_than(const std::filesystem::path& file, const std::filesystem::path& other);

/// EEXIST where something has the name.
int make_directory(const std::filesystem::path& folder, Readers readers);
/// Brings a folder's names to the disk; 0 too where its file system does that by itself, or cannot.
int names_to_disk(const std::filesystem::path& folder);
/// The times of `from` become those of `to`.
int copy_times(const OpenFile& from, const std::filesystem::path& to);

/// While one lives, another process holds those of the files that are large. Whoever removes their names and closes them does not
/// wait until the disk has their place back, which may take a second for gigabytes; the other process does, and ends. Nothing where
/// the system does not let that be done.
class HeldElsewhere {
public:
    explicit HeldElsewhere(const std::vector<std::filesystem::path>& files);
    ~HeldElsewhere();
    HeldElsewhere(const HeldElsewhere&) = delete;
    HeldElsewhere& operator=(const HeldElsewhere&) = delete;

private:
    int alive_ = -1; ///< the other process waits for its closing
};

/// The number of this process, which no other on this machine has while it runs.
long this_process();
bool process_lives(long number);

} // namespace tp
