// SPDX-License-Identifier: Apache-2.0
#include "picture_answer_check.hpp"

#include "core/files/file_words.hpp"
#include "core/processes/shared_memory.hpp"
#include "faces/decode/picture_messages.hpp"

#include <optional>

namespace tp::test {

namespace {

/// The memory may come with the answer, or have come with one before.
enum class Memory { comes, came };

Result<PictureAnswer> answer_of(std::string_view bytes, Memory when) {
    const std::optional<SharedMemory> memory = SharedMemory::make(3 * answered_side * answered_side);
    if (!memory)
        return Error{};
    Message message;
    message.bytes.assign(bytes.begin(), bytes.end());
    std::optional<Mapping> tray;
    if (when == Memory::comes)
        message.descriptors.push_back(memory->another());
    else
        tray = received(memory->another());
    return picture_answer(message, tray);
}

std::string complaint_about(const Result<PictureAnswer>& answer) {
    if (!answer)
        return answer.error().empty()                       ? "no picture and no sentence"
               : answer.error() != readable(answer.error()) ? "a sentence that cannot be shown"
                                                            : "";
    return answer->pixels.empty() || answer->pixels.total() > answered_side * answered_side
               ? "a picture of more pixels than there are"
               : "";
}

} // namespace

std::string complaint_about_picture_answer(std::string_view bytes) {
    const std::string complaint = complaint_about(answer_of(bytes, Memory::comes));
    return complaint.empty() ? complaint_about(answer_of(bytes, Memory::came)) : complaint;
}

bool is_picture_answer(std::string_view bytes) {
    return answer_of(bytes, Memory::comes).ok() && answer_of(bytes, Memory::came).ok();
}

} // namespace tp::test
