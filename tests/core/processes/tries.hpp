// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/processes/shared_memory.hpp"

#include <string>

/// Tries what a confined process must not be able to do, or must still be able to, by its name; `shared` is what this process
/// shares. 0 where it could be done, else what the system says; −1 where nothing is called so.
int tried(const std::string& what, const tp::SharedMemory* shared);
