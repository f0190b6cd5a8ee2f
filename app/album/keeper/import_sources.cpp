// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/import_sources.hpp"

#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/file_words.hpp"
#include "core/files/photo_endings.hpp"

#include <algorithm>
#include <set>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

bool is_bundle_name(const fs::path& file) {
    const std::string ending = small_ending(file);
    return ending == ".touchphoto" || ending == ".zip";
}

/// What files that are a photograph's have before their last ending: its name or its stem.
std::set<fs::path> names_of_companions(const std::vector<fs::path>& sources) {
    std::set<fs::path> names;
    for (const fs::path& source : sources)
        if (has_photo_name(source))
            names.insert({source, source.parent_path() / source.stem()});
    return names;
}

std::string not_imported(const fs::path& source, const std::string& why) {
    return quoted(source) + " was not imported: " + why;
}

} // namespace

std::vector<PhotoToImport> photographs_in(const std::vector<fs::path>& files_and_folders) {
    std::vector<PhotoToImport> photos;
    for (const fs::path& source : files_and_folders) {
        std::error_code error;
        if (!fs::is_directory(source, error)) {
            photos.push_back({source, {}, size_or_zero(source)});
            continue;
        }
        std::vector<PhotoToImport> inside;
        for (fs::recursive_directory_iterator
                 place(source, fs::directory_options::skip_permission_denied, error),
             end;
             !error && place != end; place.increment(error)) {
            const fs::path file = place->path();
            const fs::path folder = file.parent_path().lexically_proximate(source);
            if (place->is_directory(error) && file.filename().string().starts_with('.'))
                place.disable_recursion_pending();
            else if (has_photo_name(file) && place->is_regular_file(error))
                inside.push_back({file, folder == "." ? fs::path() : folder, size_or_zero(file)});
        }
        std::sort(inside.begin(), inside.end(),
                  [](const PhotoToImport& a, const PhotoToImport& b) { return a.file < b.file; });
        photos.insert(photos.end(), inside.begin(), inside.end());
    }
    return photos;
}

ImportSources::ImportSources(const std::vector<fs::path>& sources, fs::path unpack_in, std::stop_token stop,
                             const Unpacking& unpacking)
    : unpack_in_(std::move(unpack_in)) {
    std::error_code error;
    fs::remove_all(unpack_in_, error); // what a kill left
    const std::set<fs::path> come_along = names_of_companions(sources);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const fs::path& source = sources[i];
        if (fs::is_directory(source, error) || has_photo_name(source))
            add(source);
        else if (is_bundle_name(source))
            unpack(source, unpack_in_ / std::to_string(i), stop, unpacking);
        else if (!come_along.contains(source.parent_path() / source.stem()))
            problems_.push_back(
                {source, not_imported(source, "it is not a photograph of a kind that can be read here.")});
    }
    if (photos_.empty() && problems_.empty() && !stop.stop_requested())
        for (const fs::path& source : sources)
            problems_.push_back({source, not_imported(source, "it holds no photograph.")});
}

ImportSources::~ImportSources() {
    std::error_code error;
    fs::remove_all(unpack_in_, error);
}

void ImportSources::unpack(const fs::path& bundle, const fs::path& folder, const std::stop_token& stop,
                           const Unpacking& unpacking) {
    const auto report = [&](std::uintmax_t done, std::uintmax_t total) {
        if (unpacking)
            unpacking(bundle, static_cast<double>(done) / static_cast<double>(total));
    };
    report(0, 1);
    const std::string problem = unpack_bundle(bundle, folder, {}, report, stop);
    if (problem.empty())
        add(folder);
    else if (!stop.stop_requested())
        problems_.push_back({bundle, problem, true});
}

void ImportSources::add(const fs::path& file_or_folder) {
    const std::vector<PhotoToImport> found = photographs_in({file_or_folder});
    photos_.insert(photos_.end(), found.begin(), found.end());
}

} // namespace tp
