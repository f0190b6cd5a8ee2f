// SPDX-License-Identifier: Apache-2.0
#include "audio/video/handed_bytes.hpp"

#include <algorithm>
#include <unistd.h>

namespace tp {

std::size_t HandedBytes::read(std::uint64_t at, std::span<char> to) const {
    if (at >= size())
        return 0;
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), size() - at));
    std::size_t done = 0;
    while (done < wanted) {
        const ssize_t count = ::pread(file_.number(), to.data() + done, wanted - done,
                                      static_cast<off_t>(begin_) + static_cast<off_t>(at + done));
        if (count <= 0)
            break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

} // namespace tp
