// SPDX-License-Identifier: Apache-2.0
#include "ssip_check.hpp"

#include "audio/speech/ssip.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tp::test {

std::string complaint_about_ssip(std::string_view bytes) {
    SsipReader whole, pieces;
    std::vector<SsipReply> at_once, in_pieces;
    const bool sound = whole.read(bytes, at_once);
    bool still_sound = true;
    for (const char each : bytes)
        still_sound = pieces.read({&each, 1}, in_pieces);
    if (sound != still_sound)
        return "pieces are judged otherwise than the whole";
    const auto same = [](const SsipReply& a, const SsipReply& b) { return a.code == b.code && a.lines == b.lines; };
    if (!std::equal(at_once.begin(), at_once.end(), in_pieces.begin(), in_pieces.end(), same))
        return "pieces give other replies than the whole";
    for (const SsipReply& reply : at_once) {
        if (reply.code < 0 || reply.code > 999 || reply.lines.empty())
            return "a reply without a code or a line";
        std::size_t size = 0;
        for (const std::string& line : reply.lines) {
            if (line.find('\n') != std::string::npos)
                return "a line with an end in it";
            size += line.size();
        }
        if (size > SsipReader::most_bytes)
            return "a reply larger than is allowed";
    }
    const std::string text = ssip_text(bytes);
    if (!text.ends_with("\r\n.\r\n") || text.find("\n") != text.size() - 4 || text.starts_with(".\r"))
        return "a text that ends itself";
    return {};
}

} // namespace tp::test
