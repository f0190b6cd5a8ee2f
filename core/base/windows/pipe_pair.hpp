// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/windows/overlapped_io.hpp"

#include <optional>
#include <utility>

namespace tp::windows {

/// Both ends of a pipe of this computer's that carries bytes both ways, for overlapped_io.hpp. `kind` is PIPE_TYPE_BYTE, or
/// PIPE_TYPE_MESSAGE | PIPE_READMODE_MESSAGE, where what is written at once is read at once; `bytes` wait in it each way. None
/// where the system has no room for them.
std::optional<std::pair<Handle, Handle>> pipe_pair(DWORD kind, DWORD bytes);

} // namespace tp::windows
