// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/hid_transport.hpp"

#include "device/force_pad/protocol/usb.hpp"
#include "device/open_problem.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <hidapi.h>
#include <utility>

#if defined(__unix__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace tp {

namespace {

struct CloseHid {
    void operator()(hid_device* device) const { hid_close(device); }
};
using HidHandle = std::unique_ptr<hid_device, CloseHid>;

/// hidapi keeps the words of the last error in the handle, so that two threads must not share one: reports
/// are read through one handle and written through another where the system opens a device twice.
class HidTransport final : public ReportTransport {
public:
    HidTransport(HidHandle reader, HidHandle writer)
        : reader_(std::move(reader)), writer_(std::move(writer)) {}

    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        std::array<std::uint8_t, 64> bytes{};
        const int count = hid_read_timeout(reader_.get(), bytes.data(), pad::frame_size, wait_ms);
        if (count < 0)
            return Got::lost;
        if (count == 0)
            return Got::nothing;
        if (static_cast<std::size_t>(count) != pad::frame_size)
            return Got::odd;
        std::copy_n(bytes.begin(), pad::frame_size, frame.bytes);
        return Got::report;
    }

    bool write(const pad::Frame& frame) noexcept override {
        std::array<std::uint8_t, 1 + pad::frame_size> bytes{}; // report id 0 leads
        std::copy_n(frame.bytes, pad::frame_size, bytes.begin() + 1);
        return hid_write(writer_ ? writer_.get() : reader_.get(), bytes.data(), bytes.size()) >= 0;
    }

private:
    HidHandle reader_;
    HidHandle writer_; ///< nothing where the system opens a device only once
};

std::string plain(const wchar_t* text) {
    std::string plain_text;
    for (; text != nullptr && *text != 0; ++text)
        plain_text += *text > 0x1F && *text < 0x7F ? static_cast<char>(*text) : '?';
    return plain_text;
}

/// hidapi says what went wrong only in the system's own words; opening the file once more tells the cause.
OpenProblem why_not([[maybe_unused]] const std::string& path) {
#if defined(__unix__)
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0)
        return open_problem_of(errno);
    ::close(file);
    return OpenProblem::wrong_driver; // a file that opens and is no hidraw device
#else
    return OpenProblem::other;
#endif
}

} // namespace

std::vector<FoundPad> find_hid() {
    std::vector<FoundPad> found;
    hid_device_info* const all = hid_enumerate(pad::usb_vendor, pad::usb_product);
    for (const hid_device_info* one = all; one != nullptr; one = one->next)
        // A back end of hidapi that cannot tell the usage page says 0.
        if (one->usage_page == pad::usage_page || one->usage_page == 0)
            found.push_back({one->path, plain(one->serial_number), plain(one->product_string)});
    hid_free_enumeration(all);
    return found;
}

Result<std::unique_ptr<ReportTransport>> open_hid(const FoundPad& pad) {
    HidHandle reader(hid_open_path(pad.path.c_str()));
    if (!reader)
        return Error{sentence(why_not(pad.path), this_system(), "force pad")};
    HidHandle writer(hid_open_path(pad.path.c_str()));
    return std::unique_ptr<ReportTransport>(
        std::make_unique<HidTransport>(std::move(reader), std::move(writer)));
}

} // namespace tp
