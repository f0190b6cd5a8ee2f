// SPDX-License-Identifier: Apache-2.0
#include "recording_check.hpp"

#include "device/recording/touch_recording.hpp"

#include <cstdint>

namespace tp::test {

std::string complaint_about_recording(std::string_view bytes) {
    const Result<TouchRecording> read = parse_recording(bytes);
    if (!read.ok())
        return read.error().empty() ? "refused without a word" : "";
    const TouchRecording& recording = read.value();
    if (recording.bytes_left > bytes.size())
        return "more is left than there was";
    std::string again = recording_header(recording.device);
    for (std::size_t i = 0; i < recording.ticks.size(); ++i) {
        const auto tick = recorded_bytes(recording.ticks[i], static_cast<std::uint32_t>(i));
        again.append(tick.data(), tick.size());
    }
    const Result<TouchRecording> twice = parse_recording(again);
    if (!twice.ok() || twice.value().ticks.size() != recording.ticks.size() || twice.value().bytes_left != 0)
        return "what was read and written does not read the same";
    const std::size_t kept = tick_size * recording.ticks.size();
    if (again.substr(again.size() - kept) != bytes.substr(bytes.size() - recording.bytes_left - kept, kept))
        return "the ticks are not written as they were";
    return {};
}

} // namespace tp::test
