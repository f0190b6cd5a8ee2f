// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a bundle: it is unpacked into its folder and nowhere else, as plain files
/// and folders that only their owner may read, and within the limits; or it is refused with a sentence. Bytes
/// that are no zip file are taken for a list of what a zip file holds, a line each: f, d or l for a file, a
/// folder or a link, and behind it the name. Empty where all of that holds, else what does not.
std::string complaint_about_bundle(std::string_view bytes);

} // namespace tp::test
