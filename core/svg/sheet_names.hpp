// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tp::svg {

/// The text with every byte that is not UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// Makes names that no two contours share. The first bearer of a name keeps it, the next ones become "name
/// 2", "name 3", …; contours without a name become "contour 1", "contour 2", …
void make_unique(std::vector<std::string>& names);

/// How an element's attributes spell a contour's name.
struct ElementName {
    std::string id;        ///< what a drawing program shows; no white space, nothing that XML cannot hold
    std::string data_name; ///< the exact name where `id` had to differ from it, else empty
};

/// One spelling for each of `names`, which are unique and not empty; the ids are unique too.
std::vector<ElementName> spelled(const std::vector<std::string>& names);

/// The name that an element's attributes spell. `data_name` counts only while it fits the `id`: who renames
/// an element in a drawing program changes the id alone, and means it.
std::string name_from(std::string_view id, std::string_view data_name);

} // namespace tp::svg
