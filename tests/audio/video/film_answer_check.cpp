// SPDX-License-Identifier: Apache-2.0
#include "film_answer_check.hpp"

#include "audio/video/film_messages.hpp"
#include "core/files/file_words.hpp"
#include "core/processes/shared_memory.hpp"

#include <optional>

namespace tp::test {

namespace {

/// The memory may come with the answer, or have come with one before.
enum class Memory { comes, came };

Result<std::optional<FilmPicture>> answer_of(std::string_view bytes, Memory when) {
    const std::optional<SharedMemory> memory = SharedMemory::make(film_bytes(answered_side, answered_side));
    if (!memory)
        return Error{};
    Message message;
    message.bytes.assign(bytes.begin(), bytes.end());
    std::optional<Mapping> tray;
    if (when == Memory::comes)
        message.descriptors.push_back(memory->another());
    else
        tray = received(memory->another());
    return film_answer(message, tray);
}

std::string complaint_about(const Result<std::optional<FilmPicture>>& answer) {
    if (!answer)
        return answer.error().empty()                       ? "no picture and no sentence"
               : answer.error() != readable(answer.error()) ? "a sentence that cannot be shown"
                                                            : "";
    return *answer && (*answer)->planes.size() > film_bytes(answered_side, answered_side)
               ? "a picture of more pixels than there are"
               : "";
}

} // namespace

std::string complaint_about_film_answer(std::string_view bytes) {
    const std::string complaint = complaint_about(answer_of(bytes, Memory::comes));
    return complaint.empty() ? complaint_about(answer_of(bytes, Memory::came)) : complaint;
}

std::string kind_of_film_answer(std::string_view bytes) {
    const auto answer = answer_of(bytes, Memory::came);
    return !answer ? "sentence" : *answer ? "picture" : "end";
}

} // namespace tp::test
