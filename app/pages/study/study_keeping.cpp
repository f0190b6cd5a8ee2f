// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_keeping.hpp"

#include "audio/sentences/sentences.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/files/durable_file.hpp"
#include "core/study_folder/running_trial.hpp"

#include <QMetaObject>

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace tp {

namespace {

QString in_sentences(const std::vector<std::string>& remarks) {
    QString text;
    for (const std::string& remark : remarks)
        text += (text.isEmpty() ? "" : " ") + in_persons_language(remark);
    return text;
}

} // namespace

void StudyKeeping::work(std::function<std::function<void()>()> step) {
    pool_.start([this, step = std::move(step)] {
        if (auto answer = step())
            QMetaObject::invokeMethod(this, std::move(answer));
    });
}

StudyKeeping::Known StudyKeeping::known_of(const Result<StudyFolder>& study,
                                           const std::filesystem::path& folder, const Experiment& experiment,
                                           int participant) {
    Known known;
    if (!study) {
        known.problem = in_persons_language(study.error());
        return known;
    }
    if (experiment_text(study->experiment) != experiment_text(experiment))
        known.problem =
            tr("In this folder lies a study of another experiment, or of another version of it. Choose "
               "another folder.");
    else if (study->terms && study->terms->simulated)
        known.problem = tr("In this folder lies a study with simulated participants. Choose another folder.");
    if (study->terms)
        known.seed = study->terms->seed;
    for (const TrialRecord& record : study->records) {
        known.next_participant = std::max(known.next_participant, record.participant + 1);
        if (record.participant == participant)
            known.records.push_back(record);
    }
    std::vector<std::string> remarks = study->remarks;
    if (std::string lost = lost_trial(folder, study->records); !lost.empty())
        remarks.push_back(std::move(lost));
    known.notice = in_sentences(remarks);
    return known;
}

void StudyKeeping::look(const std::filesystem::path& folder, const Experiment& experiment, int participant,
                        Then then) {
    work([folder, experiment, participant, then = std::move(then)]() -> std::function<void()> {
        Known known;
        try {
            if (!is_gone(folder / study_protocol_file))
                known = known_of(read_study(folder), folder, experiment, participant);
        } catch (const std::exception& fault) { // out of memory, mostly
            known.problem = tr("The study's folder cannot be read, because the computer reports: %1")
                                .arg(QString::fromUtf8(fault.what()));
        }
        return [then, known] { then(known); };
    });
}

void StudyKeeping::open(Sitting sitting, Then then) {
    work([this, sitting = std::move(sitting), then = std::move(then)]() -> std::function<void()> {
        Known known;
        try {
            writer_.reset();
            StudyTerms terms{sitting.seed, false};
            if (!is_gone(sitting.folder / study_protocol_file))
                if (const auto there = read_study(sitting.folder); there && there->terms)
                    terms.seed = there->terms->seed;
            auto writer = StudyWriter::open(sitting.folder, sitting.experiment, terms, sitting.machine);
            if (writer) {
                writer_ = std::move(*writer);
                known.seed = writer_->terms().seed;
                known.records = writer_->records_of(sitting.participant);
                known.notice = in_sentences(writer_->remarks());
            } else {
                known.problem = in_persons_language(writer.error());
            }
        } catch (const std::exception& fault) {
            known.problem = tr("The study's folder cannot be opened, because the computer reports: %1")
                                .arg(QString::fromUtf8(fault.what()));
        }
        return [then, known] { then(known); };
    });
}

void StudyKeeping::begins(int participant) {
    work([this, participant]() -> std::function<void()> {
        if (writer_ != nullptr)
            writer_->begins(participant);
        return {};
    });
}

void StudyKeeping::keep(TrialRecord record, std::vector<FingerSample> path,
                        std::function<void(const QString& problem)> then) {
    work([this, record = std::move(record), path = std::move(path),
          then = std::move(then)]() -> std::function<void()> {
        QString problem;
        try {
            problem = writer_ == nullptr ? tr("The study's folder is not open.")
                                         : in_persons_language(writer_->keep(record, path));
        } catch (const std::exception& fault) {
            problem = tr("The trial cannot be kept, because the computer reports: %1")
                          .arg(QString::fromUtf8(fault.what()));
        }
        return [then, problem] { then(problem); };
    });
}

void StudyKeeping::close() {
    work([this]() -> std::function<void()> {
        writer_.reset();
        return {};
    });
}

} // namespace tp
