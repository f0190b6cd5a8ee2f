// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>

namespace tp {

/// What pages of this program give back, in the order in which they do: a page opens an output only when those before it have
/// let go of theirs, so that no two ever hold one. Any thread.
class GivingBack {
public:
    /// The one of this program.
    static GivingBack& here();

    /// Something is going to be given back; its number, for `ended`.
    std::uint64_t begin();
    void ended(std::uint64_t number);
    /// What was begun by now.
    std::uint64_t begun() const;
    /// Waits until all of these, by `begun`, have ended.
    void wait_for(std::uint64_t begun);

private:
    mutable std::mutex mutex_;
    std::condition_variable ended_;
    std::uint64_t begun_ = 0;
    std::set<std::uint64_t> under_way_;
};

} // namespace tp
