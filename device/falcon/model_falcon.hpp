// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/falcon/falcon_frame.hpp"
#include "device/falcon/ftdi.hpp"
#include "device/falcon/stamper.hpp"
#include "device/usb/usb_packet.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace tp {

/// The grip of a Falcon and the hand that may hold it.
struct FalconPlant {
    double mass = 0.2;                   ///< kg
    double damping = 1.0;                ///< N·s/m
    double coulomb = 0.05;               ///< N, dry friction
    double hand_stiffness = 0.0;         ///< N/m between grip and hand; 0: released
    double hand_damping = 0.0;           ///< N·s/m
    double units_per_newton_metre = 0.0; ///< of its motors in truth; 0: as the back end believes
    int watchdog_ms = 0; ///< silence after which it lets go; 0: it keeps its last command for ever
};

/// A Falcon without hardware, byte by byte: the serial bridge with its baud rate, latency and lines, the boot
/// loader that gives back what it is sent, the firmware's packets, encoders by the true kinematics, and a
/// body in space for a grip. Gravity is not in it. One step is a millisecond of its own time.
class ModelFalcon {
public:
    /// `image` is the one firmware that it can run.
    explicit ModelFalcon(std::vector<std::uint8_t> image, const FalconPlant& plant = {});

    // The USB side.
    void control(const falcon::ftdi::Request& request);
    void send(std::span<const std::uint8_t> bytes);
    /// The next packet to the computer; false when all is said.
    bool packet(UsbPacket& packet);
    void step();

    /// As when its power comes back: its loader waits.
    void restart();
    /// As after a program before has loaded it, and a person has homed it or not.
    void run_firmware(bool homed);

    /// Puts the grip there, at rest, m; the hand follows. A place beyond its stops changes nothing.
    void place_grip(const falcon::Place& place);
    /// A person pulls the grip out as far as it goes and pushes it in again, at once.
    void pull_and_push();
    void move_hand(const falcon::Place& place) { hand_ = place; }
    const falcon::Place& grip() const { return place_; }
    /// N, what the motors' torques do to the grip in truth.
    const glm::dvec3& force() const { return force_; }
    const falcon::Command& command() const { return command_; }
    bool firmware_runs() const { return state_ == State::firmware; }
    int loads_begun() const { return loads_begun_; }

    /// What can go wrong with it.
    struct Troubles {
        int broken_loads = 0;       ///< that many loads give one byte back wrong
        int lossy_loads = 0;        ///< and then that many lose one
        bool mute_loader = false;   ///< its loader says nothing
        bool never_clear = false;   ///< CTS never rises
        bool eager_zero = false;    ///< a 0 before the loader's greeting, as macOS delivers it
        bool dead_firmware = false; ///< it takes the image and never answers
    };
    Troubles troubles;

private:
    enum class State { greeting, greeted, loading, starting, firmware, dead };
    void hear(std::uint8_t byte);
    void obey(const falcon::Command& command);
    void say(std::span<const std::uint8_t> bytes);
    std::uint16_t its_baud() const;
    double bytes_per_ms() const;
    void move(double dt);
    glm::dvec3 pull() const;
    void pass_marks(const falcon::Angles& before, const falcon::Angles& after);

    std::vector<std::uint8_t> image_;
    FalconPlant plant_;
    std::uint64_t now_ms_ = 0;

    // The bridge.
    std::uint16_t baud_ = 0;
    std::uint16_t latency_ms_ = 16;
    bool dtr_ = false;
    std::uint64_t clear_from_ms_ = 0; ///< when CTS rises; never for 0
    std::deque<std::uint8_t> to_falcon_;
    std::deque<std::uint8_t> to_computer_;
    double in_hand_ = 0.0; ///< bytes that the line has had the time for
    std::uint64_t packet_due_ms_ = 0;
    std::deque<UsbPacket> packets_;

    // The processor behind it.
    State state_ = State::greeting;
    std::vector<std::uint8_t> heard_;
    int loads_begun_ = 0;
    bool spoiled_ = false; ///< what goes wrong in this load has
    std::uint64_t starts_at_ms_ = 0;
    falcon::PacketStream stream_;
    falcon::Command command_;
    std::uint64_t commanded_ms_ = 0;
    std::uint8_t homed_ = 0;
    std::array<double, 3> lost_counts_{}; ///< by which an arm that is not homed is off

    // The grip.
    falcon::Place place_ = falcon::middle;
    falcon::Angles angles_; ///< at place_
    falcon::Place hand_ = falcon::middle;
    glm::dvec3 velocity_{0.0}; ///< m/s
    glm::dvec3 force_{0.0};
};

} // namespace tp
