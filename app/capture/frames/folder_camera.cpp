// SPDX-License-Identifier: Apache-2.0
#include "app/capture/frames/folder_camera.hpp"

#include "core/files/file_words.hpp"
#include "faces/decode/picture.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <system_error>
#include <utility>

namespace tp {

namespace {

bool is_frame(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    constexpr std::array endings{".jpg", ".jpeg", ".png", ".webp", ".bmp"};
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

} // namespace

FolderCamera::FolderCamera(std::vector<std::filesystem::path> files, double frames_per_s, HeldCamera held)
    : files_(std::move(files)), frames_per_s_(frames_per_s), held_(held) {}

Result<FolderCamera> FolderCamera::open(const std::filesystem::path& folder, double frames_per_s,
                                        HeldCamera held) {
    std::error_code failed;
    std::vector<std::filesystem::path> files;
    std::filesystem::directory_iterator entry(folder, failed);
    for (; !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed))
        if (is_frame(entry->path()))
            files.push_back(entry->path());
    if (failed)
        return Error{"The folder " + quoted(folder) + " cannot be read: " + reason_of(failed.value())};
    std::sort(files.begin(), files.end());
    return FolderCamera(std::move(files), frames_per_s, held);
}

Result<std::optional<CameraFrame>> FolderCamera::next() {
    if (at_ == files_.size())
        return std::optional<CameraFrame>();
    const std::size_t number = at_++;
    Result<cv::Mat> pixels = read_picture(files_[number]);
    if (!pixels)
        return Error{pixels.error()};
    CameraFrame frame;
    frame.pixels = std::move(pixels).value();
    frame.time_s = static_cast<double>(number) / frames_per_s_;
    return std::optional(std::move(frame));
}

} // namespace tp
