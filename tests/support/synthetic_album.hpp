// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/base/result.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

/// Albums of any size, made in seconds: JPEGs of one pixel whose bytes all differ, with XMP sidecars.
namespace tp::testing {

namespace fs = std::filesystem;

inline void write_file(const fs::path& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string file_bytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A whole JPEG of one pixel with a comment (at most 65 533 bytes) that makes it differ from others.
inline std::string jpeg_bytes(std::string_view comment) {
    constexpr std::string_view digits = "ffdb004300030202020202030202020303030304060404040404080606050609080a"
                                        "0a090809090a0c0f0c0a0b0e0b09090d11"
                                        "0d0e0f101011100a0c12131210130f101010ffc9000b080001000101011100ffcc00"
                                        "0600101005ffda0008010100003f00d2cf"
                                        "20ffd9";
    std::string bytes("\xFF\xD8\xFF\xFE");
    bytes += static_cast<char>((comment.size() + 2) >> 8);
    bytes += static_cast<char>((comment.size() + 2) & 0xFF);
    bytes += comment;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16));
    return bytes;
}

inline std::string list_items(const std::vector<std::string>& texts) {
    std::string items;
    for (const std::string& text : texts)
        items += "<rdf:li>" + text + "</rdf:li>";
    return items;
}

/// The sidecar of a record: date, place's name, texts in x-default, persons, keywords and faces of it. Its
/// texts must not have characters that XML escapes.
inline std::string sidecar_text(const PhotoRecord& record) {
    const auto text_of = [](const LanguageTexts& texts) {
        const auto found = texts.find("x-default");
        return "<rdf:Alt><rdf:li xml:lang=\"x-default\">" + (found == texts.end() ? "" : found->second) +
               "</rdf:li></rdf:Alt>";
    };
    std::string faces;
    for (const FaceRegion& face : record.faces) {
        std::array<char, 200> area{};
        std::snprintf(area.data(), area.size(),
                      "stArea:x=\"%.4f\" stArea:y=\"%.4f\" stArea:w=\"%.4f\" stArea:h=\"%.4f\"", face.x,
                      face.y, face.width, face.height);
        faces += "<rdf:li><rdf:Description mwg-rs:Type=\"Face\" mwg-rs:Name=\"" + face.name +
                 "\"><mwg-rs:Area " + area.data() +
                 " stArea:unit=\"normalized\"/></rdf:Description></rdf:li>";
    }
    return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">"
           "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description "
           "rdf:about=\"\" "
           "xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
           "xmlns:photoshop=\"http://ns.adobe.com/photoshop/1.0/\" "
           "xmlns:Iptc4xmpCore=\"http://iptc.org/std/Iptc4xmpCore/1.0/xmlns/\" "
           "xmlns:Iptc4xmpExt=\"http://iptc.org/std/Iptc4xmpExt/2008-02-29/\" "
           "xmlns:mwg-rs=\"http://www.metadataworkinggroup.com/schemas/regions/\" "
           "xmlns:stArea=\"http://ns.adobe.com/xmp/sType/Area#\" photoshop:DateCreated=\"" +
           record.taken + "\" photoshop:City=\"" + record.place_name +
           "\">\n<Iptc4xmpCore:AltTextAccessibility>" + text_of(record.alt_text) +
           "</Iptc4xmpCore:AltTextAccessibility>\n<dc:description>" + text_of(record.description) +
           "</dc:description>\n<Iptc4xmpExt:PersonInImage><rdf:Bag>" + list_items(record.persons) +
           "</rdf:Bag></Iptc4xmpExt:PersonInImage>\n<dc:subject><rdf:Bag>" + list_items(record.keywords) +
           "</rdf:Bag></dc:subject>\n<mwg-rs:Regions "
           "rdf:parseType=\"Resource\"><mwg-rs:RegionList><rdf:Bag>" +
           faces +
           "</rdf:Bag></mwg-rs:RegionList></mwg-rs:Regions></rdf:Description></rdf:RDF></x:xmpmeta>\n";
}

/// What lies between two marks; moves `from` behind it. Empty where there is none.
inline std::string_view between(std::string_view text, std::string_view begin, std::string_view end,
                                std::size_t& from) {
    const std::size_t start = text.find(begin, from);
    const std::size_t stop = start == std::string_view::npos ? start : text.find(end, start + begin.size());
    if (stop == std::string_view::npos) {
        from = std::string_view::npos;
        return {};
    }
    from = stop;
    return text.substr(start + begin.size(), stop - start - begin.size());
}

inline std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
    std::size_t from = 0;
    return between(text, begin, end, from);
}

inline std::vector<std::string> items_in(std::string_view text) {
    std::vector<std::string> items;
    for (std::size_t from = 0; from != std::string_view::npos;)
        if (const std::string_view item = between(text, "<rdf:li>", "</rdf:li>", from);
            from != std::string_view::npos)
            items.emplace_back(item);
    return items;
}

/// Reads sidecars of `sidecar_text`, and no others: as quick as a reader can be.
inline Result<PhotoRecord> read_synthetic(const fs::path& photo) {
    PhotoRecord record;
    fs::path sidecar = photo;
    sidecar += ".xmp";
    const std::string text = file_bytes(sidecar);
    record.taken = between(text, "photoshop:DateCreated=\"", "\"");
    record.place_name = between(text, "photoshop:City=\"", "\"");
    const auto set_text = [&](LanguageTexts& texts, std::string_view element) {
        const auto inside = between(between(text, element, "</rdf:Alt>"), "x-default\">", "</rdf:li>");
        if (!inside.empty())
            texts["x-default"] = inside;
    };
    set_text(record.alt_text, "<Iptc4xmpCore:AltTextAccessibility>");
    set_text(record.description, "<dc:description>");
    record.persons = items_in(between(text, "<Iptc4xmpExt:PersonInImage>", "</rdf:Bag>"));
    record.keywords = items_in(between(text, "<dc:subject>", "</rdf:Bag>"));
    for (std::size_t from = 0; from != std::string_view::npos;)
        if (const std::string_view face = between(text, "mwg-rs:Name=\"", "/>", from);
            from != std::string_view::npos) {
            const auto number = [&](std::string_view begin) {
                return std::strtod(std::string(between(face, begin, "\"")).c_str(), nullptr);
            };
            record.faces.push_back({number("stArea:x=\""), number("stArea:y=\""), number("stArea:w=\""),
                                    number("stArea:h=\""), std::string(face.substr(0, face.find('"')))});
        }
    return record;
}

/// A family's album: the same for the same seed. People, places and keywords are as unevenly common as in
/// life (the n-th commonest appears about 1/n times as often as the first).
class SyntheticAlbum {
public:
    explicit SyntheticAlbum(std::uint64_t seed) : random_(seed) {
        for (std::size_t i = 0; i < 300; ++i)
            people_.push_back(word(2 + below(2)) + " " + word(2 + below(2)));
        people_[0] = "Anna Müller";
        people_[1] = "Annemarie Huber";
        for (std::size_t i = 0; i < 200; ++i)
            places_.push_back(word(2 + below(3)) + ", Österreich");
        for (std::size_t i = 0; i < 500; ++i)
            keywords_.push_back(word(2 + below(3)));
        for (std::size_t i = 0; i < 5000; ++i)
            words_.push_back(word(1 + below(4)));
    }

    /// Photograph number i of an album, and its sidecar.
    void write_photo(const fs::path& photo, std::size_t number) {
        write_file(photo, jpeg_bytes("photograph " + std::to_string(number)));
        fs::path sidecar = photo;
        sidecar += ".xmp";
        write_file(sidecar, sidecar_text(record()));
    }

    PhotoRecord record() {
        PhotoRecord record;
        std::array<char, 40> date{};
        std::snprintf(date.data(), date.size(), "%04d-%02d-%02dT%02d:%02d:%02d+02:00",
                      static_cast<int>(1990 + below(36)), static_cast<int>(1 + below(12)),
                      static_cast<int>(1 + below(28)), static_cast<int>(below(24)),
                      static_cast<int>(below(60)), static_cast<int>(below(60)));
        record.taken = date.data();
        record.place_name = common(places_);
        record.alt_text["x-default"] = sentence(8);
        record.description["x-default"] = sentence(16);
        for (std::size_t i = below(4); i > 0; --i) {
            record.faces.push_back({share(), share(), share(), share(), common(people_)});
            record.persons.push_back(record.faces.back().name);
        }
        for (std::size_t i = below(4); i > 0; --i)
            record.keywords.push_back(common(keywords_));
        return record;
    }

    /// `count` photographs in folders of two hundred below `root`.
    void write(const fs::path& root, std::size_t count) {
        fs::path folder;
        for (std::size_t i = 0; i < count; ++i) {
            if (i % 200 == 0) {
                folder = root / ("Reise " + std::to_string(i / 200 + 1));
                fs::create_directories(folder);
            }
            write_photo(folder / ("IMG_" + std::to_string(i + 1) + ".jpg"), i);
        }
    }

    const std::vector<std::string>& people() const { return people_; }
    const std::vector<std::string>& words() const { return words_; }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
    const std::string& common(const std::vector<std::string>& from) {
        // the n-th with a share of about 1/n: the logarithm of its place is even
        const double place = std::pow(static_cast<double>(from.size()), share());
        return from[std::min(from.size() - 1, static_cast<std::size_t>(place) - 1)];
    }

private:
    double share() { return static_cast<double>(below(10'000)) / 10'000.0; }

    std::string word(std::size_t syllables) {
        constexpr std::string_view consonants = "bdfghklmnprstvwz", vowels = "aeiou";
        std::string word;
        for (std::size_t i = 0; i < syllables; ++i)
            word += {consonants[below(consonants.size())], vowels[below(vowels.size())]};
        if (below(3) == 0)
            word.insert(0, 1, vowels[below(vowels.size())]);
        word[0] = static_cast<char>(word[0] - 'a' + 'A');
        return word;
    }

    std::string sentence(std::size_t length) {
        std::string text;
        for (std::size_t i = 0; i < length; ++i)
            text += (i == 0 ? "" : " ") + common(words_);
        return text + ".";
    }

    std::mt19937_64 random_;
    std::vector<std::string> people_, places_, keywords_, words_;
};

} // namespace tp::testing
