// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp::test {

/// Whether the system is Wine's.
extern const bool in_wine;

/// How many processes this one has started and not yet waited for; −1 where the system does not say.
int own_processes();

/// Kills them and waits until they have ended, which leaves their ends to whoever started them. How many there were.
int kill_own_processes();

} // namespace tp::test
