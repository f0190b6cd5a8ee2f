// SPDX-License-Identifier: Apache-2.0
#include "core/version/version.hpp"

#include "build_version.hpp"

namespace tp {

const char* version_number() { return TOUCHPHOTO_VERSION; }

std::string version_line(const std::string& program) {
    const std::string commit = TOUCHPHOTO_COMMIT;
    return program + " " + version_number() + (commit.empty() ? "" : " (" + commit + ")");
}

} // namespace tp
