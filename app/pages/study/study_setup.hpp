// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_finger.hpp"
#include "app/pages/study/study_keeping.hpp"
#include "app/pages/study/study_plan.hpp"
#include "app/pages/study/study_settings.hpp"
#include "app/pages/study/study_teller.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "app/parts/work/latest_task.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// What the researcher chooses before a participant comes: the experiment, where the study lies, whose turn it is and what moves
/// the finger. Nothing is written here.
class StudySetup final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// By title: the program's own, then a file of the person's, where one was opened.
    Q_PROPERTY(QStringList experiments READ experiments NOTIFY changed)
    Q_PROPERTY(int experiment READ experiment_index NOTIFY changed)
    /// The study's folder, as the system writes it.
    Q_PROPERTY(QString folder READ folder NOTIFY changed)
    Q_PROPERTY(int participant READ participant NOTIFY changed)
    /// How far this participant is; empty while that is looked up.
    Q_PROPERTY(QString progress READ progress NOTIFY changed)
    /// Why one cannot begin, with what to do; empty: one can.
    Q_PROPERTY(QString problem READ problem NOTIFY changed)
    /// What may move the finger; the force device is there only where one was found.
    Q_PROPERTY(QStringList hands READ hands NOTIFY changed)
    Q_PROPERTY(int hand READ hand NOTIFY changed)
    /// How strong the pull is, where the experiment asks for more than the person's own limit; empty: it does not.
    Q_PROPERTY(QString force READ force NOTIFY changed)
    Q_PROPERTY(bool forceAllowed READ force_allowed NOTIFY changed)
    Q_PROPERTY(bool showScene READ show_scene NOTIFY changed)
    /// The experiment shows faces, and where they come from.
    Q_PROPERTY(bool needsFaces READ needs_faces NOTIFY changed)
    Q_PROPERTY(QString faces READ faces_words NOTIFY changed)
    /// A folder is being chosen.
    Q_PROPERTY(bool choosing READ choosing NOTIFY changed)
    Q_PROPERTY(tp::FolderChooser* chooser READ chooser CONSTANT)
public:
    /// All must outlive it.
    StudySetup(const StudySettings& settings, StudyFinger& finger, StudyKeeping& keeping, StudyTeller& teller,
               Narrator& narrator);

    QStringList experiments() const;
    int experiment_index() const { return static_cast<int>(chosen_); }
    QString folder() const;
    std::filesystem::path study_folder() const;
    int participant() const { return participant_; }
    QString progress() const;
    QString problem() const;
    QStringList hands() const;
    int hand() const { return uses_device() ? 0 : static_cast<int>(hands().size()) - 1; }
    QString force() const;
    bool force_allowed() const { return force_allowed_; }
    bool show_scene() const { return show_scene_; }
    bool needs_faces() const;
    QString faces_words() const;
    bool choosing() const { return choosing_ != Choosing::nothing; }
    FolderChooser* chooser() { return &chooser_; }

    Q_INVOKABLE void choose(int index);
    /// An experiment's file.
    Q_INVOKABLE void openFile(const QUrl& file);
    Q_INVOKABLE void chooseFolder() { begin_choosing(Choosing::study); }
    Q_INVOKABLE void chooseFaces() { begin_choosing(Choosing::faces); }
    Q_INVOKABLE void setParticipant(int number);
    /// As it was typed; what is no number changes nothing and is said.
    Q_INVOKABLE void typeParticipant(const QString& number);
    Q_INVOKABLE void chooseHand(int index);
    /// The researcher consents to a pull as strong as the experiment asks for and the device gives. Holds for this experiment until
    /// the page is left.
    Q_INVOKABLE void setForceAllowed(bool allowed);
    /// For the researcher who tries it out; nothing is kept then. It is off whenever one comes to the page or a sitting has ended.
    Q_INVOKABLE void setShowScene(bool on);

    /// Comes to the page, or back from a sitting: looks what is there.
    void enter();
    void leave();
    /// Ends choosing a folder; false where none is being chosen.
    bool cancel();
    /// What is set up; nothing while there is a problem.
    std::optional<StudyPlan> plan() const;
    /// Tells where one is and what can be done.
    void tell_where();

signals:
    void changed();

private:
    enum class Choosing { nothing, study, faces };

    const Experiment& now() const { return experiments_[chosen_]; }
    /// The strongest pull of the experiment, where it is above the person's own limit, N.
    std::optional<double> stronger_pull_n() const;
    bool uses_device() const { return wants_device_ && !finger_.found().isEmpty(); }
    void add(Experiment experiment);
    void look(bool offer_next);
    void begin_choosing(Choosing what);
    void take_folder(const QString& folder);
    void read_faces();

    const StudySettings& settings_;
    StudyFinger& finger_;
    StudyKeeping& keeping_;
    StudyTeller& teller_;
    FolderChooser chooser_;
    Choosing choosing_ = Choosing::nothing;
    std::vector<Experiment> experiments_;
    std::size_t own_ = 0; ///< so many are the program's
    std::size_t chosen_ = 0;
    std::filesystem::path folder_; ///< chosen by a person; empty: the usual one of the experiment
    int participant_ = 1;
    std::optional<StudyKeeping::Known> known_; ///< of this folder and participant
    std::uint64_t looked_ = 0;
    bool wants_device_ = true;
    bool force_allowed_ = false;
    bool show_scene_ = false;
    std::filesystem::path faces_folder_;
    std::shared_ptr<const StudyFaces> faces_;
    QString faces_problem_;
    LatestTask reading_; ///< last: its work ends first
};

} // namespace tp
