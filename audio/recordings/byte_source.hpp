// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/files/open_file.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tp {

/// Bytes that can be read at any place: a file's, or a test's in memory.
class ByteSource {
public:
    virtual ~ByteSource() = default;
    virtual std::uint64_t size() const = 0;
    /// Fills `to` from the byte `at` on; how many there were. Fewer than asked: they end there, or the disk
    /// reports a fault.
    virtual std::size_t read(std::uint64_t at, std::span<char> to) const = 0;
    /// The system's number of the first fault that a disk reported; 0 where none did. What is wrong with what was read may be
    /// the disk's then, and not the file's.
    virtual int fault() const { return 0; }
};

/// A view of memory that outlives it.
class MemoryBytes : public ByteSource {
public:
    explicit MemoryBytes(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t size() const override { return bytes_.size(); }
    std::size_t read(std::uint64_t at, std::span<char> to) const override;

private:
    std::string_view bytes_;
};

/// Some of another's bytes: those from `begin` on, `size` of them or as many as there are.
class PartOfBytes : public ByteSource {
public:
    PartOfBytes(std::unique_ptr<ByteSource> whole, std::uint64_t begin, std::uint64_t size);
    std::uint64_t size() const override { return size_; }
    std::size_t read(std::uint64_t at, std::span<char> to) const override;
    int fault() const override { return whole_->fault(); }

private:
    std::unique_ptr<ByteSource> whole_;
    std::uint64_t begin_;
    std::uint64_t size_;
};

/// A file's bytes; its size is what it was when it was opened.
class FileBytes : public ByteSource {
public:
    /// An error is the end of a sentence. Pipes, devices and folders are refused, because reading them may
    /// never end.
    static Result<std::unique_ptr<FileBytes>> open(const std::filesystem::path& file);
    /// Of a file that is open already, and stays so for as long as this is.
    static Result<std::unique_ptr<FileBytes>> of(const OpenFile& file);
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::uint64_t size() const override { return size_; }
    std::size_t read(std::uint64_t at, std::span<char> to) const override;
    int fault() const override { return fault_; }

private:
    explicit FileBytes(OpenFile file) : own_(std::move(file)), file_(&own_) {}
    explicit FileBytes(const OpenFile* file) : file_(file) {}
    std::string measure();

    OpenFile own_;
    const OpenFile* file_;
    std::uint64_t size_ = 0;
    mutable std::atomic<int> fault_{0};
};

/// Why the disk does not give all of a file's bytes, the end of a sentence; empty where it does: what is wrong with them is
/// their own then.
std::string fault_in_reading(const std::filesystem::path& file);

} // namespace tp
