// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/album_check.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/trash.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "app/photo/seen/seen_photo.hpp"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// Text of any bytes as JSON has it; what is not UTF-8 becomes U+FFFD.
QString json_text(const std::string& text);
QJsonArray json_texts(const std::vector<std::string>& texts);

QJsonObject to_json(const Tag& tag);
QJsonObject to_json(const std::filesystem::path& photo, const PhotoRecord& record);
QJsonObject to_json(const SeenPhoto& seen);
QJsonObject to_json(const ImportedPhoto& photo);
QJsonObject to_json(const Finding& finding);
QJsonObject to_json(const TrashEntry& entry);

} // namespace tp
