// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace tp {

/// Who may read a file or folder that is made new. A file that is replaced keeps what it had.
enum class Readers {
    as_usual, ///< as the person's other files (the process's umask)
    owner_only, ///< 0600: what nobody else on this machine may see or hear, but those whom the folder itself names
};

/// How a file is opened. No program that is started meanwhile has it; a pipe or a device never makes one wait.
struct OpenMode {
    bool read = true;
    bool write = false;
    bool make = false;       ///< where nothing has that name
    bool only_new = false;   ///< EEXIST where something has it; with `make`
    bool emptied = false;    ///< what it held is gone
    bool at_end = false;     ///< each write goes behind what is there
    bool follow_link = true; ///< else ELOOP where the name is a link; in a ForeignFolder none is followed
    bool looked_at =
        false; ///< a photograph: read through a link that is its own name, in a ForeignFolder too
    Readers readers = Readers::as_usual; ///< of one that is made
};

/// What the disk says of a file or folder.
struct FileFacts {
    enum class Kind { file, folder, link, other };

    Kind kind = Kind::other;
    std::uint64_t bytes = 0;
    std::int64_t written_ns = 0;                      ///< when its content changed last, since 1970
    std::int64_t changed_ns = 0;                      ///< when anything of it changed last, its name too
    std::pair<std::uint64_t, std::uint64_t> identity; ///< disk and number: one file under all its names
};

/// Bytes that were written before the system refused; its `errno`, 0 where all were.
struct Written {
    std::size_t count = 0;
    int error = 0;
};

/// A file held open; it closes itself. What fails says why in `errno`, on every system (`reason_of`), and a call that a signal
/// ended is made again. Not for two threads at a time, but for `read_at` and `write_at`.
class OpenFile {
public:
    OpenFile() = default;
    /// Takes over what is open already.
    explicit OpenFile(int number) : number_(number) {}
    /// Not `ok` where it could not be opened.
    OpenFile(const std::filesystem::path& file, const OpenMode& how);
    OpenFile(OpenFile&& other) noexcept : number_(other.release()) {}
    OpenFile& operator=(OpenFile&& other) noexcept;
    ~OpenFile() { close(); }

    bool ok() const { return number_ >= 0; }
    /// As the system's library counts open files.
    int number() const { return number_; }
    /// Its number, which is the caller's to close.
    int release() { return std::exchange(number_, -1); }
    /// What the system calls it by, to be handed to another process; this one is closed then.
    Descriptor handed_over();
    void close();

    std::optional<FileFacts> facts() const;
    /// A path by which a library that opens files by name, in this process, gets this one, whatever has its name by then; empty
    /// where the system has none such.
    std::filesystem::path name_of_opened() const;
    /// Fills `to` from where it stands; how many bytes there were, fewer at the file's end. −1: a fault.
    std::int64_t read(std::span<char> to);
    /// Fills `to` from the byte `at` on; how many bytes there were before the file's end, or a fault. Where there were fewer,
    /// `errno` is 0 at the end.
    std::size_t read_at(std::uint64_t at, std::span<char> to) const;
    Written write(std::string_view bytes);
    Written write_at(std::uint64_t at, std::string_view bytes) const;
    /// Where it stands from then on, in bytes from its beginning; `from` is SEEK_SET, SEEK_CUR or SEEK_END. −1: a fault.
    std::int64_t go_to(std::int64_t offset, int from);
    /// Leaves its first `bytes`; 0, or the system's error, as the two below.
    int cut(std::uint64_t bytes);
    /// What was written, by whomever, survives a power cut from then on.
    int to_disk() const;
    /// The same without its times.
    int bytes_to_disk() const;
    /// Waits until what was written is out of this machine's memory; a power cut may lose it yet.
    int bytes_out_of_memory() const;
    /// Whoever may use `other` may use this one from then on, as far as the system lets that be said.
    void give_readers_of(const std::filesystem::path& other) const;
    /// Nobody but its owner may do with it what they may not do with `other`.
    void no_more_open_than(const std::filesystem::path& other) const;

    /// Held by one opening of the file at a time, of whichever process, and let go when that is closed or its process
    /// dies. Other programs need not heed it. False: EWOULDBLOCK where another holds it, else what the file system says.
    bool lock() const;
    /// Waits for it as long as that takes.
    bool wait_for_lock() const;

private:
    int number_ = -1;
};

/// Fills `to` from the byte `at` on of a file that somebody else has opened, and asks the system for nothing else (a confined
/// process may not); how many bytes there were before its end, or a fault. Where there were fewer, `errno` is 0 at the end.
std::size_t read_at(DescriptorNumber file, std::uint64_t at, std::span<char> to);

} // namespace tp
