// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_archive.hpp"

#include "app/pages/lab/lab_replay.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"

#include <string>

namespace tp {

LabArchive::LabArchive(const std::filesystem::path& folder, LabActivity& activity, LabRun& run,
                       const LabMeasurements& measurements, LabTeller& teller)
    : files_(folder), activity_(activity), run_(run), measurements_(measurements), teller_(teller) {}

/// False, and said, where there can be none.
bool LabArchive::make_folder() {
    const std::string reason = files_.make_folder();
    if (!reason.empty())
        teller_.say(tr("The folder %1 cannot be created: %2").arg(folder(), in_persons_language(reason)));
    return reason.empty();
}

void LabArchive::toggleRecording() {
    const bool recording = activity_.recording();
    activity_.stop();
    if (recording || !make_folder())
        return;
    const auto file = files_.new_file(".touch");
    const std::string reason = file ? replace_file(setup_file(*file), run_.setup()) : file.error();
    if (!reason.empty())
        return teller_.say(tr("The recording cannot be started: %1").arg(in_persons_language(reason)));
    recorded_ = *file;
    run_.record(recorded_);
}

QString LabArchive::finish(bool whole) {
    emit changed();
    if (!whole)
        return tr("The recording is not whole, because the disk is full or this computer was too busy.");
    return tr("Recorded in %1; the parameters lie beside it.").arg(LabFiles::path_words(recorded_));
}

void LabArchive::writeTable() {
    const LabTrace& trace = measurements_.trace();
    if (trace.points().empty())
        return teller_.say(tr("There is nothing to save yet. Start the servo first."));
    if (!make_folder())
        return;
    const auto table = files_.new_file(".csv");
    std::string reason = table ? replace_file(*table, trace.csv()) : table.error();
    if (reason.empty())
        reason = replace_file(setup_file(*table), run_.setup());
    if (!reason.empty())
        return teller_.say(tr("The table cannot be written: %1").arg(in_persons_language(reason)));
    teller_.say(tr("%n row(s) are in %1; the parameters lie beside them.", nullptr,
                   static_cast<int>(trace.points().size()))
                    .arg(LabFiles::path_words(*table)));
}

} // namespace tp
