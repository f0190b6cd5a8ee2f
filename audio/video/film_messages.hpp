// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/video/film_stream.hpp"
#include "core/base/descriptor.hpp"
#include "core/base/result.hpp"
#include "core/processes/message.hpp"
#include "core/processes/shared_memory.hpp"

#include <cstdint>
#include <optional>

namespace tp {

/// What is asked of a helper that decodes the pictures of a video.
struct FilmQuestion {
    enum class What : std::uint8_t {
        open,  ///< `file`, all of its `size` bytes; answered by its first picture
        next,  ///< the next picture of the one that is open
        forget ///< that one; not answered
    };
    What what = What::forget;
    std::int64_t size = 0;    ///< bytes
    std::int64_t from_us = 0; ///< a picture before that is passed over
    Descriptor file;
};
Message message_of(FilmQuestion question);
/// None where it is no such question.
std::optional<FilmQuestion> film_question(MessageReader& message);

/// Memory in which one picture after the other is handed to another process; kept, because new memory costs more than copying.
class FilmTray {
public:
    /// A picture, no picture because the film is over, or the end of a sentence.
    Message message_of(const Result<std::optional<FilmPicture>>& picture);

private:
    std::optional<SharedMemory> memory_;
};

/// Believed is only what can be true: a helper may have been taken over by what it decoded. `tray` is what that helper has
/// handed over.
Result<std::optional<FilmPicture>> film_answer(Message& message, std::optional<Mapping>& tray);

} // namespace tp
