// SPDX-License-Identifier: Apache-2.0
// A library to be preloaded: the program's own way to the disk, counted, and one call of it broken.
//
//   TP_FAULT=kill@N          the process is killed just before the N-th call that changes a file
//   TP_FAULT=half@N          half of the bytes of the N-th call are written if it is a write, then the process is killed
//   TP_FAULT=ENOSPC@N        that call and all later ones fail so (also EIO, EROFS)
//   TP_FAULT=EIO-once@N      that call fails so, and no other
//   TP_FAULT_READS=all       calls that read and look count too
//   TP_FAULT_READS=bytes     calls that read bytes or list a folder count, and no others: a bad place on the disk
//   TP_FAULT_COUNT=FILE      the number of calls is written there when the program ends
//   TP_FAULT_BELOW=DIR       only files below it count
//   TP_FAULT_WAITS=1         none counts until the program calls tp_count_calls_from_here()
//   TP_BESIDE=PROGRAM@N,M    PROGRAM runs, not preloaded, from before the N-th call to its own end, and before the M-th again
#include "named_place.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <spawn.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

enum class Fault { none, kill, half, error };

struct Plan {
    Fault fault = Fault::none;
    int error = 0;
    bool once = false, reads = false, only_bytes = false;
    long at = 0;
    std::string beside;
    long beside_at = 0, again_at = 0;
    std::string below;
    std::atomic<long> calls{0};
    std::atomic<bool> waits{std::getenv("TP_FAULT_WAITS") != nullptr};

    Plan() {
        if (const char* folder = std::getenv("TP_FAULT_BELOW"))
            below = folder;
        if (const char* which = std::getenv("TP_FAULT_READS")) {
            only_bytes = std::strcmp(which, "bytes") == 0;
            reads = !only_bytes;
        }
        if (const char* program = std::getenv("TP_BESIDE"))
            if (const char* call = std::strrchr(program, '@')) {
                beside.assign(program, call);
                beside_at = std::atol(call + 1);
                if (const char* again = std::strchr(call, ','))
                    again_at = std::atol(again + 1);
            }
        const char* text = std::getenv("TP_FAULT");
        const char* place = text ? std::strchr(text, '@') : nullptr;
        if (!place)
            return;
        std::string kind(text, place);
        once = kind.ends_with("-once");
        if (once)
            kind.resize(kind.size() - 5);
        at = std::atol(place + 1);
        error = kind == "ENOSPC" ? ENOSPC : kind == "EIO" ? EIO : kind == "EROFS" ? EROFS : 0;
        fault = kind == "kill"   ? Fault::kill
                : kind == "half" ? Fault::half
                : error          ? Fault::error
                                 : Fault::none;
    }
    ~Plan() {
        if (const char* file = std::getenv("TP_FAULT_COUNT"))
            if (std::FILE* out = std::fopen(file, "w")) {
                std::fprintf(out, "%ld\n", calls.load());
                std::fclose(out);
            }
    }
};

Plan& plan() {
    static Plan it;
    return it;
}

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool counts(const char* path) {
    if (plan().waits)
        return false;
    const std::string& below = plan().below;
    if (below.empty() || !path)
        return !below.empty() || path != nullptr;
    if (path[0] == '/')
        return std::strncmp(path, below.c_str(), below.size()) == 0;
    char folder[4096];
    return getcwd(folder, sizeof folder) && std::strncmp(folder, below.c_str(), below.size()) == 0;
}

/// What is told as a name in an open folder.
bool counts(int folder, const char* path) { return counts(tp::test::named_place(folder, path).c_str()); }

bool counts(int file) {
    if (plan().waits)
        return false;
    char link[64], path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = readlink(link, path, sizeof path - 1);
    if (length <= 0)
        return false;
    path[length] = '\0';
    return path[0] == '/' && counts(path);
}

/// Another program's turn.
void run_beside(const std::string& program) {
    std::vector<char*> surroundings;
    for (char** variable = environ; *variable; ++variable)
        if (!std::string_view(*variable).starts_with("LD_PRELOAD="))
            surroundings.push_back(*variable);
    surroundings.push_back(nullptr);
    std::string name = program;
    char* words[] = {name.data(), nullptr};
    pid_t child = 0;
    if (posix_spawn(&child, name.c_str(), nullptr, nullptr, words, surroundings.data()) != 0)
        std::abort();
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR)
        ;
}

/// Whether this call shall fail; kills where that is the plan. `write` does half of the work before a `half`
/// kill.
template <typename Write>
bool failing(bool counted, Write write) {
    if (!counted)
        return false;
    const long call = ++plan().calls;
    if (call == plan().beside_at || call == plan().again_at)
        run_beside(plan().beside);
    if (plan().fault == Fault::none)
        return false;
    if (plan().fault == Fault::error && (plan().once ? call == plan().at : call >= plan().at)) {
        errno = plan().error;
        return true;
    }
    if (call == plan().at && plan().fault != Fault::error) {
        if (plan().fault == Fault::half)
            write();
        std::raise(SIGKILL);
    }
    return false;
}

template <typename Write>
bool broken(bool counted, Write write) {
    return !plan().only_bytes && failing(counted, write);
}

bool broken(bool counted) {
    return broken(counted, [] {});
}

/// The same of a call that only looks.
template <typename... Place>
bool unseen(Place... place) {
    return plan().reads && broken(counts(place...));
}

/// The same of one that reads bytes or lists a folder.
bool unreadable(int file) {
    return (plan().reads || plan().only_bytes) && failing(counts(file), [] {});
}

} // namespace

extern "C" {

void tp_count_calls_from_here() { plan().waits = false; }

ssize_t write(int file, const void* bytes, size_t count) {
    const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    return broken(counts(file), [&] { real(file, bytes, count / 2); }) ? -1 : real(file, bytes, count);
}

ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t place) {
    const auto real = next<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
    return broken(counts(file), [&] { real(file, bytes, count / 2, place); })
               ? -1
               : real(file, bytes, count, place);
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t place) {
    return pwrite64(file, bytes, count, place);
}

ssize_t writev(int file, const iovec* parts, int count) {
    const auto real = next<ssize_t (*)(int, const iovec*, int)>("writev");
    return broken(counts(file)) ? -1 : real(file, parts, count);
}

int fsync(int file) { return broken(counts(file)) ? -1 : next<int (*)(int)>("fsync")(file); }
int fdatasync(int file) { return broken(counts(file)) ? -1 : next<int (*)(int)>("fdatasync")(file); }
int ftruncate64(int file, off64_t size) {
    return broken(counts(file)) ? -1 : next<int (*)(int, off64_t)>("ftruncate64")(file, size);
}
int ftruncate(int file, off_t size) { return ftruncate64(file, size); }

int rename(const char* from, const char* to) {
    return broken(counts(to)) ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}
int renameat(int folder, const char* from, int other, const char* to) {
    return broken(counts(other, to))
               ? -1
               : next<int (*)(int, const char*, int, const char*)>("renameat")(folder, from, other, to);
}
int renameat2(int folder, const char* from, int other, const char* to, unsigned flags) {
    return broken(counts(other, to)) ? -1
                                     : next<int (*)(int, const char*, int, const char*, unsigned)>(
                                           "renameat2")(folder, from, other, to, flags);
}
int link(const char* from, const char* to) {
    return broken(counts(to)) ? -1 : next<int (*)(const char*, const char*)>("link")(from, to);
}
int linkat(int folder, const char* from, int other, const char* to, int flags) {
    return broken(counts(other, to)) ? -1
                                     : next<int (*)(int, const char*, int, const char*, int)>("linkat")(
                                           folder, from, other, to, flags);
}
int unlinkat(int folder, const char* path, int flags) {
    return broken(counts(folder, path))
               ? -1
               : next<int (*)(int, const char*, int)>("unlinkat")(folder, path, flags);
}
int mkdirat(int folder, const char* path, mode_t mode) {
    return broken(counts(folder, path))
               ? -1
               : next<int (*)(int, const char*, mode_t)>("mkdirat")(folder, path, mode);
}
int unlink(const char* path) {
    return broken(counts(path)) ? -1 : next<int (*)(const char*)>("unlink")(path);
}
int mkdir(const char* path, mode_t mode) {
    return broken(counts(path)) ? -1 : next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

#define TP_OPEN(name)                                                                                        \
    int name(const char* path, int flags, ...) {                                                             \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;                                      \
        va_end(rest);                                                                                        \
        return broken((plan().reads || (flags & O_CREAT)) && counts(path))                                   \
                   ? -1                                                                                      \
                   : next<int (*)(const char*, int, ...)>(#name)(path, flags, mode);                         \
    }
TP_OPEN(open)
TP_OPEN(open64)
#undef TP_OPEN

#define TP_OPENAT(name)                                                                                      \
    int name(int folder, const char* path, int flags, ...) {                                                 \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;                                      \
        va_end(rest);                                                                                        \
        return broken((plan().reads || (flags & O_CREAT)) && counts(folder, path))                           \
                   ? -1                                                                                      \
                   : next<int (*)(int, const char*, int, ...)>(#name)(folder, path, flags, mode);            \
    }
TP_OPENAT(openat)
TP_OPENAT(openat64)
#undef TP_OPENAT

/// By which openat2(2) is called, for which the C library has no function.
long syscall(long number, ...) {
    va_list rest;
    va_start(rest, number);
    long words[6];
    for (long& word : words)
        word = va_arg(rest, long);
    va_end(rest);
    if (number == SYS_openat2) {
        const auto* const path = reinterpret_cast<const char*>(words[1]);
        const auto* const how = reinterpret_cast<const open_how*>(words[2]);
        if (broken((plan().reads || (how->flags & O_CREAT) != 0) && counts(static_cast<int>(words[0]), path)))
            return -1;
    }
    return next<long (*)(long, ...)>("syscall")(number, words[0], words[1], words[2], words[3], words[4],
                                                words[5]);
}

FILE* fopen(const char* path, const char* how) {
    return unseen(path) ? nullptr : next<FILE* (*)(const char*, const char*)>("fopen")(path, how);
}
FILE* fopen64(const char* path, const char* how) {
    return unseen(path) ? nullptr : next<FILE* (*)(const char*, const char*)>("fopen64")(path, how);
}

ssize_t read(int file, void* bytes, size_t count) {
    return unreadable(file) ? -1 : next<ssize_t (*)(int, void*, size_t)>("read")(file, bytes, count);
}
ssize_t pread64(int file, void* bytes, size_t count, off64_t place) {
    return unreadable(file)
               ? -1
               : next<ssize_t (*)(int, void*, size_t, off64_t)>("pread64")(file, bytes, count, place);
}
ssize_t pread(int file, void* bytes, size_t count, off_t place) { return pread64(file, bytes, count, place); }

DIR* opendir(const char* path) {
    return unseen(path) ? nullptr : next<DIR* (*)(const char*)>("opendir")(path);
}
DIR* fdopendir(int folder) { return unseen(folder) ? nullptr : next<DIR* (*)(int)>("fdopendir")(folder); }
dirent64* readdir64(DIR* folder) {
    return unreadable(dirfd(folder)) ? nullptr : next<dirent64* (*)(DIR*)>("readdir64")(folder);
}
dirent* readdir(DIR* folder) {
    return unreadable(dirfd(folder)) ? nullptr : next<dirent* (*)(DIR*)>("readdir")(folder);
}

#define TP_STAT(name, about)                                                                                 \
    int name(const char* path, struct about* to) noexcept {                                                  \
        return unseen(path) ? -1 : next<int (*)(const char*, struct about*)>(#name)(path, to);               \
    }
TP_STAT(stat, stat)
TP_STAT(stat64, stat64)
TP_STAT(lstat, stat)
TP_STAT(lstat64, stat64)
#undef TP_STAT

#define TP_FSTAT(name, about)                                                                                \
    int name(int file, struct about* to) noexcept {                                                          \
        return unseen(file) ? -1 : next<int (*)(int, struct about*)>(#name)(file, to);                       \
    }
TP_FSTAT(fstat, stat)
TP_FSTAT(fstat64, stat64)
#undef TP_FSTAT

#define TP_FSTATAT(name, about)                                                                              \
    int name(int folder, const char* path, struct about* to, int flags) noexcept {                           \
        return unseen(folder, path)                                                                          \
                   ? -1                                                                                      \
                   : next<int (*)(int, const char*, struct about*, int)>(#name)(folder, path, to, flags);    \
    }
TP_FSTATAT(fstatat, stat)
TP_FSTATAT(fstatat64, stat64)
#undef TP_FSTATAT

int statx(int folder, const char* path, int flags, unsigned mask, struct statx* to) noexcept {
    return unseen(folder, path) ? -1
                                : next<int (*)(int, const char*, int, unsigned, struct statx*)>("statx")(
                                      folder, path, flags, mask, to);
}

} // extern "C"
