// SPDX-License-Identifier: Apache-2.0
#include "app/cli/photographs_in.hpp"

#include "app/album/metadata/photo_name.hpp"

#include <algorithm>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

Result<Photographs> photographs_in(const fs::path& place) {
    std::error_code error;
    if (!fs::exists(place, error))
        return Error{"There is no folder " + place.string() + "."};
    if (!fs::is_directory(place, error))
        return Photographs{place.parent_path(), {place}};
    Photographs all{place, {}};
    fs::recursive_directory_iterator at(place, fs::directory_options::skip_permission_denied, error);
    for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
        if (at->is_directory(error) && at->path().filename().string().starts_with('.'))
            at.disable_recursion_pending();
        else if (has_photo_name(at->path()) && at->is_regular_file(error))
            all.files.push_back(at->path());
    }
    if (error)
        return Error{"The folder " + place.string() + " cannot be looked through: " + error.message() + "."};
    std::sort(all.files.begin(), all.files.end());
    if (all.files.empty())
        return Error{"There is no photograph in " + place.string() + "."};
    return all;
}

} // namespace tp
