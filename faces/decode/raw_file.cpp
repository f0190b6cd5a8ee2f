// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/raw_file.hpp"

#include "faces/exiv2/exif_orientation.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"

#include <exiv2/exiv2.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace tp {
namespace {

using namespace std::string_view_literals;

bool has(const Bytes& bytes, std::size_t at, std::string_view text) {
    return bytes.size() >= at + text.size() &&
           std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
}

/// Numbers of a TIFF (TIFF 6.0, section 2); what lies outside the file is 0.
class TiffNumbers {
public:
    explicit TiffNumbers(const Bytes& bytes) : bytes_(bytes), little_(has(bytes, 0, "II"sv)) {}

    std::uint32_t at(std::size_t place, int count) const {
        std::uint32_t sum = 0;
        for (int i = 0; i < count; ++i) {
            const std::size_t from = place + static_cast<std::size_t>(little_ ? count - 1 - i : i);
            sum = sum << 8 | (from < bytes_.size() ? bytes_[from] : 0U);
        }
        return sum;
    }

private:
    const Bytes& bytes_;
    bool little_;
};

/// An entry of a TIFF's first directory: its one number, where it has one of four bytes, or else the place of
/// what it says.
struct TiffEntry {
    std::uint32_t tag = 0, value = 0;
};

std::vector<TiffEntry> first_directory(const Bytes& bytes) {
    const TiffNumbers numbers(bytes);
    const std::size_t directory = numbers.at(4, 4);
    std::vector<TiffEntry> entries;
    for (std::size_t left = numbers.at(directory, 2), at = directory + 2; left > 0 && at + 12 <= bytes.size();
         --left, at += 12)
        entries.push_back({numbers.at(at, 2), numbers.at(at + 8, 4)});
    return entries;
}

std::uint32_t value_of(std::uint32_t tag, const std::vector<TiffEntry>& entries) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const TiffEntry& one) { return one.tag == tag; });
    return found == entries.end() ? 0 : found->value;
}

/// By what the first directory says; see is_raw.
bool is_raw_tiff(const Bytes& bytes) {
    constexpr std::uint32_t subfile_type = 0x00FE, make = 0x010F, dng_version = 0xC612;
    constexpr std::uint32_t reduced = 1;
    const std::vector<TiffEntry> entries = first_directory(bytes);
    const std::uint32_t maker = value_of(make, entries);
    return value_of(dng_version, entries) != 0 ||
           (value_of(subfile_type, entries) == reduced &&
            (has(bytes, maker, "NIKON"sv) || has(bytes, maker, "SONY"sv)));
}

/// Exiv2 makes a TIFF of a preview that lies in a strip of its own. Where that strip is a JPEG, as in DNG,
/// this is it: it takes no other decoder, and less time. Empty otherwise.
Bytes jpeg_in(const Bytes& tiff) {
    constexpr std::uint32_t strip_place = 0x0111, strip_size = 0x0117;
    const std::vector<TiffEntry> entries = first_directory(tiff);
    const std::size_t at = value_of(strip_place, entries), size = value_of(strip_size, entries);
    if (!has(tiff, at, "\xFF\xD8\xFF"sv) || size > tiff.size() - at)
        return {};
    return {tiff.begin() + static_cast<std::ptrdiff_t>(at),
            tiff.begin() + static_cast<std::ptrdiff_t>(at + size)};
}

int orientation_of(const Exiv2::ExifData& exif) {
    const std::optional<int> usual = exif_orientation(exif);
    return usual ? *usual : exif_orientation(exif, "Exif.PanasonicRaw.Orientation").value_or(1);
}

/// A raw file as Exiv2 knows it; what it cannot read is not there.
class Previews {
public:
    explicit Previews(const Bytes& raw)
        : image_(Exiv2::ImageFactory::open(raw.data(), static_cast<long>(raw.size())).release()) {
        image_->readMetadata();
        properties_ = Exiv2::PreviewManager(*image_).getPreviewProperties();
    }

    std::size_t count() const { return properties_.size(); }
    /// The largest first.
    RawPreview at(std::size_t index) const {
        const Exiv2::PreviewImage copy =
            Exiv2::PreviewManager(*image_).getPreviewImage(properties_[properties_.size() - 1 - index]);
        Bytes bytes(copy.pData(), copy.pData() + copy.size());
        Bytes jpeg = jpeg_in(bytes);
        return {jpeg.empty() ? std::move(bytes) : std::move(jpeg), orientation_of(image_->exifData())};
    }

private:
    std::unique_ptr<Exiv2::Image> image_;
    Exiv2::PreviewPropertiesList properties_; ///< the smallest first
};

/// What `look` gives; none where Exiv2 gives up.
template <typename Look>
auto by_exiv2(Look look) -> std::optional<decltype(look())> {
    try {
        return look();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {
        return std::nullopt;
    }
}

} // namespace

bool is_raw(const Bytes& bytes) {
    for (const std::string_view olympus : {"IIRO"sv, "IIRS"sv, "MMOR"sv})
        if (has(bytes, 0, olympus))
            return true;
    if (has(bytes, 0, "IIU\0"sv) || has(bytes, 4, "ftypcrx"sv))
        return true;
    if (!has(bytes, 0, "II*\0"sv) && !has(bytes, 0, "MM\0*"sv))
        return false;
    return has(bytes, 8, "CR"sv) || is_raw_tiff(bytes);
}

void look_at_previews(const Bytes& raw, const std::function<bool(const RawPreview&)>& enough) {
    prepare_exiv2();
    const auto previews = by_exiv2([&] { return std::make_unique<Previews>(raw); });
    for (std::size_t i = 0; previews && i < (*previews)->count(); ++i)
        if (const auto preview = by_exiv2([&] { return (*previews)->at(i); }); preview && enough(*preview))
            return;
}

} // namespace tp
