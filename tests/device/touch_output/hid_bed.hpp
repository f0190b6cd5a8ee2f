// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../force_pad/mock_hidraw.hpp"
#include "../mocked_node.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tp::mock {

/// A HID device made by umockdev: its /sys and /dev are those of one, once plugged in. Feature reports are answered on a thread of
/// umockdev's; input reports come when the test says so. The node is a pseudo-terminal, which keeps no borders of reports.
class HidBed {
public:
    using Bytes = std::vector<std::uint8_t>;
    struct Answers {
        std::function<bool(std::span<const std::uint8_t>)> set_feature = [](auto) { return false; };
        std::function<Bytes(std::uint8_t)> get_feature = [](auto) { return Bytes{}; }; ///< empty: refused
    };

    HidBed(const HidrawDevice& shown, Answers answers)
        : shown_(shown), answers_(std::move(answers)), bed_(umockdev_testbed_new()) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(&HidBed::answer_of), this);
    }
    ~HidBed() {
        if (file_ >= 0)
            ::close(file_);
        g_object_unref(ioctls_);
        g_object_unref(bed_);
    }
    HidBed(const HidBed&) = delete;
    HidBed& operator=(const HidBed&) = delete;

    bool plug_in() {
        const std::string description = usb_description(shown_) + hidraw_description(shown_);
        file_ = plugged_in(bed_, description, hidraw_node, ioctls_);
        return file_ >= 0;
    }
    void unplug() {
        umockdev_testbed_uevent(bed_, hidraw_sys_path, "remove");
        ::close(std::exchange(file_, -1));
    }
    /// An input report.
    bool say(std::span<const std::uint8_t> report) const {
        return ::write(file_, report.data(), report.size()) == static_cast<ssize_t>(report.size());
    }
    /// Waits for so many bytes of output reports.
    Bytes hear(std::size_t count) const {
        Bytes heard(count);
        for (std::size_t at = 0; at < count;) {
            const ssize_t got = ::read(file_, heard.data() + at, count - at);
            if (got < 0)
                return {};
            at += static_cast<std::size_t>(got);
        }
        return heard;
    }
    std::string root() const {
        char* folder = umockdev_testbed_get_root_dir(bed_);
        std::string copy = folder;
        g_free(folder);
        return copy;
    }

private:
    static gboolean answer_of(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        return static_cast<HidBed*>(self)->answer(client);
    }
    gboolean answer(UMockdevIoctlClient* client) {
        return answer_hid_class(client, [this](gulong request, std::span<std::uint8_t> data) {
            constexpr unsigned set_feature = 0x06;
            constexpr unsigned get_feature = 0x07;
            if (_IOC_NR(request) == set_feature)
                return answers_.set_feature(data) ? static_cast<int>(data.size()) : -1;
            if (_IOC_NR(request) != get_feature)
                return descriptor_answer(request, data, shown_.descriptor);
            const Bytes told = answers_.get_feature(data[0]);
            const std::size_t count = std::min(told.size(), data.size());
            std::copy_n(told.begin(), count, data.begin());
            return count > 0 ? static_cast<int>(count) : -1;
        });
    }

    HidrawDevice shown_;
    Answers answers_;
    UMockdevTestbed* bed_;
    UMockdevIoctlBase* ioctls_ = nullptr;
    int file_ = -1;
};

} // namespace tp::mock
