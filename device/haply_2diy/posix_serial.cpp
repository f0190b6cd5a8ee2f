// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/posix_serial.hpp"

#include "device/open_problem.hpp"

#if defined(__unix__) || defined(__APPLE__)
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace tp {

#if defined(__unix__) || defined(__APPLE__)

namespace {

/// Bytes as they are, no echo, no signals, and no modem line that resets a board when the port is closed. The
/// rate means nothing on a USB port of its own; 1200 would send an Arduino into its boot loader.
bool make_raw(int descriptor) {
    termios settings{};
    if (tcgetattr(descriptor, &settings) != 0)
        return false;
    settings.c_iflag = 0;
    settings.c_oflag = 0;
    settings.c_lflag = 0;
    settings.c_cflag = CS8 | CREAD | CLOCAL;
    settings.c_cc[VMIN] = 1; // so that nothing yet (EAGAIN) and nothing ever (0) differ
    settings.c_cc[VTIME] = 0;
    return cfsetispeed(&settings, B115200) == 0 && cfsetospeed(&settings, B115200) == 0 &&
           tcsetattr(descriptor, TCSANOW, &settings) == 0;
}

bool ready(int descriptor, short for_what, int wait_ms) {
    pollfd line{descriptor, for_what, 0};
    return poll(&line, 1, wait_ms) > 0 && (line.revents & for_what) != 0;
}

} // namespace

Result<std::unique_ptr<PosixSerial>> PosixSerial::open(const std::string& path, const std::string& name) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        const OpenProblem problem = open_problem_of(errno);
        return Error{sentence(problem == OpenProblem::permission ? OpenProblem::serial_permission : problem,
                              this_system(), name)};
    }
    std::unique_ptr<PosixSerial> made(new PosixSerial(descriptor));
    if (ioctl(descriptor, TIOCEXCL) != 0 || !make_raw(descriptor))
        return Error{sentence(OpenProblem::other, this_system(), name)};
    tcflush(descriptor, TCIOFLUSH);
    return made;
}

PosixSerial::~PosixSerial() {
    ioctl(descriptor_, TIOCNXCL);
    ::close(descriptor_);
}

int PosixSerial::read(std::span<std::uint8_t> into, int wait_ms) noexcept {
    if (wait_ms > 0)
        ready(descriptor_, POLLIN, wait_ms);
    const ssize_t got = ::read(descriptor_, into.data(), into.size());
    if (got > 0)
        return static_cast<int>(got);
    return got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

bool PosixSerial::write(std::span<const std::uint8_t> bytes) noexcept {
    constexpr int patience_ms = 1000;
    while (!bytes.empty()) {
        const ssize_t gone = ::write(descriptor_, bytes.data(), bytes.size());
        if (gone > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(gone));
        else if (gone < 0 && errno == EAGAIN) {
            if (!ready(descriptor_, POLLOUT, patience_ms))
                return false;
        } else if (gone < 0 && errno != EINTR)
            return false;
    }
    return true;
}

#else

Result<std::unique_ptr<PosixSerial>> PosixSerial::open(const std::string&, const std::string& name) {
    return Error{"The " + name +
                 " cannot be used on this system yet: nothing would watch over its motors here."};
}
PosixSerial::~PosixSerial() = default;
int PosixSerial::read(std::span<std::uint8_t>, int) noexcept { return -1; }
bool PosixSerial::write(std::span<const std::uint8_t>) noexcept { return false; }

#endif

} // namespace tp
