// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/files/open_file.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tp {

/// What happens to a file that has the name already.
enum class Existing {
    replaced,
    kept,
    swapped, ///< it lies under `temporary()` until the `NewFile` is destroyed: nobody's last word is lost
             ///< unseen
};

/// A file being written beside its place, under a temporary name; it takes its place only when it is whole
/// and on the disk. Destroyed before that it leaves nothing behind.
class NewFile {
public:
    /// A link stays a link: what it points to is replaced, or made where nothing is there; where its folder
    /// is away, as a disk that is not plugged in, that is an error. In a ForeignFolder a link is an error, and everywhere what is
    /// no file, such as a device. An error ends in the system's reason.
    static Result<NewFile> beside(const std::filesystem::path& place, Readers readers = Readers::as_usual);
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&&) = delete;
    ~NewFile();

    /// Nobody but its owner may do with it what they may not do with `other`, a photograph whose words it holds, say.
    void no_more_open_than(const std::filesystem::path& other) { file_.no_more_open_than(other); }

    /// Where it lies until it takes its place; a library that writes by name may write there.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Appends; the reason why not, else empty. Much that was written goes to the disk in between: a process does not end while
    /// gigabytes are on their way there.
    std::string write(std::string_view bytes);
    /// Brings it to the disk and gives it its name. When this returns empty, a power cut finds it whole; else
    /// it is the reason why not, and what had the name is as it was (or, where only the folder could not be
    /// brought to the disk, replaced by the whole new one until a power cut). `kept`: "there is a file of
    /// that name already." `swapped`: "its folder is gone." where there is none; a file system that cannot
    /// swap replaces, and `temporary()` is empty.
    std::string take_place(Existing existing = Existing::replaced);

    /// For a process that ends now, whatever its threads are in: removes all files that have not taken their
    /// place, and from then on none does and none begins; who tries waits for the end.
    static void give_up_all();

private:
    NewFile(std::filesystem::path place, bool linked, std::filesystem::path temporary, OpenFile file)
        : place_(std::move(place)), linked_(linked), temporary_(std::move(temporary)),
          file_(std::move(file)) {}

    std::filesystem::path place_;
    bool linked_; ///< a link has the name, and leads there
    std::filesystem::path temporary_;
    OpenFile file_;
    std::size_t in_memory_ = 0; ///< bytes that were written since some were brought to the disk
};

/// While one lives on a thread, a file that takes a free name there (`Existing::kept`) counts as unfinished although it is whole:
/// `give_up_all` removes it, until the file that names it has its place too. A recording and the list that it stands in are made so.
class MadeTogether {
public:
    MadeTogether();
    ~MadeTogether(); ///< what is unfinished yet stays
    MadeTogether(const MadeTogether&) = delete;
    MadeTogether& operator=(const MadeTogether&) = delete;

    /// The next file that takes its place on this thread finishes all of them in the same step.
    void next_completes() { next_completes_ = true; }

private:
    friend class NewFile;
    std::vector<std::filesystem::path> unfinished_;
    bool next_completes_ = false;
    MadeTogether* outer_;
};

/// Whether a file of this name is one that `NewFile` was writing; in a folder that nothing writes to, a power
/// cut or a killed process left it behind.
bool is_temporary(const std::filesystem::path& file);

} // namespace tp
