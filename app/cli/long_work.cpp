// SPDX-License-Identifier: Apache-2.0
#include "app/cli/long_work.hpp"

#include "app/cli/batch_progress.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/new_file.hpp"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>

namespace tp {

namespace {

using Steady = std::chrono::steady_clock;

constexpr std::chrono::seconds patience{2};          ///< of a person who is told nothing
constexpr std::chrono::milliseconds glance{50};      ///< between two looks at the signal
constexpr std::chrono::milliseconds good_order{200}; ///< for a verb to end by itself

/// How far the verb is, for whoever asks.
class HowFar {
public:
    void begin(std::string verb) {
        const std::lock_guard lock(mutex_);
        what_ = std::move(verb);
        done_ = 0.0;
        number_ = all_ = 0;
        said_ = began_ = Steady::now();
    }
    void step(std::string what) {
        const std::lock_guard lock(mutex_);
        if (what == what_ && all_ == 0)
            return;
        what_ = std::move(what);
        done_ = 0.0;
        number_ = all_ = 0;
        began_ = Steady::now();
    }
    void share(double done) {
        const std::lock_guard lock(mutex_);
        done_ = done;
    }
    void item(std::string what, std::size_t number, std::size_t all) {
        const std::lock_guard lock(mutex_);
        if (all != all_ || number <= 1)
            began_ = Steady::now();
        what_ = std::move(what);
        done_ = 0.0;
        number_ = number;
        all_ = all;
    }
    void said() {
        const std::lock_guard lock(mutex_);
        said_ = Steady::now();
    }
    /// The person's time does not count.
    void wait_for_person(int more) {
        const std::lock_guard lock(mutex_);
        const Steady::time_point now = Steady::now();
        if (persons_turns_ == 0)
            turn_began_ = now;
        persons_turns_ += more;
        if (persons_turns_ == 0) {
            said_ += now - turn_began_;
            began_ += now - turn_began_;
        }
    }

    /// The line that is due, if one is.
    std::optional<std::string> due() {
        const std::lock_guard lock(mutex_);
        const Steady::time_point now = Steady::now();
        if (persons_turns_ > 0 || now - said_ < patience)
            return std::nullopt;
        said_ = now;
        return line(std::chrono::duration<double>(now - began_).count());
    }

private:
    std::string line(double seconds) const {
        if (all_ > 0)
            return std::to_string(number_) + " of " + std::to_string(all_) + ": " + what_ +
                   behind_comma(time_left(number_ - 1, all_, seconds));
        if (done_ > 0.0)
            return what_ + ": " + std::to_string(std::lround(100.0 * done_)) + " %" +
                   behind_comma(time_left(static_cast<std::size_t>(1e6 * done_), 1'000'000, seconds));
        return seconds < 1.0 ? what_ : what_ + ", for " + std::to_string(std::lround(seconds)) + " s";
    }
    static std::string behind_comma(const std::string& words) { return words.empty() ? "" : ", " + words; }

    std::mutex mutex_;
    std::string what_;
    double done_ = 0.0;
    std::size_t number_ = 0, all_ = 0;
    Steady::time_point began_ = Steady::now(), said_ = began_, turn_began_ = began_;
    int persons_turns_ = 0;
};

HowFar how_far;
std::stop_source stop_wanted;
std::optional<StopSignal> heeding;
std::mutex last_words_mutex; ///< held from the last words to the end
std::function<void()> last_words;
bool said_at_once = false;

/// Looks after the verb from a thread of its own, so that it need not look itself.
class Watch {
public:
    Watch() : thread_([this] { run(); }) {}
    ~Watch() {
        {
            const std::lock_guard lock(mutex_);
            over_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }

private:
    void run() {
        while (!over_within(glance)) {
            if (StopSignal::asked()) {
                stop_wanted.request_stop();
                if (end_is_due_at_once() || !over_within(good_order))
                    end_now();
                return;
            }
            if (const auto line = how_far.due())
                print_to(stderr, "… %s\n", line->c_str());
        }
    }
    bool over_within(std::chrono::milliseconds time) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, time, [this] { return over_; });
    }
    static bool end_is_due_at_once() {
        const std::lock_guard lock(last_words_mutex);
        return said_at_once;
    }
    [[noreturn]] static void end_now() {
        const std::lock_guard lock(last_words_mutex);
        if (last_words)
            last_words();
        NewFile::give_up_all();
        std::quick_exit(StopSignal::exit_code()); // the verb's own things are in use
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    bool over_ = false;
    std::thread thread_;
};

std::optional<Watch> watching;

} // namespace

LongWork::LongWork(std::string verb) {
    how_far.begin(std::move(verb));
    stop_wanted = std::stop_source();
    heeding.emplace();
    watching.emplace();
}

LongWork::~LongWork() {
    watching.reset();
    heeding.reset();
}

void LongWork::step(std::string what) { how_far.step(std::move(what)); }
void LongWork::share(double done) { how_far.share(done); }
void LongWork::item(std::string what, std::size_t number, std::size_t all) {
    how_far.item(std::move(what), number, all);
}
void LongWork::said() { how_far.said(); }

const std::atomic<bool>& LongWork::stop_asked() { return StopSignal::asked(); }
std::stop_token LongWork::stop_token() { return stop_wanted.get_token(); }
int LongWork::stop_code() { return StopSignal::exit_code(); }

LastWords::LastWords(std::function<void()> words, Said said) {
    const std::lock_guard lock(last_words_mutex);
    last_words = std::move(words);
    said_at_once = said == Said::at_once;
}
LastWords::~LastWords() {
    const std::lock_guard lock(last_words_mutex);
    last_words = {};
    said_at_once = false;
}

PersonsTurn::PersonsTurn() { how_far.wait_for_person(1); }
PersonsTurn::~PersonsTurn() { how_far.wait_for_person(-1); }

} // namespace tp
