// SPDX-License-Identifier: Apache-2.0
#include "audio/video/handed_bytes.hpp"

#include "core/files/open_file.hpp"

#include <algorithm>

namespace tp {

std::size_t HandedBytes::read(std::uint64_t at, std::span<char> to) const {
    if (at >= size())
        return 0;
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), size() - at));
    return read_at(file_.number(), static_cast<std::uint64_t>(begin_) + at, to.first(wanted));
}

} // namespace tp
