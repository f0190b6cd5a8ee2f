// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/processes/confinement.hpp"
#include "core/processes/message.hpp"

#include <functional>
#include <optional>

namespace tp {

/// What a helper does (helper.hpp) once it has loaded all that it needs: confines itself, says on
/// descriptor 3 that it is ready, or why it is not, and gives each message's answer, none for what needs
/// none, until nobody asks any more. What computes longer than `seconds` for one answer is ended by the
/// kernel, also where nobody waits for it any more; on Windows it ends with the program that asked.
void answer_messages(const Limits& limits, int seconds,
                     const std::function<std::optional<Message>(Message& question)>& answer);

} // namespace tp
