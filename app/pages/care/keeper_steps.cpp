// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/keeper_steps.hpp"

#include "audio/sentences/sentences.hpp"

#include <QMetaObject>

#include <exception>
#include <string>
#include <utility>

namespace tp {

KeeperSteps::KeeperSteps(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

KeeperSteps::~KeeperSteps() { pool_.waitForDone(); }

void KeeperSteps::begin(AlbumKeeper& keeper, Step step, Then then) {
    ++waiting_;
    pool_.start([this, &keeper, step = std::move(step), then = std::move(then)] {
        std::string problem;
        try {
            problem = step(keeper);
        } catch (const std::exception& fault) { // out of memory, mostly
            problem = std::string("This could not be done, because the computer reports: ") + fault.what();
        }
        QMetaObject::invokeMethod(
            this,
            [this, then, problem = in_persons_language(problem),
             undo = in_persons_language(keeper.history().next_undo()),
             redo = in_persons_language(keeper.history().next_redo())] {
                --waiting_;
                next_undo_ = undo;
                next_redo_ = redo;
                then(problem);
                emit changed();
            },
            Qt::QueuedConnection);
    });
    emit changed();
}

void KeeperSteps::run(AlbumKeeper& keeper, Step step, Then then) {
    last_ = &keeper;
    begin(keeper, std::move(step), std::move(then));
}

void KeeperSteps::use(AlbumKeeper& keeper) {
    if (last_ != &keeper)
        run(
            keeper, [](AlbumKeeper&) { return std::string{}; }, [](const QString&) {});
}

void KeeperSteps::step_back(Step step, Then then) {
    ++stepping_back_;
    begin(*last_, std::move(step), [this, then = std::move(then)](const QString& problem) {
        --stepping_back_;
        then(problem);
    });
}

void KeeperSteps::undo(Then then) {
    if (last_ == nullptr)
        then(tr("There is nothing to undo."));
    else
        step_back([](AlbumKeeper& keeper) { return keeper.history().undo(); }, std::move(then));
}

void KeeperSteps::redo(Then then) {
    if (last_ == nullptr)
        then(tr("There is nothing to redo."));
    else
        step_back([](AlbumKeeper& keeper) { return keeper.history().redo(); }, std::move(then));
}

} // namespace tp
