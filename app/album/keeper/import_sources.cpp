// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/import_sources.hpp"

#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"

#include <algorithm>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

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
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (sources[i].extension() != ".touchphoto" || fs::is_directory(sources[i], error)) {
            add({sources[i]});
            continue;
        }
        const fs::path folder = unpack_in_ / std::to_string(i);
        const auto report = [&](std::uintmax_t done, std::uintmax_t total) {
            if (unpacking)
                unpacking(sources[i], static_cast<double>(done) / static_cast<double>(total));
        };
        report(0, 1);
        const std::string problem = unpack_bundle(sources[i], folder, {}, report, stop);
        if (problem.empty())
            add({folder});
        else if (!stop.stop_requested())
            problems_.emplace_back(sources[i], problem);
    }
}

ImportSources::~ImportSources() {
    std::error_code error;
    fs::remove_all(unpack_in_, error);
}

void ImportSources::add(const std::vector<fs::path>& files_and_folders) {
    const std::vector<PhotoToImport> found = photographs_in(files_and_folders);
    photos_.insert(photos_.end(), found.begin(), found.end());
}

} // namespace tp
