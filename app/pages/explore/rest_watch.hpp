// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tp {

/// When nothing has been going on for so long that nothing need tick.
class RestWatch {
public:
    static constexpr double after_s = 2.0;

    /// Asked at each poll; `now` in s. True from `after_s` of quiet on.
    bool due(bool quiet, double now) {
        if (!quiet)
            since_.reset();
        else if (!since_)
            since_ = now;
        return since_ && now - *since_ >= after_s;
    }
    /// Something was done: the quiet begins anew.
    void stir() { since_.reset(); }

private:
    std::optional<double> since_; ///< s, when it became quiet
};

} // namespace tp
