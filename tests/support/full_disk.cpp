// SPDX-License-Identifier: Apache-2.0
#include "full_disk.hpp"

#include "named_place.hpp"

#include <cerrno>
#include <condition_variable>
#include <fcntl.h>
#include <mutex>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::mutex guard;
std::condition_variable moved;
std::string refused, held; ///< empty: none
int waiting = 0, let_through = 0;

bool is_of(const std::string& part, const std::string& path) {
    return !part.empty() && path.find(part) != std::string::npos;
}

/// Whether a file may not get this name, which it waits for.
bool is_refused(const std::string& path) {
    std::unique_lock lock(guard);
    if (is_of(held, path)) {
        ++waiting;
        moved.wait(lock, [] { return held.empty() || let_through > 0; });
        --let_through;
        --waiting;
    }
    if (!is_of(refused, path))
        return false;
    errno = ENOSPC;
    return true;
}

void become(std::string& part, const std::string& value) {
    {
        const std::lock_guard lock(guard);
        part = value;
        let_through = 0;
    }
    moved.notify_all();
}

} // namespace

extern "C" int renameat2(int old_folder, const char* from, int new_folder, const char* to,
                         unsigned flags) noexcept {
    return is_refused(tp::test::named_place(new_folder, to))
               ? -1
               : static_cast<int>(::syscall(SYS_renameat2, old_folder, from, new_folder, to, flags));
}

extern "C" int renameat(int old_folder, const char* from, int new_folder, const char* to) noexcept {
    return ::renameat2(old_folder, from, new_folder, to, 0);
}

FullDisk::FullDisk(const std::string& part) { become(refused, part); }

FullDisk::~FullDisk() { become(refused, {}); }

SlowDisk::SlowDisk(const std::string& part) { become(held, part); }

SlowDisk::~SlowDisk() { become(held, {}); }

bool SlowDisk::waits() const {
    const std::lock_guard lock(guard);
    return waiting > 0;
}

void SlowDisk::let(int files) {
    {
        const std::lock_guard lock(guard);
        let_through += files;
    }
    moved.notify_all();
}
