// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace tp {

// What follows `touchphoto-lab album`; each takes the words after its name and returns an ExitCode.
int album_check(const QStringList& words);
int album_export(const QStringList& words);
int album_import(const QStringList& words);
int album_list(const QStringList& words);
int album_person(const QStringList& words);
int album_rebuild(const QStringList& words);
int album_scan(const QStringList& words);
int album_search(const QStringList& words);
int album_show(const QStringList& words);
int album_tag(const QStringList& words);
int album_trash(const QStringList& words);

} // namespace tp
