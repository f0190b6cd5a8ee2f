// SPDX-License-Identifier: Apache-2.0
#include "faces/models/haar_file.hpp"

#include "faces/decode/picture_file.hpp"

#include <opencv2/core/persistence.hpp>

#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

namespace tp {
namespace {

constexpr std::uintmax_t most_cascade_bytes = 8U << 20; ///< thrice the largest face cascade of OpenCV
constexpr int least_window = 8, most_window = 100;      ///< px, a side
constexpr std::size_t most_rects = 3;                   ///< OpenCV has room for so many in a feature
constexpr int most_nested = 8;                          ///< of elements, one more than a cascade has
constexpr std::string_view type_of_cascade = " type_id=\"opencv-cascade-classifier\"";

bool is_plain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || std::isspace(static_cast<unsigned char>(c)) ||
           std::string_view("_.+-<>/").find(c) != std::string_view::npos;
}

/// The text without its comments; nothing where one has no end.
std::optional<std::string> without_comments(std::string_view text) {
    constexpr std::string_view begins = "<!--", ends = "-->";
    std::string rest;
    for (std::size_t begin; (begin = text.find(begins)) != text.npos;) {
        rest += text.substr(0, begin);
        const std::size_t end = text.find(ends, begin + begins.size());
        if (end == text.npos)
            return std::nullopt;
        text.remove_prefix(end + ends.size());
    }
    return rest += text;
}

/// The XML with nothing but elements, words and numbers, and without the nesting on which cv::FileStorage's
/// recursive reader would run out of stack; nothing where it cannot be had.
std::optional<std::string> plain_xml(std::string_view text) {
    const std::size_t header = text.find("?>");
    if (!text.starts_with("<?xml") || header == text.npos)
        return std::nullopt;
    auto body = without_comments(text.substr(header + 2));
    if (!body)
        return std::nullopt;
    if (const std::size_t type = body->find(type_of_cascade); type != body->npos)
        body->erase(type, type_of_cascade.size());
    int depth = 0;
    for (std::size_t i = 0; i < body->size(); ++i) {
        if (!is_plain((*body)[i]))
            return std::nullopt;
        if ((*body)[i] == '<')
            depth += i + 1 < body->size() && (*body)[i + 1] == '/' ? -1 : 1;
        if (depth < 0 || depth > most_nested)
            return std::nullopt;
    }
    return "<?xml version=\"1.0\"?>" + *body;
}

bool is_number(const cv::FileNode& node) {
    return (node.isInt() || node.isReal()) && std::isfinite(static_cast<float>(node.real()));
}

bool is_whole(const cv::FileNode& node, int least, int most) {
    return node.isInt() && int(node) >= least && int(node) <= most;
}

/// An upright rectangle, or one turned by 45 degrees about its upper corner, inside the window.
bool is_rect(const cv::FileNode& node, cv::Size window, bool tilted) {
    if (!node.isSeq() || node.size() != 5 || !is_number(node[4]))
        return false;
    for (int i = 0; i < 4; ++i)
        if (!is_whole(node[i], 0, most_window))
            return false;
    const int x = node[0], y = node[1], width = node[2], height = node[3];
    return tilted ? x >= height && x + width <= window.width && y + width + height <= window.height
                  : x + width <= window.width && y + height <= window.height;
}

bool is_feature(const cv::FileNode& node, cv::Size window) {
    if (!node.isMap())
        return false;
    const cv::FileNode rects = node["rects"], tilted = node["tilted"];
    if (!rects.isSeq() || rects.size() == 0 || rects.size() > most_rects ||
        !(tilted.empty() || is_whole(tilted, 0, 1)))
        return false;
    for (const cv::FileNode& rect : rects)
        if (!is_rect(rect, window, !tilted.empty() && int(tilted) == 1))
            return false;
    return true;
}

/// A tree whose branches lead on, to a later node or to a leaf, and so to an end.
bool is_tree(const cv::FileNode& tree, int features) {
    if (!tree.isMap())
        return false;
    const cv::FileNode nodes = tree["internalNodes"], leaves = tree["leafValues"];
    if (!nodes.isSeq() || nodes.size() == 0 || nodes.size() % 4 != 0 || !leaves.isSeq() ||
        leaves.size() != nodes.size() / 4 + 1)
        return false;
    const int count = static_cast<int>(nodes.size() / 4);
    auto value = nodes.begin();
    for (int i = 0; i < count; ++i) {
        for (int branch = 0; branch < 2; ++branch, ++value) // a node's number, or a leaf's with a minus sign
            if (!is_whole(*value, -count, count - 1) || (int(*value) > 0 && int(*value) <= i))
                return false;
        if (!is_whole(*value, 0, features - 1) || !is_number(*++value))
            return false;
        ++value;
    }
    for (const cv::FileNode& leaf : leaves)
        if (!is_number(leaf))
            return false;
    return true;
}

bool is_stage(const cv::FileNode& stage, int features) {
    if (!stage.isMap() || !is_number(stage["stageThreshold"]))
        return false;
    const cv::FileNode trees = stage["weakClassifiers"];
    if (!trees.isSeq() || trees.size() == 0)
        return false;
    for (const cv::FileNode& tree : trees)
        if (!is_tree(tree, features))
            return false;
    return true;
}

bool is_cascade(const cv::FileNode& cascade) {
    if (!cascade.isMap() || !cascade["featureType"].isString() ||
        std::string(cascade["featureType"]) != "HAAR" || !cascade["stageType"].isString() ||
        !cascade["featureParams"].isMap() || !is_whole(cascade["featureParams"]["maxCatCount"], 0, 0) ||
        !is_whole(cascade["width"], least_window, most_window) ||
        !is_whole(cascade["height"], least_window, most_window))
        return false;
    const cv::FileNode features = cascade["features"], stages = cascade["stages"];
    if (!features.isSeq() || features.size() == 0 || !stages.isSeq() || stages.size() == 0)
        return false;
    const cv::Size window{int(cascade["width"]), int(cascade["height"])};
    for (const cv::FileNode& feature : features)
        if (!is_feature(feature, window))
            return false;
    for (const cv::FileNode& stage : stages)
        if (!is_stage(stage, static_cast<int>(features.size())))
            return false;
    return true;
}

} // namespace

std::optional<cv::CascadeClassifier> haar_cascade(const std::filesystem::path& file) {
    if (std::filesystem::file_size(file) > most_cascade_bytes)
        return std::nullopt;
    const Result<Bytes> bytes = read_bytes(file);
    if (!bytes)
        return std::nullopt;
    const auto xml = plain_xml({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!xml)
        return std::nullopt;
    const cv::FileStorage storage(*xml, cv::FileStorage::READ | cv::FileStorage::MEMORY |
                                            cv::FileStorage::FORMAT_XML);
    const cv::FileNode root = storage.getFirstTopLevelNode();
    cv::CascadeClassifier cascade;
    if (!is_cascade(root) || !cascade.read(root) || cascade.empty())
        return std::nullopt;
    return cascade;
}

} // namespace tp
