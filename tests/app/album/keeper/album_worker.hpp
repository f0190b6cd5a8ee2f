// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace tp::test {

/// A caregiver's afternoon: imports the card, records, labels, names, deletes, takes back, exports. Says TRY before and
/// ACK after each step on stdout.
void work_on_album(const std::filesystem::path& album, const std::filesystem::path& card,
                   const std::filesystem::path& sound, const std::filesystem::path& bundle);

/// A second person at one photograph, from when it is there: adds recordings and labels them, names a face and
/// a person, until the process is killed. Says TRY and ACK alike.
void work_beside(const std::filesystem::path& photo, const std::filesystem::path& sound);

} // namespace tp::test
