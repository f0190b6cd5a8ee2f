// SPDX-License-Identifier: Apache-2.0
#include "name_language_check.hpp"

#include "app/album/keeper/name_languages.hpp"

namespace tp::test {

std::string complaint_about_name_language(std::string_view bytes) {
    const auto name = parse_name_language(bytes);
    if (!name)
        return name.error().ends_with('.') ? std::string{} : "refused without a sentence";
    if (name->person.empty())
        return "nobody's name";
    for (const char each : name->language)
        if (static_cast<unsigned char>(each) <= ' ' || static_cast<unsigned char>(each) > '~')
            return "a tag that is none: " + name->language;
    if (name->language.empty() || name->language.size() > 35)
        return "a tag of " + std::to_string(name->language.size()) + " characters";
    const auto again = parse_name_language(name_language_text(*name));
    return again && *again == *name ? std::string{} : "written and read it is another";
}

} // namespace tp::test
