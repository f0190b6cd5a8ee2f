// SPDX-License-Identifier: Apache-2.0
#include "metadata_answer_check.hpp"

#include "core/processes/message.hpp"
#include "core/processes/shared_memory.hpp"
#include "faces/exiv2/metadata_messages.hpp"

#include <cstdint>
#include <cstring>

namespace tp::test {

namespace {

std::string complaint_about(const std::optional<StatedMetadata>& stated, std::size_t answered_bytes) {
    if (!stated)
        return {};
    if (stated->width < 0 || stated->height < 0 ||
        (stated->orientation && (*stated->orientation < 1 || *stated->orientation > 8)))
        return "a shape that no picture has";
    std::size_t bytes = stated->taken.size() + stated->taken_offset.size() + stated->date.size() +
                        stated->time.size() + stated->caption.size() + stated->xmp.size();
    for (const auto* const list : {&stated->keywords, &stated->places})
        for (const std::string& text : *list)
            bytes += text.size();
    return bytes > answered_bytes ? "longer texts than were answered" : "";
}

} // namespace

std::optional<StatedMetadata> stated_in_message(std::string_view bytes) {
    Message message;
    message.bytes.assign(bytes.begin(), bytes.end());
    return metadata_in(message);
}

std::optional<StatedMetadata> stated_in_memory(std::string_view bytes) {
    const auto memory = SharedMemory::make(bytes.size());
    if (!memory)
        return std::nullopt;
    std::memcpy(memory->data(), bytes.data(), bytes.size());
    Message message =
        MessageWriter().add(static_cast<std::int64_t>(bytes.size())).hand_over(memory->another()).take();
    return metadata_in(message);
}

std::string complaint_about_metadata_answer(std::string_view bytes) {
    const std::string complaint = complaint_about(stated_in_message(bytes), bytes.size());
    return complaint.empty() ? complaint_about(stated_in_memory(bytes), bytes.size()) : complaint;
}

} // namespace tp::test
