// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording_name.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr int most_numbers = 10'000;
constexpr std::size_t most_stem_bytes = 230; // of 255, the most that file systems take

/// The text's first bytes, cut before a character of UTF-8, not within.
std::string_view cut(std::string_view text, std::size_t most) {
    if (text.size() <= most)
        return text;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0u) == 0x80u)
        --most;
    return text.substr(0, most);
}

/// "2026-05-01T10:15:00…" as "2026-05-01T101500"; empty where it is something else.
std::string stamp(std::string_view recorded) {
    constexpr std::string_view pattern = "0000-00-00T00:00:00";
    if (recorded.size() < pattern.size())
        return {};
    std::string result;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char c = recorded[i];
        if (pattern[i] == '0' ? c < '0' || c > '9' : c != pattern[i])
            return {};
        if (c != ':')
            result += c;
    }
    return result;
}

} // namespace

std::string recording_stem(const RecordingLabel& label) {
    const std::string when = stamp(label.recorded);
    return (when.empty() ? "undated" : when) + "-" + std::string(name_of(label.kind));
}

bool is_taken(const fs::path& name) { return name_taken(name); }

fs::path numbered_name(const fs::path& folder, std::string_view stem, std::string_view end, int number) {
    std::string name(cut(stem, most_stem_bytes));
    if (number > 1)
        (name += '-') += std::to_string(number);
    return folder / (name += end);
}

Result<fs::path> under_free_name(const fs::path& folder, std::string_view stem, std::string_view end,
                                 const std::function<std::string(const fs::path&)>& write) {
    for (int number = 1; number <= most_numbers; ++number) {
        fs::path name = numbered_name(folder, stem, end, number);
        if (is_taken(name))
            continue;
        const std::string reason = write(name);
        if (reason.empty())
            return name;
        if (reason != reason_of(EEXIST))
            return Error{reason};
    }
    return Error{"there are too many files of that name already."};
}

} // namespace tp
