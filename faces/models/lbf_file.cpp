// SPDX-License-Identifier: Apache-2.0
#include "faces/models/lbf_file.hpp"

#include "faces/decode/picture_file.hpp"

#include <opencv2/core/persistence.hpp>
#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tp {
namespace {

constexpr int landmarks = 68;
constexpr int most_stages = 10; ///< FacemarkLBF has sizes of features for so many
constexpr int most_trees = 64, most_depth = 12;
constexpr std::uintmax_t most_model_bytes = 512U << 20;

constexpr std::string_view digits = "0123456789";
constexpr std::string_view name_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";
constexpr std::string_view number_letters = "0123456789+-.eE";
constexpr std::string_view list_letters = "0123456789+-.eE, ";
constexpr std::string_view base64_letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view doubles_head = "MWQgICAgICAgICAgICAgICAgICAgICAg";  ///< "1d" and 22 blanks
constexpr std::string_view integers_head = "MWkgICAgICAgICAgICAgICAgICAgICAg"; ///< "1i" and 22 blanks
constexpr std::size_t head_bytes = 24, most_in_line = 64;

bool is_made_of(std::string_view text, std::string_view letters) {
    return !text.empty() && text.find_first_not_of(letters) == text.npos;
}

/// YAML as OpenCV's own writer makes it of numbers, lists of numbers and tables, line by line. Of anything else
/// cv::FileStorage's reader may run out of stack, where it is deep, or never come to an end, as where a name is less indented
/// than the one before and its fourth letter is a minus, or where packed numbers are of no kind.
class FacemarkLines {
public:
    explicit FacemarkLines(std::string_view text) : left_(text) {}

    bool are_all_known() {
        if (next() != "%YAML:1.0")
            return false;
        if (left_.starts_with("---\n"))
            next();
        while (!left_.empty())
            if (!take_entry())
                return false;
        return true;
    }

private:
    std::string_view next() {
        const std::string_view line = left_.substr(0, left_.find('\n'));
        left_.remove_prefix(std::min(line.size() + 1, left_.size()));
        return line;
    }
    bool take_entry() {
        const std::string_view line = next();
        const std::size_t colon = line.find(": ");
        if (colon == line.npos || !is_made_of(line.substr(0, colon), name_letters))
            return false;
        const std::string_view value = line.substr(colon + 2);
        return value == "!!opencv-matrix" ? take_table()
                                          : is_made_of(value, number_letters) || take_list(value, "   ");
    }
    bool take_table() {
        for (const std::string_view size : {"   rows: ", "   cols: "})
            if (const std::string_view line = next();
                !line.starts_with(size) || !is_made_of(line.substr(size.size()), digits))
                return false;
        if (next() != "   dt: d")
            return false;
        constexpr std::string_view data = "   data: ";
        const std::string_view line = next();
        return line.starts_with(data) && take_list(line.substr(data.size()), "      ");
    }
    /// In brackets, or packed below it.
    bool take_list(std::string_view value, std::string_view indentation) {
        if (value == "!!binary |")
            return take_packed(indentation);
        if (!value.starts_with('['))
            return false;
        value.remove_prefix(1);
        while (!value.ends_with(']')) {
            if (!is_made_of(value, list_letters) || left_.empty())
                return false;
            value = next();
        }
        value.remove_suffix(1);
        return value.empty() || is_made_of(value, list_letters);
    }
    /// A head that says of what kind the numbers are, and their bytes, in base64: full lines and a last one.
    bool take_packed(std::string_view indentation) {
        const std::string_view head = left_.substr(std::min(indentation.size(), left_.size()));
        const std::size_t size = head.starts_with(doubles_head) ? 8 : head.starts_with(integers_head) ? 4 : 0;
        std::size_t letters = 0, padding = 0;
        for (bool last = false; left_.starts_with(indentation);) {
            const std::string_view line = next().substr(indentation.size());
            padding = line.ends_with("==") ? 2 : line.ends_with('=') ? 1 : 0;
            if (last || line.size() > most_in_line || line.size() % 4 != 0 ||
                !is_made_of(line.substr(0, line.size() - padding), base64_letters))
                return false;
            letters += line.size();
            last = line.size() < most_in_line || padding > 0;
        }
        const std::size_t bytes = letters / 4 * 3 - padding;
        return size > 0 && bytes > head_bytes && (bytes - head_bytes) % size == 0;
    }

    std::string_view left_;
};

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
    if (!bytes ||
        !FacemarkLines({reinterpret_cast<const char*>(bytes->data()), bytes->size()}).are_all_known())
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
