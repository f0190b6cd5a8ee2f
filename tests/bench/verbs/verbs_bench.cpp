// SPDX-License-Identifier: Apache-2.0
// How soon each verb of touchphoto-lab that can take long tells the person something, and ends at Ctrl-C.
#include "long_verbs.hpp"

#include <QElapsedTimer>
#include <QFile>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

using tp::test::LongVerb;
using tp::test::LongWorkInputs;

namespace {

constexpr int longest_silence_ms = 120'000;
constexpr int longest_answer_ms = 60'000;

/// Seconds.
struct Press {
    double first_line = 0.0, end = 0.0;
    double busy_end = 0.0; ///< of processors, in `end`
};

double load() {
    std::array<double, 1> average{};
    return ::getloadavg(average.data(), 1) == 1 ? average[0] : 0.0;
}

/// Of processes that have ended.
double busy_of_ended() {
    struct rusage used {};
    ::getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Of a process that runs, so far.
double busy_of(qint64 process) {
    QFile file(QStringLiteral("/proc/%1/stat").arg(process));
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    const QByteArray all = file.readAll();
    const QList<QByteArray> fields = all.mid(all.lastIndexOf(')') + 2).split(' ');
    return (fields.value(11).toDouble() + fields.value(12).toDouble()) /
           static_cast<double>(::sysconf(_SC_CLK_TCK));
}

double seconds(const QElapsedTimer& timer) { return 1e-9 * static_cast<double>(timer.nsecsElapsed()); }

/// Nothing where the verb had ended before, or not as one that was stopped.
std::optional<Press> press(const LongWorkInputs& inputs, const LongVerb& verb, int later_ms) {
    Press result;
    QProcess process;
    const double before = busy_of_ended();
    QElapsedTimer timer;
    timer.start();
    inputs.start(process, verb);
    if (!process.waitForReadyRead(longest_silence_ms))
        return std::nullopt;
    result.first_line = seconds(timer);
    process.waitForFinished(later_ms);
    if (process.state() != QProcess::Running)
        return std::nullopt;
    const double busy = busy_of(process.processId());
    timer.restart();
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    if (!process.waitForFinished(longest_answer_ms) || process.exitCode() != 130)
        return std::nullopt;
    result.end = seconds(timer);
    result.busy_end = std::max(0.0, busy_of_ended() - before - busy);
    return result;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

} // namespace

int main(int argc, char** argv) {
    const int presses = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
    const QString only = argc > 2 ? QString::fromLocal8Bit(argv[2]) : QString();
    const LongWorkInputs inputs;
    std::mt19937 random(1);
    std::printf("| verb | first line, at the latest | ended after Ctrl-C, median | at the latest | "
                "processors' time in it "
                "| load |\n| --- | --: | --: | --: | --: | --: |\n");
    double latest_line = 0.0, latest_end = 0.0;
    for (const LongVerb& verb : inputs.verbs()) {
        if (!verb.name.startsWith(only))
            continue;
        std::vector<double> lines, ends, busy;
        for (int i = 0; i < presses; ++i) {
            if (const auto one = press(inputs, verb, static_cast<int>(random() % 2'000))) {
                lines.push_back(one->first_line);
                ends.push_back(one->end);
                busy.push_back(one->busy_end);
            }
            inputs.remove_left(); // so that the next one does not go on there
        }
        if (ends.empty()) {
            std::printf("| `%s` | it was never stopped | | | | %.1f |\n", qPrintable(verb.name), load());
            continue;
        }
        latest_line = std::max(latest_line, std::ranges::max(lines));
        latest_end = std::max(latest_end, std::ranges::max(ends));
        std::printf("| `%s` | %.2f s | %.2f s | %.2f s | %.2f s | %.1f |\n", qPrintable(verb.name),
                    std::ranges::max(lines), median(ends), std::ranges::max(ends), std::ranges::max(busy),
                    load());
        if (ends.size() < static_cast<std::size_t>(presses))
            std::fprintf(stderr, "%s: only %zu of %d were in time to stop it\n", qPrintable(verb.name),
                         ends.size(), presses);
        std::fflush(stdout);
    }
    std::printf("| all | %.2f s | | %.2f s | | |\n", latest_line, latest_end);
    return 0;
}
