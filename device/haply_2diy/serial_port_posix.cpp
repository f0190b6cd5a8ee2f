// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/serial_port.hpp"
#include "device/open_problem.hpp"

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace tp {

namespace {

/// Bytes as they are, no echo, no signals, and no modem line that resets a board when the port is closed. The
/// rate means nothing on a USB port of its own; 1200 would send an Arduino into its boot loader.
bool make_raw(int descriptor) {
    termios settings{};
    const bool is_line = tcgetattr(descriptor, &settings) == 0;
    settings.c_iflag = 0;
    settings.c_oflag = 0;
    settings.c_lflag = 0;
    settings.c_cflag = CS8 | CREAD | CLOCAL;
    settings.c_cc[VMIN] = 1; // so that nothing yet (EAGAIN) and nothing ever (0) differ
    settings.c_cc[VTIME] = 0;
    return is_line && cfsetispeed(&settings, B115200) == 0 && cfsetospeed(&settings, B115200) == 0 &&
           tcsetattr(descriptor, TCSANOW, &settings) == 0;
}

bool ready(int descriptor, short for_what, int wait_ms) {
    pollfd line{descriptor, for_what, 0};
    return poll(&line, 1, wait_ms) > 0 && (line.revents & for_what) != 0;
}

class PosixSerialPort final : public SerialPort {
public:
    explicit PosixSerialPort(int descriptor) : descriptor_(descriptor) {}
    ~PosixSerialPort() override {
        ioctl(descriptor_, TIOCNXCL);
        ::close(descriptor_);
    }
    PosixSerialPort(const PosixSerialPort&) = delete;
    PosixSerialPort& operator=(const PosixSerialPort&) = delete;

    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override {
        if (wait_ms > 0)
            ready(descriptor_, POLLIN, wait_ms);
        const ssize_t got = ::read(descriptor_, into.data(), into.size());
        if (got > 0)
            return static_cast<int>(got);
        return got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
    }

    bool write(std::span<const std::uint8_t> bytes) noexcept override {
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

    SystemHandle handle() const override { return descriptor_; }

private:
    int descriptor_;
};

} // namespace

Result<std::unique_ptr<SerialPort>> open_serial_port(const std::string& path, const std::string& name) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        const OpenProblem problem = open_problem_of(errno);
        return Error{sentence(problem == OpenProblem::permission ? OpenProblem::serial_permission : problem,
                              this_system(), name)};
    }
    std::unique_ptr<SerialPort> port = std::make_unique<PosixSerialPort>(descriptor);
    if (ioctl(descriptor, TIOCEXCL) != 0 || !make_raw(descriptor))
        return Error{sentence(OpenProblem::other, this_system(), name)};
    tcflush(descriptor, TCIOFLUSH);
    return port;
}

} // namespace tp
