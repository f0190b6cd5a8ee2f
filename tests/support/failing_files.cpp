// SPDX-License-Identifier: Apache-2.0
// A library to be preloaded: the program's own way to the disk, counted, and one call of it broken.
//
// TP_FAULT=kill@N    the process is killed just before the N-th call that changes a file
// TP_FAULT=half@N    half of the bytes of the N-th call are written if it is a write, then the process is
// killed TP_FAULT=ENOSPC@N  that call and all later ones fail so (also EIO, EROFS); writes that make nothing
// new succeed TP_FAULT_COUNT=FILE  the number of calls is written there when the program ends
// TP_FAULT_BELOW=DIR only files below it count
#include "named_place.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

enum class Fault { none, kill, half, error };

struct Plan {
    Fault fault = Fault::none;
    int error = 0;
    long at = 0;
    std::string below;
    std::atomic<long> calls{0};

    Plan() {
        if (const char* folder = std::getenv("TP_FAULT_BELOW"))
            below = folder;
        const char* text = std::getenv("TP_FAULT");
        const char* place = text ? std::strchr(text, '@') : nullptr;
        if (!place)
            return;
        const std::string kind(text, place);
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
    char link[64], path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = readlink(link, path, sizeof path - 1);
    if (length <= 0)
        return false;
    path[length] = '\0';
    return path[0] == '/' && counts(path);
}

/// Whether this call shall fail; kills where that is the plan. `write` does half of the work before a `half`
/// kill.
template <typename Write>
bool broken(bool counted, Write write) {
    if (!counted || plan().fault == Fault::none) {
        if (counted)
            ++plan().calls;
        return false;
    }
    const long call = ++plan().calls;
    if (plan().fault == Fault::error && call >= plan().at) {
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

bool broken(bool counted) {
    return broken(counted, [] {});
}

} // namespace

extern "C" {

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
        return broken((flags & O_CREAT) && counts(path))                                                     \
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
        return broken((flags & O_CREAT) && counts(folder, path))                                             \
                   ? -1                                                                                      \
                   : next<int (*)(int, const char*, int, ...)>(#name)(folder, path, flags, mode);            \
    }
TP_OPENAT(openat)
TP_OPENAT(openat64)
#undef TP_OPENAT

} // extern "C"
