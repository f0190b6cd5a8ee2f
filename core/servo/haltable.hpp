// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// What a dying program must switch off first (ExitGuard): a device with a force, an output under a bare finger.
class Haltable {
public:
    /// Nothing comes out of it any more, at once; it stays open. Any thread, at any moment, and from a signal handler
    /// (signal-safety(7): no lock, no allocation).
    virtual void halt() noexcept = 0;

protected:
    ~Haltable() = default;
};

} // namespace tp
