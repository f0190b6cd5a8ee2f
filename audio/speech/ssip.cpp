// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/ssip.hpp"

#include <algorithm>
#include <utility>

namespace tp {

bool SsipReader::read(std::string_view bytes, std::vector<SsipReply>& replies) {
    while (sound_ && !bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        const std::string_view part = bytes.substr(0, end);
        size_ += part.size();
        sound_ = size_ <= most_bytes;
        rest_ += part;
        if (end == std::string_view::npos || !sound_)
            break;
        bytes.remove_prefix(end + 1);
        if (!rest_.empty() && rest_.back() == '\r')
            rest_.pop_back();
        sound_ = take_line(std::exchange(rest_, {}), replies);
    }
    return sound_;
}

bool SsipReader::take_line(std::string_view line, std::vector<SsipReply>& replies) {
    const auto digit = [](char each) { return each >= '0' && each <= '9'; };
    if (line.size() < 4 || !std::all_of(line.begin(), line.begin() + 3, digit) || (line[3] != ' ' && line[3] != '-'))
        return false;
    const int code = 100 * (line[0] - '0') + 10 * (line[1] - '0') + (line[2] - '0');
    if (!reply_.lines.empty() && reply_.code != code)
        return false;
    reply_.code = code;
    reply_.lines.emplace_back(line.substr(4));
    if (line[3] == ' ') {
        replies.push_back(std::exchange(reply_, {}));
        size_ = 0;
    }
    return true;
}

std::string ssip_text(std::string_view utf8) {
    std::string text(utf8);
    std::replace_if(text.begin(), text.end(), [](char each) { return each == '\n' || each == '\r' || each == '\0'; }, ' ');
    if (text.starts_with('.'))
        text.insert(0, 1, '.');
    return text + "\r\n.\r\n";
}

} // namespace tp
