// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pad_reading.hpp"
#include "shared_log.hpp"
#include "virtual_device.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <unistd.h>

namespace tp::vm {

/// s, the machine's monotonic clock.
inline double clock_now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A virtual pad under a finger, a program that feels with it, and what both write down.
class PadBench {
public:
    /// The pad is plugged in at once. `name` is the registry's.
    PadBench(const QString& device_program, const QStringList& words, const QString& name)
        : device_log(file("device").toStdString()), readings(file("readings").toStdString()), name_(name) {
        device_.setProcessChannelMode(QProcess::ForwardedChannels);
        device_.start(beside(device_program), words + QStringList{file("device")});
        tell('p');
    }
    ~PadBench() {
        for (QProcess* const process : {&feeler_, &device_}) {
            process->closeWriteChannel();
            process->waitForFinished(-1);
        }
    }
    PadBench(const PadBench&) = delete;
    PadBench& operator=(const PadBench&) = delete;

    /// A letter to the pad, as serve() has them.
    void tell(char letter) {
        device_.write(&letter, 1);
        device_.waitForBytesWritten(-1);
    }
    void begin_to_feel() {
        feeler_.setProcessChannelMode(QProcess::ForwardedChannels);
        feeler_.start(beside("vm_feel_pad"), {name_, file("readings")});
        feeler_.waitForStarted(-1);
    }
    void kill_feeler() {
        feeler_.kill();
        feeler_.waitForFinished(-1);
    }
    bool end_feeling() {
        feeler_.closeWriteChannel();
        return feeler_.waitForFinished(-1) && feeler_.exitStatus() == QProcess::NormalExit &&
               feeler_.exitCode() == 0;
    }
    /// Waits for a condition, for so many seconds of the machine's at most.
    static bool comes_true(const std::function<bool()>& condition, double within) {
        for (const double end = clock_now() + within; clock_now() < end; ::usleep(5000))
            if (condition())
                return true;
        return condition();
    }
    /// `count` more ticks were sent.
    bool feels(std::size_t count) const {
        const std::size_t before = ticks();
        return comes_true([&] { return ticks() >= before + count; }, 30.0);
    }
    std::size_t ticks() const { return readings.size() > 0 ? readings[readings.size() - 1].ticks : 0; }
    bool lost() const { return readings.size() > 0 && readings[readings.size() - 1].lost; }
    const DeviceSample& device_now() const { return device_log[device_log.size() - 1]; }

    /// What was felt at the lines that the finger crossed from `from` to `to`, s.
    struct Felt {
        int lines = 0;           ///< crossed
        int missed = 0;          ///< with nothing felt within 50 ms
        double latest_s = 0.0;   ///< from a line to its tick
        int elsewhere = 0;       ///< ticks that began away from every line
        double longest_s = 0.0;  ///< at a stretch
        bool other_side = false; ///< the pad without a finger swung too
    };
    Felt felt(double from, double to) const {
        Felt felt;
        const auto line_at = [this](std::size_t i) {
            return std::floor(device_log[i].handle.x / line_every_mm);
        };
        const auto swings = [this](std::size_t i) { return device_log[i].force.x > 0.0; };
        double crossed = -1.0;
        double began = 0.0;
        for (std::size_t i = 1; i < device_log.size(); ++i) {
            const double time = device_log[i].time;
            if (time < from || time > to)
                continue;
            if (line_at(i) != line_at(i - 1)) {
                ++felt.lines;
                felt.missed += crossed >= 0.0 ? 1 : 0;
                crossed = time;
            }
            if (swings(i) && !swings(i - 1)) {
                began = time;
                if (crossed < 0.0 || time - crossed > 0.05)
                    ++felt.elsewhere;
                else
                    felt.latest_s = std::max(felt.latest_s, time - crossed);
                crossed = -1.0;
            }
            if (swings(i) && began > 0.0)
                felt.longest_s = std::max(felt.longest_s, time - began);
            felt.other_side = felt.other_side || device_log[i].force.y > 0.0;
        }
        return felt;
    }

private:
    QString file(const char* log) const { return folder_.path() + '/' + log; }
    static QString beside(const QString& program) {
        return QCoreApplication::applicationDirPath() + '/' + program;
    }

    QTemporaryDir folder_; // before the logs, which lie in it

public:
    SharedLog<DeviceSample> device_log;
    SharedLog<PadReading> readings;

private:
    QString name_;
    QProcess device_;
    QProcess feeler_;
};

inline constexpr double longest_tick = 0.05; ///< s, Tick::longest_s

inline void say(const PadBench::Felt& felt, const PadBench& bench) {
    qInfo("%d lines, the latest tick after %.1f ms, the longest of %.1f ms; the longest call of the pad %.2f "
          "ms",
          felt.lines, 1e3 * felt.latest_s, 1e3 * felt.longest_s,
          1e3 * bench.readings[bench.readings.size() - 1].longest_call_s);
}

/// The last moment from `from` to `to`, s, at which the finger felt a tick; `from` where there is none.
inline double last_tick(const SharedLog<DeviceSample>& log, double from, double to) {
    double last = from;
    for (std::size_t i = 0; i < log.size(); ++i)
        if (log[i].time > from && log[i].time < to && log[i].force != Vec2(0.0))
            last = log[i].time;
    return last;
}

} // namespace tp::vm
