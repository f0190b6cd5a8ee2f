// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/falcon/falcon_frame.hpp"
#include "device/falcon/ftdi.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tp::falcon {

/// From a Falcon in any state to one that answers commands: finds out whether its firmware runs, and loads it
/// where it does not. Bytes in, requests out: it knows no transport and no clock, asks a bounded number of
/// times, and so always ends. Facts: libnifalcon at f7c727a; that a load often fails at first and is tried
/// again as a whole, and that waiting for CTS makes it reliable: its issues 9, 24 and 45.
class FalconStart {
public:
    /// What is wanted of the line now.
    struct Step {
        enum class What {
            control, ///< make `request`, then ask for the next step
            send,    ///< send `bytes`, then ask for the next step
            listen,  ///< wait for a packet at most `listen_ms`; say heard() or silence(), then ask for the
                     ///< next step
            running, ///< the end: it answers commands
            failed,  ///< the end: `trouble()` says why
        };
        What what = What::failed;
        ftdi::Request request;
        std::span<const std::uint8_t> bytes; ///< valid until the next step
    };
    static constexpr int listen_ms = 20;

    enum class Trouble {
        none,
        no_image,     ///< its firmware does not run, and there is none to load
        mute_loader,  ///< its loader never answered: no power, or in a state that only unplugging ends
        broken_load,  ///< what came back was not what was sent
        dead_firmware ///< it took the image and never answered a command
    };

    /// `image` is the firmware that may be loaded, empty where there is none; it must outlive this.
    explicit FalconStart(std::span<const std::uint8_t> image);

    Step next();
    /// What a packet held besides its status; also nothing.
    void heard(std::span<const std::uint8_t> payload, bool clear_to_send);
    void silence();

    Trouble trouble() const { return trouble_; }
    /// Whole loads that were begun.
    int loads() const { return loads_; }

    static constexpr int most_loads = 10;

private:
    enum class Stage { probing, greeting, clearing, knocking, loading, proving, running, failed };
    void enter(Stage stage);
    void again(Trouble trouble);
    void ask();
    void judge();
    void wait(int ms);

    std::span<const std::uint8_t> image_;
    Stage stage_ = Stage::probing;
    std::vector<ftdi::Request> requests_; ///< of the stage, still to be made, last first
    bool to_send_ = false;
    int asks_left_ = 0;        ///< times that what the stage sends may be sent
    int patience_left_ms_ = 0; ///< until it is sent again
    Packet probe_;
    PacketStream stream_;
    bool answered_ = false;
    std::vector<std::uint8_t> got_; ///< since something was sent
    bool clear_ = false;
    std::size_t loaded_ = 0;
    std::size_t chunk_ = 0;
    int loads_ = 0;
    Trouble trouble_ = Trouble::none;
};

/// What a person is told, and what to do; `image_file` is where the firmware is looked for.
std::string start_sentence(FalconStart::Trouble trouble, const std::string& image_file);

} // namespace tp::falcon
