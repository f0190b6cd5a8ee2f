// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>

namespace tp {

/// What every verb does for the person who waits; `run_lab` runs each inside one. After two seconds without a
/// line on stderr it says there how far the work is, behind "… ", and again every two seconds. Ctrl-C or SIGTERM asks for
/// an end in good order; a verb that does not come to it soon is ended, whatever it is in, and its files that
/// are not whole go (core/files/new_file.hpp).
///
/// The static functions may be called from any thread, also where none lives.
class LongWork {
public:
    /// `verb`: what is said to be at work where the verb says nothing better.
    explicit LongWork(std::string verb);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    /// What is being done, such as "reading the scene".
    static void step(std::string what);
    /// How much of the step is done, 0 to 1.
    static void share(double done);
    /// The step is one of `all` like it, the `number`th: a photograph, say.
    static void item(std::string what, std::size_t number, std::size_t all);
    /// A line went to stderr, so that the person knows for a while.
    static void said();

    /// The person wants an end.
    static const std::atomic<bool>& stop_asked();
    static std::stop_token stop_token();
    /// What the verb ends in then.
    static int stop_code();
};

/// While one lives, the person is waited for and told nothing.
class PersonsTurn {
public:
    PersonsTurn();
    ~PersonsTurn();
    PersonsTurn(const PersonsTurn&) = delete;
    PersonsTurn& operator=(const PersonsTurn&) = delete;
};

/// While one lives, what is said or done where a verb is ended that did not come to its end by itself; called
/// from another thread, and nothing of the verb ends meanwhile. It is to take a fraction of a second: the person waits.
class LastWords {
public:
    enum class Said {
        late,   ///< where the verb does not come to its end soon
        at_once ///< it never does by itself
    };
    explicit LastWords(std::function<void()> words, Said said = Said::late);
    ~LastWords();
    LastWords(const LastWords&) = delete;
    LastWords& operator=(const LastWords&) = delete;
};

} // namespace tp
