// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <type_traits>
#include <unistd.h>

namespace tp::vm {

/// A table in a file that two programs map: one appends rows, the other reads them while it does and after it
/// was killed.
template <typename Row>
class SharedLog {
    static_assert(std::is_trivially_copyable_v<Row> && std::atomic<std::uint64_t>::is_always_lock_free);

public:
    static constexpr std::size_t capacity = 131072; ///< rows: two minutes of milliseconds

    /// Maps `file`, which is made where there is none; good() says whether it worked.
    explicit SharedLog(const std::string& file) {
        const int opened = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (opened < 0)
            return;
        if (::ftruncate(opened, sizeof(Table)) == 0) {
            void* const mapped =
                ::mmap(nullptr, sizeof(Table), PROT_READ | PROT_WRITE, MAP_SHARED, opened, 0);
            table_ = mapped == MAP_FAILED ? nullptr : static_cast<Table*>(mapped);
        }
        ::close(opened);
    }
    ~SharedLog() {
        if (good())
            ::munmap(table_, sizeof(Table));
    }
    SharedLog(const SharedLog&) = delete;
    SharedLog& operator=(const SharedLog&) = delete;

    bool good() const { return table_ != nullptr; }
    /// One thread of one program. What comes after the last row that has room is left out.
    void append(const Row& row) noexcept {
        const std::uint64_t count = table_->count.load(std::memory_order_relaxed);
        if (count >= capacity)
            return;
        table_->rows[count] = row;
        table_->count.store(count + 1, std::memory_order_release);
    }
    std::size_t size() const noexcept { return table_->count.load(std::memory_order_acquire); }
    /// Only below a size() that was read.
    const Row& operator[](std::size_t i) const noexcept { return table_->rows[i]; }

private:
    struct Table { // a new file is zeros, which is an empty one
        std::atomic<std::uint64_t> count;
        Row rows[capacity];
    };
    Table* table_ = nullptr;
};

} // namespace tp::vm
