// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/hid_pid_transport.hpp"

#include "core/files/open_file.hpp"
#include "device/guard/guard_process.hpp"
#include "device/hid/hidraw_descriptor.hpp"
#include "device/hid/report_descriptor.hpp"
#include "device/hid_handles.hpp"
#include "device/hid_pid/pid_layout.hpp"
#include "device/open_problem.hpp"

#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <hidapi.h>
#include <string_view>
#include <thread>
#include <utility>

namespace tp {

namespace {

/// The device's node opened once more, for what must be done without hidapi.
class Node {
public:
    explicit Node(const std::string& path) : file_(path, {.write = true}) {}

    void write(const hid::Report& report) noexcept { // nothing more can be done from where this is called
        if (file_.ok())
            file_.write({reinterpret_cast<const char*>(report.bytes.data()), report.size});
    }

    /// The guard is started with the node, which is locked for as long as either has it. False where another
    /// guard has it: it takes no longer than this to leave a stick whose program is gone.
    bool lock() const noexcept {
        constexpr int tries = 50;
        for (int i = 0; i < tries; ++i) {
            if (!file_.ok() || file_.lock() || errno != EWOULDBLOCK)
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
    /// −1 where there is none.
    int descriptor() const noexcept { return file_.number(); }

private:
    OpenFile file_;
};

void append_words(std::vector<std::string>& words, std::span<const hid::Report> reports) {
    for (const hid::Report& report : reports)
        words.push_back(guard_word(report.all()));
}

class HidPidTransport final : public PidTransport {
public:
    HidPidTransport(HidHandles handles, const std::string& path, Node node, const std::string& guard_program)
        : handles_(std::move(handles)), path_(path), node_(std::move(node)), guard_program_(guard_program) {}

    std::vector<std::uint8_t> descriptor() override { return hid::hidraw_descriptor(path_); }

    Got read(hid::Report& report, int wait_ms) noexcept override {
        const int count =
            hid_read_timeout(handles_.reader.get(), report.bytes.data(), report.bytes.size(), wait_ms);
        if (count <= 0)
            return count < 0 ? Got::lost : Got::nothing;
        report.size = static_cast<std::size_t>(count);
        return Got::report;
    }

    Got input_now(hid::Report& report) noexcept override {
        const bool numbered = report.bytes[0] != 0;
        const int count = hid_get_input_report(handles_.reader.get(), report.bytes.data(), report.size);
        if (count <= 0)
            return Got::nothing;
        report.size = static_cast<std::size_t>(count);
        if (!numbered) { // as reports that come by themselves
            for (std::size_t i = 1; i < report.size; ++i)
                report.bytes[i - 1] = report.bytes[i];
            --report.size;
        }
        return Got::report;
    }

    bool write(const hid::Report& report) noexcept override {
        return hid_write(handles_.writer(), report.bytes.data(), report.size) >= 0;
    }

    void write_from_signal(const hid::Report& report) noexcept override { node_.write(report); }

    bool set_feature(const hid::Report& report) noexcept override {
        return hid_send_feature_report(handles_.writer(), report.bytes.data(), report.size) >= 0;
    }

    bool get_feature(hid::Report& report) noexcept override {
        const int count = hid_get_feature_report(handles_.writer(), report.bytes.data(), report.size);
        if (count <= 0)
            return false;
        report.size = static_cast<std::size_t>(count);
        return true;
    }

    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report> no_force,
                                              std::span<const hid::Report> at_the_end) override {
        std::vector<std::string> words{"reports"};
        append_words(words, no_force);
        words.emplace_back("then");
        append_words(words, at_the_end);
        return start_force_guard(guard_program_, node_.descriptor(), words);
    }

private:
    HidHandles handles_;
    std::string path_;
    Node node_;
    std::string guard_program_;
};

} // namespace

std::vector<FoundJoystick> find_joysticks() {
    std::vector<FoundJoystick> found;
    hid_device_info* const all = hid_enumerate(0, 0);
    for (const hid_device_info* one = all; one != nullptr; one = one->next) {
        // hidapi lists a node once for each of its collections.
        if (!found.empty() && found.back().path == one->path)
            continue;
        hid::ReportDescriptor descriptor;
        if (hid::parse_report_descriptor(hid::hidraw_descriptor(one->path), descriptor) ==
                hid::DescriptorFault::none &&
            hid::has_constant_force(descriptor))
            found.push_back(
                {one->path, plain_hid_text(one->serial_number), plain_hid_text(one->product_string)});
    }
    hid_free_enumeration(all);
    return found;
}

Result<std::unique_ptr<PidTransport>> open_joystick(const FoundJoystick& stick,
                                                    const std::string& guard_program) {
    Result<HidHandles> handles = open_hid_handles(stick.path, "force stick");
    if (!handles.ok())
        return Error{handles.error()};
    Node node(stick.path);
    if (!node.lock())
        return Error{sentence(OpenProblem::busy, this_system(), "force stick")};
    return std::unique_ptr<PidTransport>(std::make_unique<HidPidTransport>(
        std::move(handles).value(), stick.path, std::move(node), guard_program));
}

} // namespace tp
