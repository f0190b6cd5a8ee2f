// SPDX-License-Identifier: Apache-2.0
#include "device/usb/bulk_pipe.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <libusb.h>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr unsigned write_timeout_ms = 100; ///< no device's watchdog waits as long: what is older is of no use
constexpr int errors_of_a_dead_line =
    64; ///< in a row; an unplugged cable gives some before it is known to be
constexpr std::size_t packets_asked_for = 8; ///< at a time: that many may come before we ask again
constexpr std::size_t most_waiting = 64;     ///< packets that nobody has read yet; the oldest gives way
constexpr std::chrono::milliseconds housekeeping{50};

struct FreeTransfer {
    void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
};
using UsbTransfer = std::unique_ptr<libusb_transfer, FreeTransfer>;

/// Packets in, by transfers that wait in the system and come back in a thread of its own; packets out, one
/// after the other, each awaited by the thread that writes. libusb's calls that wait are not used: they would
/// have the writer handle the events of what comes in.
class LibusbPipe final : public BulkPipe {
public:
    /// The handle holds the interface.
    LibusbPipe(UsbContext context, UsbHandle handle, int interface, const UsbKind& kind)
        : context_(std::move(context)), handle_(std::move(handle)), interface_(interface), kind_(kind) {}

    /// False where the system gives no memory or the device is gone already.
    bool begin() {
        const int packet = libusb_get_max_packet_size(libusb_get_device(handle_.get()), kind_.in);
        if (packet < static_cast<int>(kind_.least_packet))
            return false;
        for (Request& request : requests_) {
            // One packet each: a packet that fills its endpoint would not end a longer transfer.
            if (!prepare(request, kind_.in, static_cast<std::size_t>(packet), &LibusbPipe::came_back, 0))
                return false;
        }
        if (!prepare(sending_, kind_.out, UsbPacket{}.bytes.size(), &LibusbPipe::went_out,
                     write_timeout_ms) ||
            !prepare(asking_, 0, LIBUSB_CONTROL_SETUP_SIZE, &LibusbPipe::went_out, write_timeout_ms))
            return false;
        ask_for_packets();
        thread_ = std::thread([this] { take_in(); });
        return !lost_.load();
    }

    ~LibusbPipe() override {
        closing_.store(true);
        if (thread_.joinable()) {
            libusb_interrupt_event_handler(context_.get());
            thread_.join();
        }
        // And gives it back to the driver it was taken from.
        libusb_release_interface(handle_.get(), interface_);
    }
    LibusbPipe(const LibusbPipe&) = delete;
    LibusbPipe& operator=(const LibusbPipe&) = delete;

    UsbGot read(UsbPacket& packet, int wait_ms) noexcept override {
        std::unique_lock lock(mutex_, std::defer_lock);
        if (wait_ms == 0) {
            if (!lock.try_lock()) // a packet is being put in: it is there the next time
                return UsbGot::nothing;
        } else {
            lock.lock();
            arrived_.wait_for(lock, std::chrono::milliseconds(wait_ms),
                              [this] { return waiting_ > 0 || lost_.load(); });
        }
        if (waiting_ == 0)
            return lost_.load() ? UsbGot::lost : UsbGot::nothing;
        packet = packets_[oldest_];
        oldest_ = (oldest_ + 1) % most_waiting;
        --waiting_;
        return UsbGot::packet;
    }

    bool write(std::span<const std::uint8_t> bytes) noexcept override {
        return carry_out(sending_, [this, bytes] {
            const std::size_t count = std::min(bytes.size(), sending_.bytes.size());
            std::copy_n(bytes.begin(), count, sending_.bytes.begin());
            sending_.transfer->length = static_cast<int>(count);
        });
    }

    bool control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                 std::uint16_t index) noexcept override {
        return carry_out(asking_, [this, type, request, value, index] {
            libusb_fill_control_setup(asking_.bytes.data(), type, request, value, index, 0);
            libusb_fill_control_transfer(asking_.transfer.get(), handle_.get(), asking_.bytes.data(),
                                         &LibusbPipe::went_out, this, write_timeout_ms);
        });
    }

    int descriptor() const override { return usb_descriptor(libusb_get_device(handle_.get())); }

private:
    struct Request {
        UsbTransfer transfer;
        std::vector<std::uint8_t> bytes;
    };
    /// Fills the transfer, sends it and waits until it is done or libusb gives up.
    template <typename Fill>
    bool carry_out(Request& what, Fill fill) noexcept {
        std::unique_lock lock(mutex_);
        if (ended_)
            return false;
        fill();
        on_the_way_ = true;
        lock.unlock();
        const int error = libusb_submit_transfer(what.transfer.get());
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
            judge_sent(*what.transfer);
        if (write_errors_ >= errors_of_a_dead_line)
            lose();
        return !lost_.load();
    }

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
        UsbPacket& packet = packets_[(oldest_ + waiting_) % most_waiting];
        if (waiting_ == most_waiting)
            oldest_ = (oldest_ + 1) % most_waiting;
        else
            ++waiting_;
        packet.size = count;
        std::copy_n(bytes, std::min(count, packet.bytes.size()), packet.bytes.begin());
        arrived_.notify_one();
    }

    void judge_sent(const libusb_transfer& transfer) {
        switch (transfer.status) {
        case LIBUSB_TRANSFER_COMPLETED:
            write_errors_ = 0;
            break;
        case LIBUSB_TRANSFER_TIMED_OUT:
            break;
        case LIBUSB_TRANSFER_NO_DEVICE:
            lose();
            break;
        case LIBUSB_TRANSFER_STALL: // it did not want that; from here on it listens again
            ++write_errors_;
            if (transfer.type == LIBUSB_TRANSFER_TYPE_BULK &&
                libusb_clear_halt(handle_.get(), kind_.out) != 0)
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
        auto& self = *static_cast<LibusbPipe*>(transfer->user_data);
        const std::lock_guard lock(self.mutex_);
        self.on_the_way_ = false;
        self.sent_.notify_one();
    }
    static void LIBUSB_CALL came_back(libusb_transfer* transfer) {
        auto& self = *static_cast<LibusbPipe*>(transfer->user_data);
        switch (transfer->status) {
        case LIBUSB_TRANSFER_COMPLETED:
            self.read_errors_ = 0;
            self.put(transfer->buffer, static_cast<std::size_t>(transfer->actual_length));
            break;
        case LIBUSB_TRANSFER_OVERFLOW: // more than a packet can hold
            ++self.read_errors_;
            self.put(transfer->buffer, UsbPacket{}.bytes.size() + 1);
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

    /// True, and for good, when nothing is on its way to the device.
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
            // All came back, because the device stalled the pipe: it speaks again once the halt is cleared.
            stalled_.store(false);
            if (libusb_clear_halt(handle_.get(), kind_.in) != 0)
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
    UsbKind kind_;
    std::array<Request, packets_asked_for> requests_;
    Request sending_;
    Request asking_;
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
    bool on_the_way_ = false; ///< a transfer to the device
    bool ended_ = false;      ///< nobody handles libusb's events any more
    std::array<UsbPacket, most_waiting> packets_{};
    std::size_t oldest_ = 0;
    std::size_t waiting_ = 0;
};

} // namespace

Result<std::unique_ptr<BulkPipe>> open_pipe(const UsbKind& kind, const std::string& serial_number,
                                            const std::string& path, const std::string& name) {
    const auto refused = [&name](int error) {
        return Error{sentence(open_problem_of_libusb(error, this_system()), this_system(), name)};
    };
    UsbContext context = usb_context();
    if (!context)
        return refused(LIBUSB_ERROR_OTHER);
    std::vector<FoundUsb> all = find_usb(context.get(), kind);
    const auto wanted = std::find_if(all.begin(), all.end(), [&](const FoundUsb& one) {
        return serial_number.empty() ? one.path == path : one.serial_number == serial_number;
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
    auto pipe = std::make_unique<LibusbPipe>(std::move(context), std::move(handle), interface, kind);
    if (!pipe->begin())
        return refused(LIBUSB_ERROR_NO_DEVICE);
    return std::unique_ptr<BulkPipe>(std::move(pipe));
}

} // namespace tp
