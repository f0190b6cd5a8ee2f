// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "face_touch.hpp"
#include "places.hpp"
#include "shared_log.hpp"
#include "touch_session.hpp"
#include "virtual_device.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QtGlobal>

#include <csignal>
#include <cstddef>
#include <ctime>
#include <functional>
#include <set>
#include <string>
#include <unistd.h>

namespace tp::vm {

inline constexpr double tick = 0.001;        ///< s
inline constexpr double on_the_way = 0.002;  ///< s, of a report between two programs, at most
inline constexpr double ramp_down = 0.020;   ///< s, SafetyLimits
inline constexpr double stale_after = 0.020; ///< s, SafetyLimits
/// s: a guard steps in 50 ms after the last sign of life, which come before the end of a program whose memory
/// is large, and has its turn.
inline constexpr double guarded = 0.060;
inline constexpr double unfelt = 0.02;        ///< N, what rounding and the rest tension leave of no force
inline constexpr double round_the_face = 8.0; ///< s, in which a hand goes past every line
inline constexpr double a_minute = 60.0;      ///< s, more than seven times round

/// How long a face is felt with a device, s: "hid", "bulk", "stick" or "falcon". A second costs up to four of a
/// processor. TP_A_MINUTE_WITH names one for a minute, or "all".
inline double felt_for(const QString& device) {
    const QString asked = qEnvironmentVariable("TP_A_MINUTE_WITH");
    return asked == device || asked == "all" ? a_minute : round_the_face;
}

inline double now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline void pass(double seconds) { ::usleep(static_cast<unsigned>(1e6 * seconds)); }

/// Waits for a condition, for so many seconds of the machine's at most.
inline bool comes_true(const std::function<bool()>& condition, double within) {
    for (const double end = now() + within; now() < end; pass(5.0 * tick))
        if (condition())
            return true;
    return condition();
}

/// A virtual device with a hand that sweeps over a portrait, a program that touches with it, and what both
/// write down.
class TouchBench {
public:
    /// The device is plugged in at once. `words` come before the portrait and the log, `name` is the
    /// registry's.
    TouchBench(const QString& device_program, const QStringList& words, const QString& name)
        : device_log(file("device").toStdString()), snapshots(file("snapshots").toStdString()),
          sessions(file("sessions").toStdString()), name_(name) {
        device_.setProcessChannelMode(QProcess::ForwardedChannels);
        device_.start(beside(device_program), words + QStringList{test::in_source(portrait), file("device")});
        tell('p');
    }
    ~TouchBench() {
        for (QProcess* const process : {&toucher_, &device_}) {
            process->closeWriteChannel();
            process->waitForFinished(-1);
        }
    }
    TouchBench(const TouchBench&) = delete;
    TouchBench& operator=(const TouchBench&) = delete;

    static constexpr const char* portrait = "resources/samples/anna_smiling.truth.svg";

    /// A letter to the device, as serve() has them.
    void tell(char letter) {
        device_.write(&letter, 1);
        device_.waitForBytesWritten(-1);
    }
    void begin_to_touch() {
        toucher_.setProcessChannelMode(QProcess::ForwardedChannels);
        toucher_.start(beside("vm_touch_face"),
                       {name_, test::in_source(portrait), file("snapshots"), file("sessions")});
        toucher_.waitForStarted(-1);
    }
    bool end_touching() {
        toucher_.closeWriteChannel();
        return toucher_.waitForFinished(-1) && toucher_.exitStatus() == QProcess::NormalExit &&
               toucher_.exitCode() == 0;
    }
    void kill_toucher() {
        toucher_.kill();
        toucher_.waitForFinished(-1);
    }
    /// Until it is told to go on.
    void stop_toucher() { ::kill(static_cast<pid_t>(toucher_.processId()), SIGSTOP); }
    void go_on_touching() { ::kill(static_cast<pid_t>(toucher_.processId()), SIGCONT); }
    void terminate_toucher() {
        toucher_.terminate();
        toucher_.waitForFinished(-1);
    }
    /// The whole force is let in, and the device pulls its handle.
    bool pulls() {
        const auto by_both = [this] {
            if (snapshots.size() == 0)
                return false;
            const ServoSnapshot& last = snapshots[snapshots.size() - 1];
            return last.gain == 1.0 && length(last.force()) > 0.15 && length(feels()) > 0.15;
        };
        return comes_true(by_both, 60.0);
    }
    /// N, what the handle feels now.
    Vec2 feels() const { return device_log.size() > 0 ? device_log[device_log.size() - 1].force : Vec2(0.0); }

private:
    QString file(const char* log) const { return folder_.path() + '/' + log; }
    static QString beside(const QString& program) {
        return QCoreApplication::applicationDirPath() + '/' + program;
    }

    QTemporaryDir folder_; // before the logs, which lie in it

public:
    SharedLog<DeviceSample> device_log;
    SharedLog<ServoSnapshot> snapshots;
    SharedLog<TouchSession> sessions;

private:
    QString name_;
    QProcess device_;
    QProcess toucher_;
};

/// The last moment from `from` to `to`, s, at which the knob felt a force; `from` where there is none.
inline double last_pull(const SharedLog<DeviceSample>& log, double from, double to) {
    double last = from;
    for (std::size_t i = 0; i < log.size(); ++i)
        if (log[i].time > from && log[i].time < to && length(log[i].force) > unfelt)
            last = log[i].time;
    return last;
}

/// The first tick after `from` with this fault, and the last with a force, s; 0 where there is none.
struct Fall {
    double noticed = 0.0;
    double last_force = 0.0;
};
inline Fall fall_after(const SharedLog<ServoSnapshot>& log, double from, double to, Fault fault) {
    Fall fall;
    for (std::size_t i = 0; i < log.size(); ++i) {
        if (log[i].time < from || log[i].time > to)
            continue;
        if (log[i].fault == fault && fall.noticed == 0.0)
            fall.noticed = log[i].time;
        if (log[i].force() != Vec2(0.0))
            fall.last_force = log[i].time;
    }
    return fall;
}

/// The contours that drew the hand with more than 0.1 N from `from` to `to`, s.
inline std::set<int> contours_felt(const SharedLog<ServoSnapshot>& log, double from, double to) {
    std::set<int> felt;
    for (std::size_t i = 0; i < log.size(); ++i)
        if (log[i].time >= from && log[i].time <= to && length(log[i].force()) > 0.1)
            felt.insert(log[i].contour);
    return felt;
}

/// What a person was told of faults from `from` to `to`, s; empty where there was none.
inline QString told_faults(const SharedLog<ServoSnapshot>& log, double from, double to) {
    std::set<Fault> faults;
    for (std::size_t i = 0; i < log.size(); ++i)
        if (log[i].time >= from && log[i].time <= to && log[i].fault != Fault::none)
            faults.insert(log[i].fault);
    QStringList sentences;
    for (const Fault fault : faults)
        sentences << sentence(fault);
    return sentences.join(' ');
}

/// How many contours there are to feel; 0 where the portrait cannot be read.
inline std::size_t contours_of_the_face() {
    const auto face = face_of(test::in_source(TouchBench::portrait));
    return face.ok() ? face->contours.size() : 0;
}

/// What touchphoto-lab prints, and what it complains of.
struct LabRun {
    int status = -1; ///< of its exit; -1: it did not end by itself
    QString printed;
    QString complaints;
};
inline LabRun run_lab(const QStringList& words) {
    QProcess lab;
    lab.start(QCoreApplication::applicationDirPath() + "/../../bin/touchphoto-lab", words);
    if (!lab.waitForFinished(-1) || lab.exitStatus() != QProcess::NormalExit)
        return {};
    return {lab.exitCode(), QString::fromUtf8(lab.readAllStandardOutput()),
            QString::fromUtf8(lab.readAllStandardError())};
}

/// The number behind a word at the beginning of a line of touchphoto-lab; -1 where there is none.
inline double told_number(const QString& printed, const QString& word) {
    for (const QString& line : printed.split('\n'))
        if (line.section(' ', 0, 0) == word)
            return line.section(' ', 1, 1, QString::SectionSkipEmpty).toDouble();
    return -1.0;
}

/// Waits until touchphoto-lab lists the device, then lets it read the device for a second: what it says where
/// it read fewer than 950 ticks or ended badly, empty where all is well.
inline QString what_the_lab_misses(const QString& name) {
    LabRun listed;
    const auto in_the_list = [&] {
        listed = run_lab({"devices", "--json"});
        return listed.printed.contains("\"name\":\"" + name + '"');
    };
    if (!comes_true(in_the_list, 10.0))
        return "not listed: " + listed.printed + listed.complaints;
    const LabRun read = run_lab({"devices", "test", name, "--seconds", "1"});
    const double ticks = told_number(read.printed, "ticks");
    return read.status == 0 && ticks >= 950.0 ? QString() : read.printed + read.complaints;
}

inline void say(const char* what, double ms) { qInfo("%s: %.2f ms", what, ms); }

} // namespace tp::vm
