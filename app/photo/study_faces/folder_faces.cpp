// SPDX-License-Identifier: Apache-2.0
#include "app/photo/study_faces/folder_faces.hpp"

#include "app/photo/scene/corrections.hpp"
#include "core/experiment/number_text.hpp"
#include "core/files/file_words.hpp"
#include "core/files/photo_endings.hpp"
#include "core/svg/contour_sheet.hpp"
#include "faces/extract/face_extractor.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_files = 10'000;

bool is_drawing(const fs::path& file) { return file.extension() == ".svg" || file.extension() == ".SVG"; }

/// The files of the folder by person and expression; a drawing before a photograph.
using Labelled = std::map<std::string, std::map<std::string, fs::path>>;

/// "anna" and "smiling" of "anna_smiling.truth.svg"
std::optional<std::pair<std::string, std::string>> label_of(const fs::path& file) {
    std::string name = file.filename().string();
    name.erase(std::min(name.size(), name.find('.')));
    const std::size_t end = name.find_last_of('_');
    if (end == std::string::npos || end == 0 || end + 1 == name.size())
        return std::nullopt;
    return std::pair(name.substr(0, end), name.substr(end + 1));
}

Result<Labelled> labelled_files(const fs::path& folder) {
    Labelled files;
    std::size_t count = 0;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (++count > most_files)
            return Error{"The folder " + quoted(folder) + " has too many files."};
        const fs::path& file = at->path();
        const auto label = label_of(file);
        if (!label || !(is_drawing(file) || has_photo_ending(file.filename().string())))
            continue;
        fs::path& kept = files[label->first][label->second];
        if (kept.empty() || (is_drawing(file) && !is_drawing(kept)))
            kept = file;
    }
    if (error)
        return Error{"The folder " + quoted(folder) + " cannot be read."};
    return files;
}

std::vector<std::string> levels_of(const Experiment& experiment, StudyParameter parameter) {
    std::vector<std::string> levels;
    for (const auto* list : {&experiment.factors, &experiment.settings, &experiment.training_factors})
        for (const StudyFactor& factor : *list)
            if (factor.parameter == parameter)
                for (const std::string& level : factor.levels)
                    if (std::ranges::find(levels, level) == levels.end())
                        levels.push_back(level);
    return levels;
}

/// The contours of the largest face, and those alone.
Result<std::vector<Contour>> face_in(const fs::path& file, std::optional<FaceExtractor>& extractor,
                                     const std::stop_token& stop) {
    if (is_drawing(file)) {
        const auto sheet = read_sheet(file, ContourSheet::Unit::pixel);
        if (!sheet)
            return Error{sheet.error()};
        return sheet->contours;
    }
    if (!extractor) {
        auto made = FaceExtractor::create();
        if (!made)
            return Error{made.error()};
        extractor.emplace(std::move(made).value());
    }
    const Extraction found = with_corrections(extractor->extract(file, stop), file);
    const auto largest = std::ranges::max_element(
        found.faces, {}, [](const Face& face) { return face.box.width() * face.box.height(); });
    if (largest == found.faces.end())
        return Error{"No face was found in " + quoted(file) + "."};
    return largest->contours;
}

} // namespace

bool needs_faces(const Experiment& experiment) {
    return !levels_of(experiment, StudyParameter::face).empty() ||
           !levels_of(experiment, StudyParameter::expression).empty();
}

Result<std::shared_ptr<const FolderFaces>>
FolderFaces::read(const fs::path& folder, const Experiment& experiment, const std::stop_token& stop) {
    const auto files = labelled_files(folder);
    if (!files)
        return Error{files.error()};
    const std::vector<std::string> expressions = levels_of(experiment, StudyParameter::expression);
    std::vector<const Labelled::value_type*> people; ///< who have every expression
    for (const auto& person : *files)
        if (std::ranges::all_of(expressions,
                                [&](const std::string& one) { return person.second.contains(one); }))
            people.push_back(&person);
    auto faces = std::make_shared<FolderFaces>();
    std::optional<FaceExtractor> extractor;
    for (const std::string& level : levels_of(experiment, StudyParameter::face)) {
        const auto number = number_in<std::size_t>(level, 1, 1000);
        if (!number || *number > people.size())
            return Error{"The folder " + quoted(folder) +
                         " has too few people with every expression: " + std::to_string(people.size()) +
                         ". Name the files after person and expression, such as anna_smiling.jpg."};
        for (const std::string& expression : expressions) {
            if (stop.stop_requested())
                return Error{""};
            auto contours = face_in(people[*number - 1]->second.at(expression), extractor, stop);
            if (!contours)
                return Error{contours.error()};
            faces->faces_[{expression, level}] = std::move(*contours);
        }
    }
    return std::shared_ptr<const FolderFaces>(std::move(faces));
}

Result<std::vector<Contour>> FolderFaces::contours(std::string_view expression, std::string_view face) const {
    const auto found = faces_.find({std::string(expression), std::string(face)});
    if (found == faces_.end())
        return Error{"A face of the experiment is not there."};
    return found->second;
}

} // namespace tp
