// SPDX-License-Identifier: Apache-2.0
#include "usbip_port.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <fcntl.h>
#include <optional>
#include <span>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace tp::vm {

namespace {

constexpr std::size_t header_size = 48;
constexpr std::size_t largest_transfer = 65536;
using Header = std::array<std::uint8_t, header_size>;

// Commands and the places of their fields, big endian.
constexpr std::uint32_t submit = 1;
constexpr std::uint32_t unlink_transfer = 2;
constexpr std::uint32_t submitted = 3;
constexpr std::uint32_t unlinked = 4;
constexpr std::size_t command_at = 0;
constexpr std::size_t number_at = 4;
constexpr std::size_t inward_at = 12;
constexpr std::size_t endpoint_at = 16;
constexpr std::size_t unwanted_at = 20; ///< of unlink
constexpr std::size_t status_at = 20;   ///< of an answer
constexpr std::size_t length_at = 24;
constexpr std::size_t setup_at = 40;

std::uint32_t field(const Header& header, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | header[at + i];
    return value;
}

void set_field(std::uint8_t* header, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i)
        header[at + i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

bool read_whole(int file, std::span<std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::read(file, bytes.data(), bytes.size());
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

bool write_whole(int file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

UsbModel::Bytes string_descriptor(const std::string& text) {
    UsbModel::Bytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), 3};
    for (const char letter : text) {
        bytes.push_back(static_cast<std::uint8_t>(letter));
        bytes.push_back(0);
    }
    return bytes;
}

std::optional<UsbModel::Bytes> descriptor(const UsbModel& model, unsigned type, unsigned number) {
    const UsbModel::Descriptors all = model.descriptors();
    switch (type) {
    case 1:
        return all.device;
    case 2:
        return all.configuration;
    case 3:
        if (number == 0)
            return UsbModel::Bytes{4, 3, 0x09, 0x04}; // English
        if (number <= all.strings.size())
            return string_descriptor(all.strings[number - 1]);
        return std::nullopt;
    default:
        return std::nullopt;
    }
}

} // namespace

bool UsbipPort::plug_in() {
    int ends[2] = {-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return false;
    // A socket that was let go of is torn down later: its port of the controller may still be taken.
    bool attached = false;
    for (int port = 0; port < 8 && !attached; ++port) {
        const int controller = ::open("/sys/devices/platform/vhci_hcd.0/attach", O_WRONLY | O_CLOEXEC);
        std::string words = std::to_string(port);
        for (const int number : {ends[1], 65538, static_cast<int>(model_.speed())})
            words.append(" ").append(std::to_string(number));
        attached = controller >= 0 &&
                   ::write(controller, words.data(), words.size()) == static_cast<ssize_t>(words.size());
        if (controller >= 0)
            ::close(controller);
    }
    if (!attached)
        std::perror("vhci_hcd");
    ::close(ends[1]);
    waiting_.clear();
    configuration_ = 0;
    file_ = ends[0];
    return attached;
}

void UsbipPort::unplug() {
    if (file_ >= 0)
        ::close(file_);
    file_ = -1;
}

bool UsbipPort::answer(std::uint32_t number, int status, std::size_t length, const UsbModel::Bytes& bytes) {
    UsbModel::Bytes packet(header_size);
    set_field(packet.data(), command_at, submitted);
    set_field(packet.data(), number_at, number);
    set_field(packet.data(), status_at, static_cast<std::uint32_t>(status));
    set_field(packet.data(), length_at, static_cast<std::uint32_t>(length));
    packet.insert(packet.end(), bytes.begin(), bytes.end());
    return write_whole(file_, packet);
}

bool UsbipPort::take_back(std::uint32_t number, std::uint32_t unwanted) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [unwanted](const Waiting& one) { return one.number == unwanted; });
    const int status = found == waiting_.end() ? 0 : -ECONNRESET; // 0: it was answered already
    if (found != waiting_.end())
        waiting_.erase(found);
    UsbModel::Bytes packet(header_size);
    set_field(packet.data(), command_at, unlinked);
    set_field(packet.data(), number_at, number);
    set_field(packet.data(), status_at, static_cast<std::uint32_t>(status));
    return write_whole(file_, packet);
}

bool UsbipPort::control(std::uint32_t number, const std::uint8_t* setup, bool inward,
                        const UsbModel::Bytes& sent) {
    const auto wanted = static_cast<std::size_t>(setup[6] | setup[7] << 8);
    std::optional<UsbModel::Bytes> bytes;
    switch (setup[0] << 8 | setup[1]) {
    case 0x8006: // GET_DESCRIPTOR
        bytes = descriptor(model_, setup[3], setup[2]);
        break;
    case 0x0009: // SET_CONFIGURATION
        configuration_ = setup[2];
        bytes.emplace();
        break;
    case 0x8008: // GET_CONFIGURATION
        bytes = UsbModel::Bytes{configuration_};
        break;
    case 0x8000: // GET_STATUS
    case 0x8100:
    case 0x8200:
        bytes = UsbModel::Bytes{0, 0};
        break;
    case 0x0005: // SET_ADDRESS
    case 0x010B: // SET_INTERFACE
    case 0x0201: // CLEAR_FEATURE of an endpoint
        bytes.emplace();
        break;
    default:
        bytes = model_.control(std::span<const std::uint8_t, 8>(setup, 8), sent);
    }
    if (!bytes)
        return answer(number, -EPIPE, 0, {});
    if (!inward)
        return answer(number, 0, sent.size(), {});
    bytes->resize(std::min(bytes->size(), wanted));
    return answer(number, 0, bytes->size(), *bytes);
}

bool UsbipPort::take_in() {
    Header header{};
    if (!read_whole(file_, header))
        return false;
    const std::uint32_t number = field(header, number_at);
    if (field(header, command_at) == unlink_transfer)
        return take_back(number, field(header, unwanted_at));
    const bool inward = field(header, inward_at) != 0;
    const std::size_t length = field(header, length_at);
    const unsigned endpoint = field(header, endpoint_at);
    if (field(header, command_at) != submit || length > largest_transfer)
        return false;
    UsbModel::Bytes sent(inward ? 0 : length);
    if (!read_whole(file_, sent))
        return false;
    if (endpoint == 0)
        return control(number, header.data() + setup_at, inward, sent);
    if (inward) {
        waiting_.push_back({number, endpoint, length});
        return true;
    }
    model_.output(endpoint, sent);
    return answer(number, 0, length, {});
}

bool UsbipPort::pass_on() {
    for (auto one = waiting_.begin(); one != waiting_.end();) {
        UsbModel::Bytes bytes;
        if (!model_.input(one->endpoint, one->most, bytes)) {
            ++one;
            continue;
        }
        if (!answer(one->number, 0, bytes.size(), bytes))
            return false;
        one = waiting_.erase(one);
    }
    return true;
}

} // namespace tp::vm
