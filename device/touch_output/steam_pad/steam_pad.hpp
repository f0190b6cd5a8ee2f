// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_output.hpp"
#include "device/latest_writer.hpp"
#include "device/touch_output/steam_pad/steam_transport.hpp"
#include "device/touch_output/writer_watch.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tp {

/// What is handed to the writer.
struct SteamMail {
    steam::Pulses pulses;
    steam::Side side = steam::Side::right;
    std::uint8_t tick = 0;    ///< number of the pulses, to 127; 0: nothing is to be felt
    std::uint8_t renewal = 0; ///< number of the newest renewal of what keeps the pads from imitating a mouse
};

/// A pad of a Steam Deck or Steam Controller: where the thumb lies, and ticks under that thumb. The pad that is touched is the one
/// that is felt; with both, the one that was touched first.
///
/// Reading never waits, and sending is a LatestWriter's. Keys and mouse are imitated by nothing as long as it is open.
class SteamPad final : public TouchOutput {
public:
    using Opener = std::function<Result<std::unique_ptr<SteamTransport>>()>;

    /// s from a tick that is told to one that is felt: longer by radio. An estimate.
    static double delay_s(steam::Kind kind) { return kind == steam::Kind::receiver ? 0.020 : 0.008; }

    /// `openers` in turn, until behind one of them a controller answers: a receiver has several.
    explicit SteamPad(std::vector<Opener> openers, std::string serial_number = {},
                      LatestWriter::Thread thread = LatestWriter::Thread::own);
    ~SteamPad() override;
    SteamPad(const SteamPad&) = delete;
    SteamPad& operator=(const SteamPad&) = delete;

    Result<TouchCapabilities> open() override;
    std::optional<PadTouch> read(double now) noexcept override;
    /// It has only ticks.
    bool resist(double) noexcept override { return open_ && !lost(); }
    bool tick(const Tick& tick) noexcept override;
    void halt() noexcept override;
    /// Waits a second at most for a writer that hangs in the system. The pads imitate a mouse again afterwards.
    void stop() noexcept override;
    bool lost() const noexcept override { return writer_ && writer_->lost(); }
    std::string complaint() const override;

    /// The writer's step, for LatestWriter::Thread::caller.
    void deliver() noexcept;

private:
    /// What the writer shares with the rest.
    struct Line final : LatestWriter::Sink {
        std::unique_ptr<SteamTransport> transport;
        std::atomic<bool> refuses{false};
        std::atomic<std::uint32_t> sent{0}; ///< messages
        std::uint8_t tick = 0;    ///< number of the last one, 0 where nothing is felt; only the writer
        std::uint8_t renewal = 0; ///< number of the last one; only the writer

        bool send(std::uint64_t message) noexcept override;
        bool send_all(const std::array<steam::Feature, 2>& reports) noexcept;
    };
    enum class Trouble : std::uint8_t { none, unplugged, switched_off };

    Result<bool> begin(const Opener& opener);
    void take(const steam::News& news, double now) noexcept;
    void keep_up(double now) noexcept;
    void post() noexcept;

    std::vector<Opener> openers_;
    std::string serial_number_;
    LatestWriter::Thread thread_;
    std::shared_ptr<Line> line_;
    std::unique_ptr<LatestWriter> writer_; ///< stays until the next open, for halt() from anywhere
    bool open_ = false;
    std::atomic<steam::Kind> kind_{steam::Kind::deck};
    std::atomic<Trouble> trouble_{Trouble::none};
    std::atomic<bool> halted_{false};
    std::atomic<bool> refuses_{false};
    WriterWatch watch_;

    // Only the caller's thread.
    steam::Side side_ = steam::Side::right;
    PadTouch touch_;
    bool fresh_ = false; ///< a reading in this read
    std::optional<double> renewed_;
    SteamMail mail_;
};

} // namespace tp
