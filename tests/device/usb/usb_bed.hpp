// SPDX-License-Identifier: Apache-2.0
#pragma once

// GLib's header has a parameter of this name; hence also before Qt's headers.
#undef signals
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <linux/usbdevice_fs.h>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <sys/ioctl.h>
#include <thread>
#include <umockdev-1.0/umockdev.h>
#include <vector>

namespace tp::mock {

inline std::string hexadecimal(const std::uint8_t* bytes, std::size_t count) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += digits[bytes[i] >> 4];
        text += digits[bytes[i] & 0xF];
    }
    return text;
}

/// A device on the USB, made by umockdev: /sys tells of it, and the ioctls of its node in /dev/bus/usb are
/// answered here as the kernel answers them. What is behind its endpoints is for who derives from it.
class UsbBed {
public:
    /// What it does from now on.
    struct Behaviour {
        bool silent = false;        ///< takes what it is sent and sends nothing
        bool deaf = false;          ///< takes nothing
        bool other_device = false;  ///< sends what no such device sends
        bool odd_packets = false;   ///< a short, an empty and a long packet before each whole one
        bool busy = false;          ///< another program holds the interface
        bool kernel_driver = false; ///< a driver of the kernel holds it
        int stalls_in = 0;  ///< that many more halts of the pipe from the device, each at its next packet
        int stalls_out = 0; ///< and of the one to it, each at the next packet
        int errors_in = 0;  ///< that many more packets break on the way
    };
    struct Seen {
        long answered = 0; ///< packets of the device that the computer has got
        long odd = 0;      ///< packets of another length, or without anything, that it has got
        long taken = 0;    ///< packets that the device has got
        long given_up =
            0; ///< packets that the computer took back before the device had them: a busy machine is late
        long halts_cleared = 0;
        long detached = 0; ///< times the kernel's driver was sent away
        long attached = 0; ///< and called back
        long apart = 0;    ///< packets that came without a transfer of libusb's, as a guard writes them
        long claimed = 0;
        long released = 0;
    };

    UsbBed() : bed_(umockdev_testbed_new()) {
        usb_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(usb_, "handle-ioctl", G_CALLBACK(&UsbBed::answer_of), this);
        const std::vector<std::uint8_t> hub = {0x12, 1, 0, 2, 9, 0,  0, 64, 0x6B, 0x1D, 2,    0, 0, 6, 3,
                                               2,    1, 1, 9, 2, 25, 0, 1,  1,    0,    0xE0, 0, 9, 4, 0,
                                               0,    1, 9, 0, 0, 0,  7, 5,  0x81, 3,    4,    0, 12};
        add("P: /devices/pci0000:00/usb1\nN: bus/usb/001/001\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
            "E: DEVNAME=/dev/bus/usb/001/001\nE: BUSNUM=001\nE: DEVNUM=001\nA: busnum=1\\n\nA: devnum=1\\n\n"
            "A: speed=480\\n\nA: bConfigurationValue=1\\n\nA: idVendor=1d6b\\n\nA: idProduct=0002\\n\n"
            "H: descriptors=" +
            hexadecimal(hub.data(), hub.size()) + "\n\n");
    }
    virtual ~UsbBed() {
        g_object_unref(usb_);
        g_object_unref(bed_);
    }
    UsbBed(const UsbBed&) = delete;
    UsbBed& operator=(const UsbBed&) = delete;

    void unplug() {
        {
            const std::lock_guard lock(mutex_);
            gone_ = true;
            seen_.released += static_cast<long>(holders_.size()); // the kernel's own deed
            holders_.clear();
        }
        umockdev_testbed_uevent(bed_, "/sys/devices/pci0000:00/usb1/1-1", "remove");
    }
    /// Nothing in /sys tells of it any more, so that it can be plugged in again.
    void forget() {
        umockdev_testbed_detach_ioctl(bed_, node, nullptr);
        umockdev_testbed_remove_device(bed_, "/sys/devices/pci0000:00/usb1/1-1");
    }
    void behave(const Behaviour& behaviour) {
        const std::lock_guard lock(mutex_);
        behaviour_ = behaviour;
    }
    std::string root() const {
        char* const folder = umockdev_testbed_get_root_dir(bed_);
        std::string copy = folder;
        g_free(folder);
        return copy;
    }
    static constexpr const char* node = "/dev/bus/usb/001/002";

protected:
    /// Who it is, as /sys has it.
    struct Identity {
        const char* vendor;
        const char* product_number;
        const char* release;
        const char* manufacturer;
        const char* product;
        const char* serial;
        std::vector<std::uint8_t> descriptors;
    };
    /// `more` is added to what umockdev is told.
    bool appear(const Identity& who, const std::string& more = {}) {
        {
            const std::lock_guard lock(mutex_);
            gone_ = false;
        }
        const std::string text =
            std::string(
                "P: /devices/pci0000:00/usb1/1-1\nN: bus/usb/001/002\nE: SUBSYSTEM=usb\nE: "
                "DEVTYPE=usb_device\n"
                "E: DEVNAME=/dev/bus/usb/001/002\nE: BUSNUM=001\nE: DEVNUM=002\nE: MAJOR=189\nE: MINOR=1\n"
                "A: busnum=1\\n\nA: devnum=2\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\nA: idVendor=") +
            who.vendor + "\\n\nA: idProduct=" + who.product_number +
            "\\n\nA: manufacturer=" + who.manufacturer + "\\n\nA: product=" + who.product +
            "\\n\nA: serial=" + who.serial + "\\n\nA: bcdDevice=" + who.release +
            "\\n\nH: descriptors=" + hexadecimal(who.descriptors.data(), who.descriptors.size()) + "\n\n" +
            more;
        return add(text) && umockdev_testbed_attach_ioctl(bed_, node, usb_, nullptr) != FALSE;
    }
    UMockdevTestbed* bed() const { return bed_; }

    // What the device does; the mutex is held.
    /// A packet came from the computer.
    virtual void hear(std::span<const std::uint8_t> packet) = 0;
    /// A control request without data came from the computer.
    virtual void obey(std::uint8_t, std::uint8_t, std::uint16_t) {}
    /// The computer asks whether there is anything new.
    virtual void go_on() {}
    virtual bool is_answer(const std::vector<std::uint8_t>& packet) const = 0;

    std::mutex mutex_;                              ///< of what follows
    std::deque<std::vector<std::uint8_t>> packets_; ///< that the device has to send
    Behaviour behaviour_;
    Seen seen_;

private:
    /// A transfer between its submission and its collection.
    struct Transfer {
        UMockdevIoctlData* urb;
        UMockdevIoctlData* buffer;
        bool done = false;
        int status = 0;
        int length = 0;

        usbdevfs_urb& fields() const { return *reinterpret_cast<usbdevfs_urb*>(urb->data); }
        bool inward() const { return (fields().endpoint & 0x80) != 0; }
        void finish(int result, int count) {
            done = true;
            status = result;
            length = count;
        }
    };

    bool add(const std::string& description) {
        return umockdev_testbed_add_from_string(bed_, description.c_str(), nullptr) != FALSE;
    }

    /// Changes what the computer's program sees there.
    static void update(UMockdevIoctlData* data, std::size_t offset, const void* bytes, std::size_t count) {
        std::vector<guint8> copy(count); // umockdev takes what it copies as something it might change
        std::memcpy(copy.data(), bytes, count);
        umockdev_ioctl_data_update(data, offset, copy.data(), static_cast<gint>(count));
    }

    static gboolean answer_of(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        return static_cast<UsbBed*>(self)->answer(client);
    }

    gboolean answer(UMockdevIoctlClient* client) {
        const gulong request = umockdev_ioctl_client_get_request(client);
        if (_IOC_TYPE(request) != 'U')
            return FALSE;
        UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
        UMockdevIoctlData* data = nullptr;
        if (_IOC_SIZE(request) > 0 && request != USBDEVFS_DISCARDURB) {
            data = umockdev_ioctl_data_resolve(argument, 0, static_cast<gsize>(_IOC_SIZE(request)), nullptr);
            if (data == nullptr) {
                umockdev_ioctl_client_complete(client, -1, EFAULT);
                return TRUE;
            }
        }
        int error = 0;
        int result = 0;
        {
            const std::lock_guard lock(mutex_);
            error =
                request == USBDEVFS_BULK ? take_apart(data, result) : handle(client, request, argument, data);
        }
        if (error == EAGAIN) // the node of a mocked device is always ready: without a rest libusb would spin
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        if (data != nullptr && !(request == USBDEVFS_SUBMITURB && error == 0))
            umockdev_ioctl_data_unref(data);
        umockdev_ioctl_client_complete(client, error == 0 ? result : -1, error);
        return TRUE;
    }

    /// 0 or an errno.
    int handle(UMockdevIoctlClient* client, gulong request, UMockdevIoctlData* argument,
               UMockdevIoctlData* data) {
        if (request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY)
            return collect(data);
        if (gone_)
            return ENODEV;
        switch (request) {
        case USBDEVFS_GET_CAPABILITIES: {
            const std::uint32_t can = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                      USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
            update(data, 0, &can, sizeof can);
            return 0;
        }
        case USBDEVFS_DISCONNECT_CLAIM:
            if (behaviour_.busy)
                return EBUSY;
            if (behaviour_.kernel_driver)
                ++seen_.detached;
            behaviour_.kernel_driver = false;
            return claim(client);
        case USBDEVFS_CLAIMINTERFACE:
            if (behaviour_.busy || behaviour_.kernel_driver)
                return EBUSY;
            return claim(client);
        case USBDEVFS_RELEASEINTERFACE:
            if (holders_.erase(client) == 0)
                return EINVAL; // of one that was unplugged, where another is plugged in now
            ++seen_.released;
            return 0;
        case USBDEVFS_IOCTL:
            if (reinterpret_cast<usbdevfs_ioctl*>(data->data)->ioctl_code ==
                static_cast<int>(USBDEVFS_CONNECT))
                ++seen_.attached;
            return 0;
        case USBDEVFS_CLEAR_HALT: {
            unsigned endpoint = 0;
            std::memcpy(&endpoint, data->data, sizeof endpoint);
            ((endpoint & 0x80) != 0 ? halted_in_ : halted_out_) = false;
            ++seen_.halts_cleared;
            return 0;
        }
        case USBDEVFS_SUBMITURB:
            return submit(data);
        case USBDEVFS_DISCARDURB: {
            gulong address = 0;
            std::memcpy(&address, argument->data, sizeof address);
            for (Transfer& one : transfers_)
                if (one.urb->client_addr == address && !one.done) {
                    one.finish(-ENOENT, 0);
                    seen_.given_up += one.inward() ? 0 : 1;
                    return 0;
                }
            return EINVAL;
        }
        default:
            return ENOTTY;
        }
    }

    /// 0, with the bytes that were taken, or an errno.
    int take_apart(UMockdevIoctlData* data, int& taken) {
        if (gone_)
            return ENODEV;
        if (behaviour_.deaf)
            return ETIMEDOUT;
        const auto length = reinterpret_cast<usbdevfs_bulktransfer*>(data->data)->len;
        UMockdevIoctlData* const bytes =
            umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_bulktransfer, data), length, nullptr);
        if (bytes == nullptr)
            return EFAULT;
        hear({reinterpret_cast<const std::uint8_t*>(bytes->data), length});
        umockdev_ioctl_data_unref(bytes);
        ++seen_.apart;
        taken = static_cast<int>(length);
        return 0;
    }

    int claim(UMockdevIoctlClient* client) {
        holders_.insert(client);
        ++seen_.claimed;
        return 0;
    }

    int submit(UMockdevIoctlData* urb) {
        const auto length = reinterpret_cast<usbdevfs_urb*>(urb->data)->buffer_length;
        UMockdevIoctlData* const buffer = umockdev_ioctl_data_resolve(urb, offsetof(usbdevfs_urb, buffer),
                                                                      static_cast<gsize>(length), nullptr);
        if (buffer == nullptr)
            return EFAULT;
        transfers_.push_back({urb, buffer});
        return 0;
    }

    void take(Transfer& out) {
        if (behaviour_.stalls_out > 0) {
            --behaviour_.stalls_out;
            halted_out_ = true;
        }
        if (halted_out_)
            return out.finish(-EPIPE, 0);
        const int length = out.fields().buffer_length;
        out.finish(0, length);
        ++seen_.taken;
        hear({reinterpret_cast<const std::uint8_t*>(out.buffer->data), static_cast<std::size_t>(length)});
    }

    void take_control(Transfer& request) {
        const auto* setup = reinterpret_cast<const std::uint8_t*>(request.buffer->data);
        obey(setup[0], setup[1], static_cast<std::uint16_t>(setup[2] | (setup[3] << 8)));
        request.finish(0, 0);
    }

    void fill(Transfer& in) {
        if (halted_in_)
            return;
        if (behaviour_.errors_in > 0) {
            --behaviour_.errors_in;
            return in.finish(-EPROTO, 0);
        }
        if (packets_.empty())
            return;
        if (behaviour_.stalls_in > 0) {
            --behaviour_.stalls_in;
            halted_in_ = true;
            return in.finish(-EPIPE, 0);
        }
        const std::vector<std::uint8_t>& packet = packets_.front();
        if (!packet.empty())
            update(in.buffer, 0, packet.data(), packet.size());
        in.finish(0, static_cast<int>(packet.size()));
        ++(is_answer(packet) ? seen_.answered : seen_.odd);
        packets_.pop_front();
    }

    int collect(UMockdevIoctlData* into) {
        if (!gone_)
            go_on();
        for (Transfer& one : transfers_)
            if (gone_ && !one.done)
                one.finish(-ESHUTDOWN, 0);
            else if (!one.done && one.fields().type == USBDEVFS_URB_TYPE_CONTROL && !behaviour_.deaf)
                take_control(one);
            else if (!one.done && one.inward())
                fill(one);
            else if (!one.done && !behaviour_.deaf)
                take(one);
        for (auto one = transfers_.begin(); one != transfers_.end(); ++one) {
            if (!one->done)
                continue;
            update(one->urb, offsetof(usbdevfs_urb, status), &one->status, sizeof one->status);
            update(one->urb, offsetof(usbdevfs_urb, actual_length), &one->length, sizeof one->length);
            umockdev_ioctl_data_set_ptr(into, 0, one->urb);
            umockdev_ioctl_data_unref(one->buffer);
            umockdev_ioctl_data_unref(one->urb);
            transfers_.erase(one);
            return 0;
        }
        return gone_ ? ENODEV : EAGAIN;
    }

    UMockdevTestbed* bed_;
    UMockdevIoctlBase* usb_ = nullptr;
    std::deque<Transfer> transfers_;
    std::set<const UMockdevIoctlClient*> holders_; ///< opened it and claimed its interface
    bool halted_in_ = false;
    bool halted_out_ = false;
    bool gone_ = false;
};

} // namespace tp::mock
