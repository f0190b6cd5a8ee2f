// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <initializer_list>
#include <linux/input.h>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tp::vm {

/// An input device of this kernel whose motor a thread here is (linux/uinput.h): what it is asked to keep, to play and to end.
class UinputMotor {
public:
    enum class Happening { kept, began, ended, forgotten };
    struct Moment {
        double time = 0.0; ///< s, the machine's monotonic clock
        Happening what = Happening::kept;
        int id = -1;
        ff_effect effect{}; ///< of what is kept
    };

    /// It can play `bits` (FF_…), and keeps `places` effects.
    UinputMotor(const std::string& name, std::initializer_list<int> bits, unsigned places = 16);
    ~UinputMotor();
    UinputMotor(const UinputMotor&) = delete;
    UinputMotor& operator=(const UinputMotor&) = delete;

    bool good() const { return file_ >= 0; }
    void unplug();
    /// From now on it takes so long to keep an effect, s.
    void be_slow(double seconds) { slow_s_ = seconds; }
    std::vector<Moment> moments() const;
    std::optional<Moment> last(Happening what) const;
    int count(Happening what) const;

private:
    void serve();
    void keep(unsigned request);
    void forget(unsigned request);
    void note(Happening what, int id, const ff_effect& effect = {});

    int file_ = -1;
    std::atomic<bool> quit_{false};
    std::atomic<double> slow_s_{0.0};
    mutable std::mutex mutex_; ///< of moments_
    std::vector<Moment> moments_;
    std::thread motor_;
};

} // namespace tp::vm
