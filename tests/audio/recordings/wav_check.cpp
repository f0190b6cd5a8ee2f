// SPDX-License-Identifier: Apache-2.0
#include "wav_check.hpp"

#include "audio/recordings/wav_layout.hpp"
#include "failing_bytes.hpp"

#include <array>
#include <vector>

namespace tp::test {

namespace {

std::string samples_in(const ByteSource& file, const WavLayout& layout) {
    std::string bytes;
    std::array<std::int16_t, 1000> block{};
    std::uint64_t frame = 0;
    while (const std::size_t frames = read_frames(file, layout, frame, block)) {
        bytes.append(reinterpret_cast<const char*>(block.data()),
                     frames * 2 * static_cast<std::size_t>(layout.format.channels));
        frame += frames;
    }
    return bytes;
}

std::string complaint_about_file(std::string_view bytes) {
    on_failing_disks(bytes, [](const ByteSource& file) {
        if (const auto layout = wav_layout(file))
            static_cast<void>(samples_in(file, *layout));
    });
    const MemoryBytes file(bytes);
    const auto layout = wav_layout(file);
    if (!layout)
        return layout.error().size() > 10 && layout.error().ends_with('.') ? "" : "refused without words";
    const auto channels = static_cast<std::uint64_t>(layout->format.channels);
    if (channels < 1 || channels > 2 || layout->format.rate < 8'000 || layout->format.rate > 192'000)
        return "a format that no recording has";
    if (layout->frames > bytes.size() || layout->data_begin + layout->frames * channels * 2 > bytes.size())
        return "more samples than the file holds";
    if (layout->notes.size() > most_wav_notes)
        return "notes larger than allowed";
    const std::string samples = samples_in(file, *layout);
    return samples == bytes.substr(layout->data_begin, layout->frames * channels * 2) ? "" : "other samples";
}

std::string complaint_about_samples(std::string_view bytes) {
    const auto at = [&](std::size_t i) {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
    };
    const SoundFormat format{at(0) % 2 == 0 ? 48'000 : 8'000, 1 + static_cast<int>(at(0) / 2 % 2)};
    const std::string_view notes = bytes.substr(0, at(1) / 4);
    const std::string header = open_ended_wav_header(format, notes);
    const std::string whole = header + std::string(bytes);
    const std::size_t cut = (at(2) * 256 + at(3)) % (whole.size() + 1);
    const std::size_t frame_bytes = 2 * static_cast<std::size_t>(format.channels);
    for (const std::size_t size : {whole.size(), cut}) {
        const MemoryBytes file(std::string_view(whole).substr(0, size));
        const auto layout = wav_layout(file);
        if (size < header.size() && (!layout || layout->frames == 0))
            continue;
        if (!layout)
            return "our own header is refused: " + layout.error();
        if (layout->format != format || layout->notes != notes)
            return "our own header is misread";
        const std::size_t synced = (size - header.size()) / frame_bytes * frame_bytes;
        if (samples_in(file, *layout) != bytes.substr(0, synced))
            return "samples that were written do not come back";
    }
    return {};
}

} // namespace

std::string complaint_about_wav(std::string_view bytes) {
    const std::string complaint = complaint_about_file(bytes);
    return complaint.empty() ? complaint_about_samples(bytes) : complaint;
}

} // namespace tp::test
