// SPDX-License-Identifier: Apache-2.0
// Preloaded into a guard before umockdev, which answers the ioctls only of what a process has opened itself:
// what the guard asks of the descriptor that it inherited is asked of its node, opened anew.
#include <cstdarg>
#include <dlfcn.h>
#include <fcntl.h>

extern "C" int ioctl(int descriptor, unsigned long request, ...) noexcept {
    constexpr int inherited = 3;
    va_list arguments;
    va_start(arguments, request);
    void* const argument = va_arg(arguments, void*);
    va_end(arguments);
    static const auto next = reinterpret_cast<int (*)(int, unsigned long, ...)>(dlsym(RTLD_NEXT, "ioctl"));
    static const int node = open("/dev/bus/usb/001/002", O_RDWR | O_CLOEXEC);
    return next(descriptor == inherited ? node : descriptor, request, argument);
}
