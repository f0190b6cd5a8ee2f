// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// One answer of a speech-dispatcher, or one event (codes 700 to 799), by the Speech Synthesis Interface Protocol.
struct SsipReply {
    int code = 0;
    std::vector<std::string> lines; ///< what follows the code in each line; never empty
    bool is_event() const { return code >= 700 && code < 800; }
};

/// Puts together what a speech-dispatcher sends, in whatever pieces it comes.
class SsipReader {
public:
    static constexpr std::size_t most_bytes = 1 << 16; ///< of one reply

    /// Appends what has become whole to `replies`. False: this is no SSIP, and nothing more of it is read.
    bool read(std::string_view bytes, std::vector<SsipReply>& replies);

private:
    bool take_line(std::string_view line, std::vector<SsipReply>& replies);

    std::string rest_; ///< the beginning of a line
    SsipReply reply_;  ///< the lines before
    std::size_t size_ = 0;
    bool sound_ = true;
};

/// A text as SSIP wants it after SPEAK: one line, and the line that ends it.
std::string ssip_text(std::string_view utf8);

} // namespace tp
