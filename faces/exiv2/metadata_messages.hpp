// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"
#include "core/processes/message.hpp"
#include "faces/exiv2/stated_metadata.hpp"

#include <optional>

namespace tp {

/// What is asked of a helper that reads metadata: of a file that is open for reading.
Message metadata_question(Descriptor file);

/// The helper's end: the answer to such a question; none where none is wanted.
std::optional<Message> metadata_answer(MessageReader& question);

/// What it answers. What is too long for a message lies in memory that is handed over.
Message message_of(const std::optional<StatedMetadata>& stated);
/// Nothing is read that cannot be: a helper may have been taken over by what it read. None where it found nothing, or
/// this is no such answer.
std::optional<StatedMetadata> metadata_in(Message& answer);

} // namespace tp
