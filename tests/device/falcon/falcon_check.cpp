// SPDX-License-Identifier: Apache-2.0
#include "falcon_check.hpp"

#include "device/falcon/falcon_start.hpp"
#include "device/falcon/ftdi.hpp"
#include "device/falcon/model_falcon.hpp"
#include "device/falcon/plane_force.hpp"
#include "device/falcon/stamper.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp::test {

using namespace tp::falcon;

namespace {

using Bytes = std::span<const std::uint8_t>;

std::string complaint_about(const Reply& reply) {
    if (decode_reply(encode(reply)) != reply)
        return "a reply that is taken is not given back as it came";
    Angles angles;
    for (std::size_t i = 0; i < 3; ++i)
        angles[static_cast<int>(i)] = angle_of(reply.encoders[i]);
    const std::optional<Place> place = place_of(angles, middle);
    if (!place)
        return {};
    if (!(glm::length(*place) < 0.25))
        return "a place that no Falcon reaches";
    const std::optional<glm::dmat3> j = jacobian(*place, angles);
    if (!j)
        return {};
    for (const int units : motors_for(*j, {0.5, -2.0, 1.5}))
        if (std::abs(units) > most_motor)
            return "a motor is asked for more than it has";
    return {};
}

std::string complaint_about_stream(Bytes bytes) {
    PacketStream stream;
    std::uint64_t whole = 0;
    std::uint64_t pushed = 0;
    for (const std::uint8_t byte : bytes) {
        ++pushed;
        const std::optional<Packet> packet = stream.push(byte);
        if (!packet)
            continue;
        ++whole;
        if (const std::optional<Reply> reply = decode_reply(*packet))
            if (std::string words = complaint_about(*reply); !words.empty())
                return words;
        if (const std::optional<Command> command = decode_command(*packet))
            if (encode(*command) != *packet)
                return "a command that is taken is not given back as it came";
    }
    const std::uint64_t accounted = whole * packet_size + stream.strays();
    if (accounted > pushed || pushed - accounted >= packet_size)
        return "bytes are lost between packets and strays";
    return {};
}

/// The bytes as numbers of packets whose frame is right, so that chance need not find the frame.
std::string complaint_about_mended(Bytes bytes) {
    for (std::size_t at = 0; at + 7 <= bytes.size(); at += 7) {
        Reply reply;
        for (std::size_t i = 0; i < 3; ++i)
            reply.encoders[i] = static_cast<std::int16_t>(bytes[at + 2 * i] | (bytes[at + 2 * i + 1] << 8));
        reply.buttons = bytes[at + 6] & 0xFu;
        reply.homed = static_cast<std::uint8_t>((bytes[at + 6] >> 4) & 7u);
        if (std::string words = complaint_about(reply); !words.empty())
            return words;
    }
    return {};
}

/// What comes back while a Falcon is started: packets of which the first byte says how long they are.
std::string complaint_about_start(Bytes bytes) {
    const std::vector<std::uint8_t> image(200, 0x55);
    for (const Bytes loaded : {Bytes(image), Bytes()}) {
        FalconStart start(loaded);
        std::size_t at = 0;
        constexpr int most = 100000;
        for (int i = 0;; ++i) {
            const FalconStart::Step step = start.next();
            if (step.what == FalconStart::Step::What::running)
                break;
            if (step.what == FalconStart::Step::What::failed) {
                if (start.trouble() == FalconStart::Trouble::none)
                    return "it fails and does not say why";
                break;
            }
            if (i >= most)
                return "starting never ends";
            if (step.what == FalconStart::Step::What::send && step.bytes.size() > ftdi::most_payload)
                return "more is sent than an echo can bring back in a packet";
            if (step.what != FalconStart::Step::What::listen)
                continue;
            if (at >= bytes.size()) {
                start.silence();
                continue;
            }
            const std::size_t count = std::min<std::size_t>(bytes[at] & 63u, bytes.size() - at - 1);
            const ftdi::Received got = ftdi::received(bytes.subspan(at + 1, count));
            start.heard(got.payload, got.clear_to_send);
            at += count + 1;
        }
        if (start.loads() > FalconStart::most_loads)
            return "it loads too often";
    }
    return {};
}

std::string complaint_about_model(Bytes bytes) {
    ModelFalcon model(std::vector<std::uint8_t>(100, 0x41));
    model.run_firmware(true);
    model.control(ftdi::baud_1500000);
    model.control(ftdi::latency(1));
    for (std::size_t at = 0; at < bytes.size(); at += 50) {
        model.send(bytes.subspan(at, std::min<std::size_t>(50, bytes.size() - at)));
        model.step();
        UsbPacket packet;
        while (model.packet(packet))
            if (!packet.whole() || packet.size < ftdi::status_size)
                return "the model sends what is no packet of its bridge";
        if (!(glm::length(model.grip()) < 0.25))
            return "the grip is where no Falcon reaches";
    }
    return {};
}

} // namespace

std::string complaint_about_falcon_bytes(std::string_view text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    for (const auto check :
         {complaint_about_stream, complaint_about_mended, complaint_about_start, complaint_about_model})
        if (std::string words = check(bytes); !words.empty())
            return words;
    return {};
}

} // namespace tp::test
