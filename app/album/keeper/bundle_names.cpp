// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/bundle_names.hpp"

#include "app/album/keeper/path_text.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"

#include <QString>

#if !defined(_WIN32)
#include <locale.h> // NOLINT(modernize-deprecated-headers): uselocale is in no other
#endif
#if defined(__APPLE__)
#include <xlocale.h>
#endif

namespace tp {

namespace fs = std::filesystem;

std::string name_in_bundle(const fs::path& path) {
    const QString text = path_text(path);
    if (!text.contains(QLatin1Char('\\')) && text.normalized(QString::NormalizationForm_C) == text)
        return text.toStdString();
    return percent_encoded(path).toStdString();
}

Result<fs::path> path_in_bundle(const std::string& name) {
    const QString text = QString::fromStdString(name);
    const bool encoded = is_percent_encoded(text);
    const fs::path path = encoded ? percent_decoded(text) : path_named(name);
    const bool told_as_ours = encoded ? percent_encoded(path) == text : name.find('\\') == std::string::npos;
    if (!told_as_ours || !stays_below(path))
        return Error{"it holds " + quoted_readable(name) + ", which would lie outside the album."};
    return path;
}

#if defined(_WIN32)
Utf8Names::Utf8Names() = default; // names are UTF-16 there
Utf8Names::~Utf8Names() = default;
#else
Utf8Names::Utf8Names() {
    for (const char* name : {"C.UTF-8", "en_US.UTF-8", "UTF-8"})
        if (made_ == nullptr)
            made_ = newlocale(LC_CTYPE_MASK, name, nullptr);
    if (made_ != nullptr)
        before_ = uselocale(static_cast<locale_t>(made_));
}

Utf8Names::~Utf8Names() {
    if (made_ == nullptr)
        return;
    uselocale(static_cast<locale_t>(before_));
    freelocale(static_cast<locale_t>(made_));
}
#endif

} // namespace tp
