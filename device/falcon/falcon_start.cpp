// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/falcon_start.hpp"

#include <algorithm>
#include <array>

namespace tp::falcon {

namespace {

constexpr std::array<std::uint8_t, 3> greeting{0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> greeting_answer{0x0A, 0x44, 0x2C, 0x0D}; ///< macOS has a 0 before it
constexpr std::array<std::uint8_t, 1> knock{0x41};                             ///< and the same comes back

constexpr int probes = 5;       ///< of a firmware that may be running
constexpr int greetings = 100;  ///< of a load
constexpr int knocks = 5;       ///< of a load
constexpr int proofs = 10;      ///< of a firmware that was just loaded and must first begin
constexpr int patience_ms = 60; ///< until something is sent again; a busy computer is slow, not a Falcon
constexpr int chunk_patience_ms = 400; ///< 62 bytes at 142857 baud take 5 ms each way
constexpr int clear_patience_ms = 300; ///< then it is tried without CTS
constexpr int running_latency_ms = 1;  ///< from one packet to the next, even if nothing is in it
constexpr int loader_latency_ms = 16;

const std::vector<ftdi::Request>& line_of_a_running_falcon() {
    static const std::vector<ftdi::Request> requests{ftdi::latency(running_latency_ms),
                                                     ftdi::baud_1500000,
                                                     ftdi::eight_bits_no_parity,
                                                     ftdi::no_flow_control,
                                                     ftdi::purge_received,
                                                     ftdi::purge_to_send};
    return requests;
}
const std::vector<ftdi::Request>& line_of_its_loader() {
    static const std::vector<ftdi::Request> requests{ftdi::purge_received,
                                                     ftdi::purge_to_send,
                                                     ftdi::latency(loader_latency_ms),
                                                     ftdi::baud_9600,
                                                     ftdi::eight_bits_no_parity,
                                                     ftdi::no_flow_control,
                                                     ftdi::rts_low,
                                                     ftdi::dtr_low,
                                                     ftdi::dtr_high};
    return requests;
}
const std::vector<ftdi::Request>& line_of_a_load() {
    static const std::vector<ftdi::Request> requests{ftdi::dtr_low, ftdi::baud_142857};
    return requests;
}

bool contains(const std::vector<std::uint8_t>& bytes, std::span<const std::uint8_t> wanted) {
    return std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end()) != bytes.end();
}

} // namespace

FalconStart::FalconStart(std::span<const std::uint8_t> image) : image_(image), probe_(encode(Command{})) {
    enter(Stage::probing);
}

void FalconStart::enter(Stage stage) {
    stage_ = stage;
    requests_.clear();
    const auto line = [this](const std::vector<ftdi::Request>& requests) {
        requests_.assign(requests.rbegin(), requests.rend());
    };
    switch (stage) {
    case Stage::probing:
        line(line_of_a_running_falcon());
        asks_left_ = probes;
        break;
    case Stage::greeting:
        ++loads_;
        loaded_ = 0;
        line(line_of_its_loader());
        asks_left_ = greetings;
        break;
    case Stage::clearing:
        line(line_of_a_load());
        asks_left_ = 0;
        patience_left_ms_ = clear_patience_ms;
        clear_ = false;
        to_send_ = false;
        return;
    case Stage::knocking:
        asks_left_ = knocks;
        break;
    case Stage::loading:
        asks_left_ = 1; // of each chunk: what is sent twice would be loaded twice
        break;
    case Stage::proving:
        line(line_of_a_running_falcon());
        asks_left_ = proofs;
        break;
    case Stage::running:
    case Stage::failed:
        return;
    }
    ask();
}

void FalconStart::ask() {
    --asks_left_;
    to_send_ = true;
    got_.clear();
    patience_left_ms_ = stage_ == Stage::loading ? chunk_patience_ms : patience_ms;
}

void FalconStart::again(Trouble trouble) {
    trouble_ = trouble;
    if (image_.empty())
        trouble_ = Trouble::no_image;
    enter(image_.empty() || loads_ >= most_loads ? Stage::failed : Stage::greeting);
}

FalconStart::Step FalconStart::next() {
    if (stage_ == Stage::running)
        return {Step::What::running, {}, {}};
    if (stage_ == Stage::failed)
        return {Step::What::failed, {}, {}};
    if (!requests_.empty()) {
        const ftdi::Request request = requests_.back();
        requests_.pop_back();
        return {Step::What::control, request, {}};
    }
    if (!to_send_)
        return {Step::What::listen, {}, {}};
    to_send_ = false;
    switch (stage_) {
    case Stage::greeting:
        return {Step::What::send, {}, greeting};
    case Stage::knocking:
        return {Step::What::send, {}, knock};
    case Stage::loading:
        chunk_ = std::min(ftdi::most_payload, image_.size() - loaded_);
        return {Step::What::send, {}, image_.subspan(loaded_, chunk_)};
    default:
        return {Step::What::send, {}, probe_};
    }
}

void FalconStart::judge() {
    switch (stage_) {
    case Stage::probing:
    case Stage::proving:
        if (answered_) {
            trouble_ = Trouble::none;
            enter(Stage::running);
        }
        break;
    case Stage::greeting:
        if (contains(got_, greeting_answer))
            enter(Stage::clearing);
        break;
    case Stage::clearing:
        if (clear_)
            enter(Stage::knocking);
        break;
    case Stage::knocking:
        if (contains(got_, knock))
            enter(Stage::loading);
        break;
    case Stage::loading: {
        const std::size_t count = std::min(got_.size(), chunk_);
        if (!std::equal(got_.begin(), got_.begin() + static_cast<std::ptrdiff_t>(count),
                        image_.begin() + static_cast<std::ptrdiff_t>(loaded_)))
            return again(Trouble::broken_load);
        if (count < chunk_)
            break;
        loaded_ += chunk_;
        enter(loaded_ == image_.size() ? Stage::proving : Stage::loading);
        break;
    }
    case Stage::running:
    case Stage::failed:
        break;
    }
}

void FalconStart::heard(std::span<const std::uint8_t> payload, bool clear_to_send) {
    clear_ = clear_to_send;
    got_.insert(got_.end(), payload.begin(), payload.end());
    if (stage_ == Stage::probing || stage_ == Stage::proving)
        for (const std::uint8_t byte : payload)
            if (const std::optional<Packet> packet = stream_.push(byte); packet && decode_reply(*packet))
                answered_ = true;
    const Stage before = stage_;
    const std::size_t loaded_before = loaded_;
    const int loads_before = loads_;
    judge();
    if (stage_ == before && loaded_ == loaded_before && loads_ == loads_before)
        wait(stage_ == Stage::probing || stage_ == Stage::proving ? running_latency_ms : loader_latency_ms);
}

void FalconStart::silence() { wait(listen_ms); }

void FalconStart::wait(int ms) {
    patience_left_ms_ -= ms;
    if (stage_ == Stage::running || stage_ == Stage::failed || patience_left_ms_ > 0)
        return;
    if (asks_left_ > 0)
        return ask();
    switch (stage_) {
    case Stage::probing:
        return again(Trouble::no_image);
    case Stage::clearing:
        return enter(Stage::knocking);
    case Stage::greeting:
    case Stage::knocking:
        return again(Trouble::mute_loader);
    case Stage::loading:
        return again(Trouble::broken_load);
    default:
        return again(Trouble::dead_firmware);
    }
}

std::string start_sentence(FalconStart::Trouble trouble, const std::string& image_file) {
    switch (trouble) {
    case FalconStart::Trouble::none:
        return {};
    case FalconStart::Trouble::no_image:
        return "The Falcon needs its firmware, which its maker does not let this program include. Copy "
               "the firmware "
               "file of its maker's software to " +
               image_file + ".";
    case FalconStart::Trouble::mute_loader:
        return "The Falcon does not answer. Check that its power supply is plugged in, unplug its USB cable, "
               "plug it in "
               "again and try once more.";
    case FalconStart::Trouble::broken_load:
        return "The Falcon did not take its firmware, though it was tried again and again. Plug its USB "
               "cable into "
               "this computer itself, not into a hub, and try once more.";
    case FalconStart::Trouble::dead_firmware:
        return "The Falcon took its firmware and does not answer. Perhaps " + image_file +
               " is not the firmware of a Falcon.";
    }
    return {};
}

} // namespace tp::falcon
