// SPDX-License-Identifier: Apache-2.0
#include "faces/models/lbf_file.hpp"

#include "faces/decode/picture_file.hpp"

#include <opencv2/core/persistence.hpp>
#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

namespace tp {
namespace {

constexpr int landmarks = 68;
constexpr int most_stages = 10; ///< FacemarkLBF has sizes of features for so many
constexpr int most_trees = 64, most_depth = 12;
constexpr std::uintmax_t most_model_bytes = 512U << 20;
constexpr std::size_t most_indented = 16; ///< spaces

std::size_t indentation(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// A minus sign that stands within no word and begins no number begins an item of a list.
bool has_list(std::string_view line) {
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t at = line.find('-'); at != line.npos; at = line.find('-', at + 1)) {
        const char before = at > 0 ? line[at - 1] : ' ', after = at + 1 < line.size() ? line[at + 1] : ' ';
        if (!is_letter(before) && after != '.' && !std::isdigit(static_cast<unsigned char>(after)))
            return true;
    }
    return false;
}

/// YAML that holds numbers and tables, without the nesting on which cv::FileStorage's recursive reader would
/// run out of stack.
bool is_flat_yaml(std::string_view text) {
    if (!text.starts_with("%YAML"))
        return false;
    std::ptrdiff_t open = 0; // brackets
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
        open += count('[') - count(']');
        if (open > 1 || count(':') > 1 || count('{') > 0 || indentation(line) > most_indented ||
            (line != "---" && has_list(line)))
            return false;
    }
    return true;
}

/// A matrix of that size, in doubles.
bool is_table(const cv::FileNode& node, int rows, int columns) {
    if (!node.isMap() || !node["rows"].isInt() || !node["cols"].isInt() || !node["dt"].isString())
        return false;
    return int(node["rows"]) == rows && int(node["cols"]) == columns && std::string(node["dt"]) == "d" &&
           node["data"].isSeq() &&
           node["data"].size() == static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
}

bool are_integers(const cv::FileNode& node, std::size_t count) {
    if (!node.isSeq() || node.size() != count)
        return false;
    for (const cv::FileNode& value : node)
        if (!value.isInt())
            return false;
    return true;
}

/// Nothing where it is no integer from 1 to `most`.
std::optional<int> whole(const cv::FileNode& node, int most) {
    if (!node.isInt() || int(node) < 1 || int(node) > most)
        return std::nullopt;
    return int(node);
}

} // namespace

std::optional<std::vector<Vec2>> lbf_mean_shape(const std::filesystem::path& file) {
    if (std::filesystem::file_size(file) > most_model_bytes)
        return std::nullopt;
    const Result<Bytes> bytes = read_bytes(file);
    if (!bytes || !is_flat_yaml({reinterpret_cast<const char*>(bytes->data()), bytes->size()}))
        return std::nullopt;
    const cv::FileStorage model(file.string(), cv::FileStorage::READ | cv::FileStorage::FORMAT_YAML);
    const auto stages = whole(model["stages_n"], most_stages), trees = whole(model["tree_n"], most_trees),
               depth = whole(model["tree_depth"], most_depth);
    if (!stages || !trees || !depth || whole(model["n_landmarks"], landmarks) != landmarks)
        return std::nullopt;
    const int nodes = 1 << *depth, leaves = nodes / 2;
    for (int stage = 0; stage < *stages; ++stage) {
        for (int point = 0; point < landmarks; ++point)
            for (int tree = 0; tree < *trees; ++tree) {
                const cv::String place = cv::format("_%i_%i_%i", stage, point, tree);
                if (!is_table(model["tree" + place], nodes, 4) ||
                    !are_integers(model["thresholds" + place], static_cast<std::size_t>(nodes)))
                    return std::nullopt;
            }
        if (!is_table(model[cv::format("weights_%i", stage)], 2 * landmarks, landmarks * *trees * leaves))
            return std::nullopt;
    }
    const cv::FileNode shape = model["regressor_meanshape"];
    if (!is_table(shape, landmarks, 2))
        return std::nullopt;
    cv::Mat_<double> numbers;
    shape >> numbers;
    std::vector<Vec2> mean;
    for (int i = 0; i < landmarks; ++i) {
        mean.emplace_back(numbers(i, 0), numbers(i, 1));
        if (!is_finite(mean.back()) || length(mean.back()) > 10.0)
            return std::nullopt;
    }
    // The person's right eye is at the left in the picture.
    const Vec2 eyes = mean[45] - mean[36];
    if (!(eyes.x > 0.1 && std::abs(eyes.y) < 0.5 * eyes.x))
        return std::nullopt;
    return mean;
}

} // namespace tp
