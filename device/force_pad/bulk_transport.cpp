// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/bulk_transport.hpp"

#include "device/force_pad/protocol/usb.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <libusb.h>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace tp {

namespace {

constexpr unsigned write_timeout_ms = 100; ///< no pad's watchdog waits as long: what is older is of no use
constexpr int errors_of_a_dead_line =
    64; ///< in a row; an unplugged cable gives some before it is known to be
constexpr std::size_t packets_asked_for = 8; ///< at a time: that many may come before we ask again
constexpr std::size_t most_waiting = 64;     ///< packets that nobody has read yet; the oldest gives way
constexpr std::chrono::milliseconds housekeeping{50};

struct ExitUsb {
    void operator()(libusb_context* context) const { libusb_exit(context); }
};
struct CloseUsb {
    void operator()(libusb_device_handle* device) const { libusb_close(device); }
};
struct ForgetUsb {
    void operator()(libusb_device* device) const { libusb_unref_device(device); }
};
struct FreeTransfer {
    void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
};
using UsbContext = std::unique_ptr<libusb_context, ExitUsb>;
using UsbHandle = std::unique_ptr<libusb_device_handle, CloseUsb>;
using UsbDevice = std::unique_ptr<libusb_device, ForgetUsb>;
using UsbTransfer = std::unique_ptr<libusb_transfer, FreeTransfer>;

UsbContext usb_context() {
    libusb_context* context = nullptr;
    return UsbContext(libusb_init(&context) == 0 ? context : nullptr);
}

/// Packets in, by transfers that wait in the system and come back in a thread of its own; packets out, one
/// after the other, each awaited by the thread that writes. libusb's calls that wait are not used: they would
/// have the writer handle the events of what comes in.
class BulkTransport final : public ReportTransport {
public:
    /// The handle holds the interface.
    BulkTransport(UsbContext context, UsbHandle handle, int interface)
        : context_(std::move(context)), handle_(std::move(handle)), interface_(interface) {}

    /// False where the system gives no memory or the device is gone already.
    bool begin() {
        const int packet = libusb_get_max_packet_size(libusb_get_device(handle_.get()), pad::bulk_in);
        if (packet < static_cast<int>(pad::frame_size))
            return false;
        for (Request& request : requests_) {
            // One packet each: a packet that fills its endpoint would not end a longer transfer.
            if (!prepare(request, pad::bulk_in, static_cast<std::size_t>(packet), &BulkTransport::came_back,
                         0))
                return false;
        }
        if (!prepare(sending_, pad::bulk_out, pad::frame_size, &BulkTransport::went_out, write_timeout_ms))
            return false;
        ask_for_packets();
        thread_ = std::thread([this] { take_in(); });
        return !lost_.load();
    }

    ~BulkTransport() override {
        closing_.store(true);
        if (thread_.joinable()) {
            libusb_interrupt_event_handler(context_.get());
            thread_.join();
        }
        // And gives it back to the driver it was taken from.
        libusb_release_interface(handle_.get(), interface_);
    }
    BulkTransport(const BulkTransport&) = delete;
    BulkTransport& operator=(const BulkTransport&) = delete;

    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        std::unique_lock lock(mutex_, std::defer_lock);
        if (wait_ms == 0) {
            if (!lock.try_lock()) // a packet is being put in: it is there the next time
                return Got::nothing;
        } else {
            lock.lock();
            arrived_.wait_for(lock, std::chrono::milliseconds(wait_ms),
                              [this] { return waiting_ > 0 || lost_.load(); });
        }
        if (waiting_ == 0)
            return lost_.load() ? Got::lost : Got::nothing;
        const Packet& packet = packets_[oldest_];
        frame = packet.frame;
        const bool odd = packet.odd;
        oldest_ = (oldest_ + 1) % most_waiting;
        --waiting_;
        return odd ? Got::odd : Got::report;
    }

    bool write(const pad::Frame& frame) noexcept override {
        std::unique_lock lock(mutex_);
        if (ended_)
            return false;
        std::copy_n(frame.bytes, pad::frame_size, sending_.bytes.begin());
        on_the_way_ = true;
        lock.unlock();
        const int error = libusb_submit_transfer(sending_.transfer.get());
        lock.lock();
        if (error != 0)
            on_the_way_ = false;
        sent_.wait(lock, [this] { return !on_the_way_; }); // libusb gives up after the timeout
        lock.unlock();
        if (error == LIBUSB_ERROR_NO_DEVICE)
            lose();
        else if (error != 0)
            ++write_errors_;
        else
            judge_sent();
        if (write_errors_ >= errors_of_a_dead_line)
            lose();
        return !lost_.load();
    }

private:
    struct Request {
        UsbTransfer transfer;
        std::vector<std::uint8_t> bytes;
    };
    struct Packet {
        pad::Frame frame;
        bool odd;
    };

    bool prepare(Request& request, std::uint8_t endpoint, std::size_t size, libusb_transfer_cb_fn done,
                 unsigned timeout_ms) {
        request.transfer.reset(libusb_alloc_transfer(0));
        if (!request.transfer)
            return false;
        request.bytes.resize(size);
        libusb_fill_bulk_transfer(request.transfer.get(), handle_.get(), endpoint, request.bytes.data(),
                                  static_cast<int>(size), done, this, timeout_ms);
        return true;
    }

    void put(const std::uint8_t* bytes, std::size_t count) {
        const std::lock_guard lock(mutex_);
        Packet& packet = packets_[(oldest_ + waiting_) % most_waiting];
        if (waiting_ == most_waiting)
            oldest_ = (oldest_ + 1) % most_waiting;
        else
            ++waiting_;
        packet.odd = count != pad::frame_size;
        if (!packet.odd)
            std::copy_n(bytes, count, packet.frame.bytes);
        arrived_.notify_one();
    }

    void judge_sent() {
        switch (sending_.transfer->status) {
        case LIBUSB_TRANSFER_COMPLETED:
            write_errors_ = 0;
            break;
        case LIBUSB_TRANSFER_TIMED_OUT:
            break;
        case LIBUSB_TRANSFER_NO_DEVICE:
            lose();
            break;
        case LIBUSB_TRANSFER_STALL: // the pad did not want it; from here on it listens again
            ++write_errors_;
            if (libusb_clear_halt(handle_.get(), pad::bulk_out) != 0)
                lose();
            break;
        default:
            ++write_errors_;
            break;
        }
    }

    void lose() {
        const std::lock_guard lock(mutex_); // or a reader about to wait would not hear of it
        lost_.store(true);
        arrived_.notify_one();
    }

    void ask_for(libusb_transfer* transfer) {
        requests_out_.fetch_add(1);
        if (libusb_submit_transfer(transfer) != 0) {
            requests_out_.fetch_sub(1);
            lose();
        }
    }
    void ask_for_packets() {
        for (const Request& request : requests_)
            ask_for(request.transfer.get());
    }

    // Both in our own thread, which alone handles libusb's events.
    static void LIBUSB_CALL went_out(libusb_transfer* transfer) {
        auto& self = *static_cast<BulkTransport*>(transfer->user_data);
        const std::lock_guard lock(self.mutex_);
        self.on_the_way_ = false;
        self.sent_.notify_one();
    }
    static void LIBUSB_CALL came_back(libusb_transfer* transfer) {
        auto& self = *static_cast<BulkTransport*>(transfer->user_data);
        switch (transfer->status) {
        case LIBUSB_TRANSFER_COMPLETED:
            self.read_errors_ = 0;
            self.put(transfer->buffer, static_cast<std::size_t>(transfer->actual_length));
            break;
        case LIBUSB_TRANSFER_OVERFLOW: // more than a packet can hold
            ++self.read_errors_;
            self.put(transfer->buffer, 0);
            break;
        case LIBUSB_TRANSFER_STALL:
            ++self.read_errors_;
            self.stalled_.store(true);
            break;
        case LIBUSB_TRANSFER_NO_DEVICE:
            self.lose();
            break;
        case LIBUSB_TRANSFER_CANCELLED:
            break;
        default:
            ++self.read_errors_;
            break;
        }
        if (self.read_errors_ >= errors_of_a_dead_line)
            self.lose();
        // Before it is counted as back: who sees none out takes everything for ended.
        if (!self.lost_.load() && !self.closing_.load() && !self.stalled_.load())
            self.ask_for(transfer);
        self.requests_out_.fetch_sub(1);
    }

    void handle_events() {
        timeval wait{
            0, static_cast<decltype(timeval::tv_usec)>(std::chrono::microseconds(housekeeping).count())};
        libusb_handle_events_timeout_completed(context_.get(), &wait, nullptr);
    }

    /// True, and for good, when nothing is on its way to the pad.
    bool ends() {
        const std::lock_guard lock(mutex_);
        ended_ = !on_the_way_;
        return ended_;
    }

    void take_in() {
        while (true) {
            while (requests_out_.load() > 0) {
                handle_events();
                if (closing_.load() || stalled_.load() || lost_.load())
                    for (const Request& request : requests_)
                        libusb_cancel_transfer(request.transfer.get()); // once more does no harm
            }
            if (closing_.load() || lost_.load())
                break;
            // All came back, because the pad stalled the pipe: it speaks again once the halt is cleared.
            stalled_.store(false);
            if (libusb_clear_halt(handle_.get(), pad::bulk_in) != 0)
                lose();
            else
                ask_for_packets();
        }
        while (!ends())
            handle_events();
    }

    UsbContext context_;
    UsbHandle handle_;
    int interface_;
    std::array<Request, packets_asked_for> requests_;
    Request sending_;
    std::thread thread_;
    std::atomic<std::size_t> requests_out_{0}; ///< of requests_, those that wait in the system
    std::atomic<bool> closing_{false};
    std::atomic<bool> stalled_{false};
    std::atomic<bool> lost_{false};
    int read_errors_ = 0;  ///< in a row; only our thread
    int write_errors_ = 0; ///< in a row; only the thread that writes

    std::mutex mutex_; ///< of what follows
    std::condition_variable arrived_;
    std::condition_variable sent_;
    bool on_the_way_ = false; ///< a frame to the pad
    bool ended_ = false;      ///< nobody handles libusb's events any more
    std::array<Packet, most_waiting> packets_{};
    std::size_t oldest_ = 0;
    std::size_t waiting_ = 0;
};

/// The number of the bulk interface, if the device has it.
std::optional<int> bulk_interface(libusb_device* device) {
    libusb_config_descriptor* configuration = nullptr;
    if (libusb_get_active_config_descriptor(device, &configuration) != 0)
        return std::nullopt;
    std::optional<int> number;
    for (int i = 0; i < configuration->bNumInterfaces && !number; ++i) {
        if (configuration->interface[i].num_altsetting == 0)
            continue;
        const libusb_interface_descriptor& one = configuration->interface[i].altsetting[0];
        const auto has = [&one](std::uint8_t address) {
            return std::any_of(one.endpoint, one.endpoint + one.bNumEndpoints,
                               [address](const libusb_endpoint_descriptor& end) {
                                   return end.bEndpointAddress == address &&
                                          (end.bmAttributes & 3) == LIBUSB_TRANSFER_TYPE_BULK &&
                                          end.wMaxPacketSize >= pad::frame_size;
                               });
        };
        if (one.bInterfaceClass == pad::bulk_class && one.bInterfaceSubClass == pad::bulk_subclass &&
            one.bInterfaceProtocol == pad::bulk_protocol && has(pad::bulk_in) && has(pad::bulk_out))
            number = one.bInterfaceNumber;
    }
    libusb_free_config_descriptor(configuration);
    return number;
}

/// Where it is plugged in, as Linux writes it: the bus and the ports on the way.
std::string usb_place(libusb_device* device) {
    std::array<std::uint8_t, 7> ports{};
    const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
    std::string place = std::to_string(libusb_get_bus_number(device));
    for (int i = 0; i < count; ++i) {
        place += i == 0 ? '-' : '.';
        place += std::to_string(ports[static_cast<std::size_t>(i)]);
    }
    return place;
}

/// A string of the device, as far as this system tells it without ado: Linux keeps it in a file that
/// everybody may read, elsewhere the device must be asked.
std::string usb_string([[maybe_unused]] libusb_device* device, [[maybe_unused]] std::uint8_t index,
                       [[maybe_unused]] const char* file) {
    std::string text;
#if defined(__linux__)
    std::ifstream in("/sys/bus/usb/devices/" + usb_place(device) + "/" + file);
    std::getline(in, text);
#else
    libusb_device_handle* opened = nullptr;
    if (index == 0 || libusb_open(device, &opened) != 0)
        return text;
    const UsbHandle handle(opened);
    std::array<unsigned char, 128> bytes{};
    const int count =
        libusb_get_string_descriptor_ascii(opened, index, bytes.data(), static_cast<int>(bytes.size()));
    if (count > 0)
        text.assign(bytes.begin(), bytes.begin() + count);
#endif
    for (char& letter : text)
        if (letter < 0x20 || letter > 0x7E)
            letter = '?';
    return text;
}

struct UsbPad {
    FoundPad pad;
    UsbDevice device;
    int interface;
};

std::vector<UsbPad> usb_pads(libusb_context* context) {
    std::vector<UsbPad> found;
    libusb_device** all = nullptr;
    const auto count = libusb_get_device_list(context, &all);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        libusb_device_descriptor about{};
        if (libusb_get_device_descriptor(all[i], &about) != 0 || about.idVendor != pad::usb_vendor ||
            about.idProduct != pad::usb_product)
            continue;
        if (const std::optional<int> interface = bulk_interface(all[i]))
            found.push_back({{usb_place(all[i]), usb_string(all[i], about.iSerialNumber, "serial"),
                              usb_string(all[i], about.iProduct, "product")},
                             UsbDevice(libusb_ref_device(all[i])),
                             *interface});
    }
    if (count >= 0)
        libusb_free_device_list(all, 1);
    return found;
}

} // namespace

std::vector<FoundPad> find_bulk() {
    std::vector<FoundPad> found;
    if (const UsbContext context = usb_context())
        for (UsbPad& one : usb_pads(context.get()))
            found.push_back(std::move(one.pad));
    return found;
}

Result<std::unique_ptr<ReportTransport>> open_bulk(const FoundPad& pad) {
    const auto refused = [](int error) {
        return Error{sentence(open_problem_of_libusb(error, this_system()), this_system(), "force pad")};
    };
    UsbContext context = usb_context();
    if (!context)
        return refused(LIBUSB_ERROR_OTHER);
    std::vector<UsbPad> all = usb_pads(context.get());
    const auto wanted = std::find_if(all.begin(), all.end(), [&pad](const UsbPad& one) {
        return pad.serial_number.empty() ? one.pad.path == pad.path
                                         : one.pad.serial_number == pad.serial_number;
    });
    if (wanted == all.end())
        return refused(LIBUSB_ERROR_NO_DEVICE);
    libusb_device_handle* opened = nullptr;
    if (const int error = libusb_open(wanted->device.get(), &opened); error != 0)
        return refused(error);
    UsbHandle handle(opened);
    // Where the system knows no such thing there is no driver to detach.
    libusb_set_auto_detach_kernel_driver(opened, 1);
    if (const int error = libusb_claim_interface(opened, wanted->interface); error != 0)
        return refused(error);
    const int interface = wanted->interface;
    all.clear(); // nothing of a context may outlive it
    auto transport = std::make_unique<BulkTransport>(std::move(context), std::move(handle), interface);
    if (!transport->begin())
        return refused(LIBUSB_ERROR_NO_DEVICE);
    return std::unique_ptr<ReportTransport>(std::move(transport));
}

OpenProblem open_problem_of_libusb(int error, System system) {
    switch (error) {
    case LIBUSB_ERROR_ACCESS: // macOS says this of a device that another program has open
        return system == System::macos ? OpenProblem::busy : OpenProblem::permission;
    case LIBUSB_ERROR_BUSY:
        return OpenProblem::busy;
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_IO:
        return OpenProblem::gone;
    case LIBUSB_ERROR_NOT_FOUND: // on Windows an interface that WinUSB does not drive
        return system == System::windows ? OpenProblem::wrong_usb_driver : OpenProblem::gone;
    case LIBUSB_ERROR_NOT_SUPPORTED:
        return OpenProblem::wrong_usb_driver;
    default:
        return OpenProblem::other;
    }
}

} // namespace tp
