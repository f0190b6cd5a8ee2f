// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what a decoder of videos answers, with memory for 10 x 10 pixels.
#include "audio/video/film_messages.hpp"
#include "core/processes/shared_memory.hpp"
#include "fuzz_target.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace {

std::string complaint_about_answer(std::string_view bytes) {
    const std::optional<tp::SharedMemory> memory = tp::SharedMemory::make(tp::film_bytes(10, 10));
    if (!memory)
        return "there is no memory to share";
    tp::Message message;
    message.bytes.assign(bytes.begin(), bytes.end());
    message.descriptors.push_back(memory->another());
    std::optional<tp::Mapping> tray;
    const auto answer = tp::film_answer(message, tray);
    if (!answer)
        return answer.error().empty() ? "no picture and no sentence" : "";
    return *answer && (*answer)->planes.size() > memory->size() ? "a picture of more pixels than there are"
                                                                : "";
}

} // namespace

TP_FUZZ_TARGET(complaint_about_answer)
