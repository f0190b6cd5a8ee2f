// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/import_sources.hpp"

#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/photo_endings.hpp"

#include <algorithm>
#include <set>
#include <utility>

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

PhotographsIn photographs_in(const std::vector<fs::path>& files_and_folders) {
    PhotographsIn found;
    for (const fs::path& source : files_and_folders) {
        if (!folder_there(source)) {
            found.photos.push_back({source, {}, size_or_zero(source)});
            continue;
        }
        const ForeignFolder held(source);
        std::vector<PhotoToImport> inside;
        std::vector<fs::path> to_do{source};
        while (!to_do.empty()) {
            const fs::path here = std::move(to_do.back());
            to_do.pop_back();
            const fs::path folder = here.lexically_proximate(source);
            int error = 0;
            const std::vector<FolderEntry> entries = entries_of(here, &error);
            if (error != 0)
                found.unread.push_back(
                    {here, "The folder " + quoted(here) + " cannot be read: " + reason_of(error)});
            for (const FolderEntry& entry : entries) {
                const fs::path file = here / entry.name;
                const bool folder_here = entry.facts.kind == FileFacts::Kind::folder;
                if (entry.link) {
                    if (!entry.name.starts_with('.'))
                        found.links.push_back(file);
                } else if (folder_here && !entry.name.starts_with('.')) {
                    to_do.push_back(file);
                } else if (entry.facts.kind == FileFacts::Kind::file && has_photo_name(file)) {
                    inside.push_back({file, folder == "." ? fs::path() : folder, entry.facts.bytes});
                }
            }
        }
        std::sort(inside.begin(), inside.end(),
                  [](const PhotoToImport& a, const PhotoToImport& b) { return a.file < b.file; });
        found.photos.insert(found.photos.end(), inside.begin(), inside.end());
    }
    return found;
}

ImportSources::ImportSources(const std::vector<fs::path>& sources, fs::path unpack_in, std::stop_token stop,
                             const Unpacking& unpacking)
    : unpack_in_(std::move(unpack_in)) {
    remove_tree(unpack_in_); // what a kill left
    const std::set<fs::path> come_along = names_of_companions(sources);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const fs::path& source = sources[i];
        if (folder_there(source)) {
            held_.emplace_back(source);
            add(source);
        } else if (link_there(source))
            leave(source);
        else if (has_photo_name(source))
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

ImportSources::~ImportSources() { remove_tree(unpack_in_); }

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
    const PhotographsIn found = photographs_in({file_or_folder});
    photos_.insert(photos_.end(), found.photos.begin(), found.photos.end());
    for (const fs::path& link : found.links)
        leave(link);
    for (const PhotographsIn::Unread& one : found.unread)
        problems_.push_back({one.folder, one.sentence, true});
}

/// Once, though it was named itself and lies in a folder that was.
void ImportSources::leave(const fs::path& link) {
    if (std::none_of(problems_.begin(), problems_.end(),
                     [&](const Problem& problem) { return problem.source == link; }))
        problems_.push_back({link, left_alone(link)});
}

} // namespace tp
