// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/new_file.hpp"
#include "core/files/open_folder.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

// Each returns empty when done, and then a power cut does not undo it; else the reason why not, the end of a
// sentence, and nothing is lost: what was there is as it was, or whole under its new name.

/// Makes these bytes the whole content of `file`.
std::string replace_file(const std::filesystem::path& file, std::string_view bytes,
                         Readers readers = Readers::as_usual);

/// A copy with the bytes and the time of change of `from`, open to nobody who may not read that; `to` must not exist.
std::string copy_whole(const std::filesystem::path& from, const std::filesystem::path& to,
                       Readers readers = Readers::as_usual);

/// Gives a file or folder another name; `to` must not exist. Both lie on one file system ("they lie on
/// different disks." otherwise).
std::string move_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a folder and those above it that are missing; done where it exists.
std::string make_folder(const std::filesystem::path& folder, Readers readers = Readers::as_usual);

/// Brings a folder's names to the disk. Done where its file system cannot, such as some network shares. Empty
/// path: the working folder.
std::string sync_folder(const std::filesystem::path& folder);

/// Removes a file; done where there is none.
std::string remove_file(const std::filesystem::path& file);

/// Removes a folder and all that is in it, or a file; done where there is none. A link is left alone, and so are the folders that
/// it lies in: the reason then names it.
std::string remove_tree(const std::filesystem::path& folder);

/// Whether something has this name, be it a link to nothing. False too where the disk reports a fault.
bool name_taken(const std::filesystem::path& file);
/// Whether nothing has this name, for certain: the disk says so, and reports no fault.
bool is_gone(const std::filesystem::path& file);

// What a name is. In a ForeignFolder a link is none of these but a link, and what lies behind one is nothing.
bool file_there(const std::filesystem::path& file);
bool folder_there(const std::filesystem::path& folder);
bool link_there(const std::filesystem::path& file);
/// A photograph, which may be a link itself in a ForeignFolder too: it may be looked at.
bool photo_there(const std::filesystem::path& photo);

/// What is in a folder, by name; nothing, and the system's number, where it cannot be opened or is the kernel's. Empty path: the working folder.
std::vector<FolderEntry> entries_of(const std::filesystem::path& folder, int* error = nullptr);

} // namespace tp
