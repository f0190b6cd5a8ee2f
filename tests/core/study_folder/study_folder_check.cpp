// SPDX-License-Identifier: Apache-2.0
#include "study_folder_check.hpp"

#include "core/study_folder/path_file.hpp"
#include "core/study_folder/study_terms.hpp"

namespace tp::test {
namespace {

std::string complaint_about_sentence(const std::string& text) {
    return text.size() > 10 && text.ends_with('.') && text.find('\n') == std::string::npos
               ? ""
               : "no sentence: " + text;
}

std::string complaint_about_read(const Result<std::vector<FingerSample>>& path) {
    if (!path)
        return complaint_about_sentence(path.error());
    if (!is_path(*path))
        return "no path";
    const auto again = read_path_bytes(path_bytes(*path)); // in the digits that are written
    if (!again)
        return "refused when it was written: " + again.error();
    if (again->size() != path->size() || path_bytes(*again) != path_bytes(*path))
        return "another one when it was written";
    return {};
}

} // namespace

std::string complaint_about_path(std::string_view gzip) {
    return complaint_about_read(read_path_bytes(gzip));
}

std::string complaint_about_path_text(std::string_view csv) {
    return complaint_about_read(read_path_text(csv));
}

std::string complaint_about_terms(std::string_view text) {
    if (const auto terms = read_terms(text); !terms) {
        if (std::string complaint = complaint_about_sentence(terms.error()); !complaint.empty())
            return complaint;
    } else {
        const auto again = read_terms(terms_text(*terms));
        if (!again || *again != *terms)
            return "other terms when they were written";
    }
    const auto sittings = read_sittings(text);
    if (!sittings)
        return complaint_about_sentence(sittings.error());
    const std::string written = sittings_text(*sittings);
    const auto again = read_sittings(written);
    if (!again)
        return "refused when they were written: " + again.error();
    if (sittings_text(*again) != written)
        return "others when they were written";
    return {};
}

} // namespace tp::test
