// SPDX-License-Identifier: Apache-2.0
// A study with two people in one process, begun or gone on with. Says BEGUN as a trial begins, TRY before it is kept and ACK after it on stdout, so that
// whoever kills it knows what was acknowledged; SAID where it was refused, which is tried once more.
//
//     study_worker FOLDER
#include "worked_study.hpp"

#include <cstdlib>
#include <string>
#include <unistd.h>

using namespace tp;
using namespace tp::test;

namespace {

void tell(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0)
        std::_Exit(3);
}

bool does(StudyWriter& writer, int participant, const NextTrial& next) {
    const TrialRecord record = worked_record(next, participant);
    const std::string trial = std::to_string(participant) + " " + std::to_string(record.trial);
    writer.begins(participant);
    tell("BEGUN " + trial);
    for (int tries = 0; tries < 2; ++tries) {
        tell("TRY " + trial);
        const std::string problem = writer.keep(record, worked_path(record));
        if (problem.empty()) {
            tell("ACK " + trial);
            return true;
        }
        tell("SAID " + problem);
    }
    return false;
}

} // namespace

int main(int, char** words) {
    const auto writer = StudyWriter::open(words[1], worked_experiment(), worked_terms, worked_mouse);
    if (!writer) {
        tell("SAID " + writer.error());
        return 1;
    }
    for (const std::string& remark : (*writer)->remarks())
        tell("REMARK " + remark);
    // One trial each in turn; the second half with another machine.
    for (bool more = true; more;) {
        more = false;
        for (int participant = 1; participant <= worked_participants; ++participant)
            if (const auto next = (*writer)->next(participant)) {
                (*writer)->use(next->number <= 3 ? worked_mouse : worked_pad);
                if (!does(**writer, participant, *next))
                    return 1;
                more = true;
            }
    }
    tell("END");
}
