// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QString>

#include <string>

namespace tp {

/// The language in which a person describes and speaks: what was chosen, else the system's; BCP 47.
QString own_language(const Preferences& preferences);

/// The language tag under which a photograph's descriptions are read and written for somebody of that language (BCP
/// 47): the language itself, one of its variants ("en-GB" for "en"), what is for everybody ("x-default"), else the
/// language, under which there is nothing yet.
std::string described_in(const PhotoRecord& record, const QString& language);

/// The text under that tag; empty where there is none.
QString text_in(const LanguageTexts& texts, const std::string& tag);

} // namespace tp
