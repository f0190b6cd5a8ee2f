// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace tp::test {

/// A caregiver's afternoon: imports the card, records, labels, names, deletes, takes back, exports. Says TRY before and
/// ACK after each step on stdout.
void work_on_album(const std::filesystem::path& album, const std::filesystem::path& card,
                   const std::filesystem::path& sound, const std::filesystem::path& bundle);

} // namespace tp::test
