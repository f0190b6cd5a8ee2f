// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tp {

/// Tells a newer reading of a device from one that came before, by the stamp that the device puts on it
/// (DeviceState::time), and says when it was taken on the servo's clock.
///
/// A stamp is compared with stamps and an arrival with arrivals, so that the device's clock may begin anywhere
/// and run up to 3 % fast or slow. A reading is newer where its stamp went on by as much as the servo's clock
/// since the last one, give or take `jitter`. A stamp that did anything else may be one broken reading, or the
/// first of a clock that was set, has wrapped or began again: it counts once a second reading goes on from it.
/// Where stamps keep jumping, as those of a few old readings that come over and over do, more must go on from it
/// each time. A reading that is too old by the device's own clock does not count. Allocates nothing; not
/// thread-safe.
class FreshReadings {
public:
    static constexpr double jitter = 0.005; ///< s by which one reading may come later than the last one did
    static constexpr double drift =
        0.03; ///< by which the device's clock may run fast or slow; 1/1024 s is no ms
    static constexpr double jumps = 5.0; ///< a second, that do not make it harder for the next to be believed

    /// `longest_lag`, s: how old a reading may be, by the device's own clock, when it comes.
    explicit FreshReadings(double longest_lag = 0.020) : longest_lag_(longest_lag) {}

    /// A reading with this stamp (s, the device's clock) came at `now` (s, the servo's clock). Returns when it
    /// was taken, s, the servo's clock: at most `now`, and later than the last one; nothing where the reading is
    /// no newer than the last one, or not known to be.
    std::optional<double> taken(double stamp, double now) noexcept;

private:
    struct Reading {
        double stamp = 0.0;   ///< s, the device's clock
        double arrival = 0.0; ///< s, the servo's clock
    };
    static bool follows(const Reading& before, const Reading& next) noexcept;
    void calm_down(double now) noexcept;
    bool confirms(const Reading& reading) noexcept;

    double longest_lag_;
    std::optional<Reading> last_;     ///< the newest of the device's clock
    std::optional<Reading> unlikely_; ///< the newest that does not follow it
    int confirmed_ = 0;               ///< readings that led up to that one without a jump
    double restless_ = 0.0;           ///< stamps that jumped of late
    double calmed_at_ = 0.0;          ///< s, the servo's clock
    double offset_ = 0.0;             ///< s from the device's clock to the servo's, by the quickest readings
    double taken_ = 0.0;              ///< s, the servo's clock, of the last one that counted
};

} // namespace tp
