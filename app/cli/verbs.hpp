// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace tp {

/// The verbs of touchphoto-lab; each takes the words after its name and returns an ExitCode.
int aim_verb(const QStringList& words);
int study_verb(const QStringList& words);
int album_verb(const QStringList& words);
int bench_verb(const QStringList& words);
int devices_verb(const QStringList& words);
int expressions_verb(const QStringList& words);
int faces_verb(const QStringList& words);
int field_verb(const QStringList& words);
int friction_verb(const QStringList& words);
int bench_faces_verb(const QStringList& words);
int bench_touch_verb(const QStringList& words);
int correction_verb(const QStringList& words);
int force_verb(const QStringList& words);
int models_verb(const QStringList& words);
int scene_verb(const QStringList& words);
int servo_verb(const QStringList& words);
int stability_verb(const QStringList& words);
int tactile_verb(const QStringList& words);
int trace_verb(const QStringList& words);

/// Runs the verb that the words begin with, or shows the list of verbs.
int run_lab(const QStringList& words);

} // namespace tp
