// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "force_pad/mock_hidraw.hpp"
#include "mocked_node.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <poll.h>
#include <span>
#include <string>
#include <thread>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tp::mock {

/// A HID device made by umockdev: its /sys and /dev are those of one, once plugged in. Its node is a pseudo-terminal, which keeps
/// no borders of reports; questions about it are answered on a thread of umockdev's.
class HidNode {
public:
    /// What the system call returns for a question of the HID class, with its data; negative for no answer.
    using Answer = std::function<int(gulong request, std::span<std::uint8_t> data)>;

    /// Without `answer` it answers what any node does.
    explicit HidNode(const HidrawDevice& shown = {}, Answer answer = {})
        : shown_(shown), answer_(std::move(answer)), bed_(umockdev_testbed_new()) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(&HidNode::answer_of), this);
    }
    ~HidNode() {
        if (file_ >= 0)
            ::close(file_);
        g_object_unref(ioctls_);
        g_object_unref(bed_);
    }
    HidNode(const HidNode&) = delete;
    HidNode& operator=(const HidNode&) = delete;

    bool plug_in() {
        file_ = plugged_in(bed_, usb_description(shown_) + hidraw_description(shown_), hidraw_node, ioctls_);
        return file_ >= 0;
    }
    std::string root() const {
        char* folder = umockdev_testbed_get_root_dir(bed_);
        std::string copy = folder;
        g_free(folder);
        return copy;
    }

protected:
    void vanish() {
        umockdev_testbed_uevent(bed_, hidraw_sys_path, "remove");
        ::close(std::exchange(file_, -1));
    }
    /// The device's end of the node; below 0 where it is not plugged in.
    int file() const { return file_; }
    int usual_answer(gulong request, std::span<std::uint8_t> data) const {
        return descriptor_answer(request, data, shown_.descriptor);
    }

private:
    static gboolean answer_of(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        const HidNode& node = *static_cast<const HidNode*>(self);
        return answer_hid_class(client, [&node](gulong request, std::span<std::uint8_t> data) {
            return node.answer_ ? node.answer_(request, data) : node.usual_answer(request, data);
        });
    }

    HidrawDevice shown_;
    const Answer answer_;
    UMockdevTestbed* bed_;
    UMockdevIoctlBase* ioctls_ = nullptr;
    int file_ = -1;
};

/// The same with a thread behind its node that takes what the computer writes.
class ListeningNode : public HidNode {
public:
    using HidNode::HidNode;
    virtual ~ListeningNode() = default;

    bool plug_in() {
        if (!HidNode::plug_in())
            return false;
        device_ = std::thread([this] { listen(); });
        return true;
    }
    void unplug() { unplug_.store(true); }
    /// Nobody has its node open.
    bool hung_up() const { return hung_up_.load(); }

protected:
    /// Ends the thread: the first thing that whoever derives from this does in its destructor.
    void end() {
        quit_.store(true);
        if (device_.joinable())
            device_.join();
    }
    bool ends() const { return quit_.load(); }
    /// Bytes of an output report with its id, which is its first.
    virtual std::size_t report_bytes(std::uint8_t id) const = 0;
    virtual void take(const std::vector<std::uint8_t>& report) = 0;

private:
    void listen() {
        std::vector<std::uint8_t> waiting;
        while (!ends()) {
            if (unplug_.load()) {
                vanish();
                return;
            }
            pollfd ready{file(), POLLIN, 0};
            if (::poll(&ready, 1, 5) <= 0)
                continue;
            std::uint8_t bytes[4096];
            const ssize_t count = ::read(file(), bytes, sizeof bytes);
            hung_up_.store(count <= 0);
            if (count <= 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            waiting.insert(waiting.end(), bytes, bytes + count);
            while (!waiting.empty() && waiting.size() >= report_bytes(waiting[0])) {
                const auto size = static_cast<std::ptrdiff_t>(report_bytes(waiting[0]));
                take({waiting.begin(), waiting.begin() + size});
                waiting.erase(waiting.begin(), waiting.begin() + size);
            }
        }
    }

    std::thread device_;
    std::atomic<bool> quit_{false};
    std::atomic<bool> unplug_{false};
    std::atomic<bool> hung_up_{false};
};

} // namespace tp::mock
