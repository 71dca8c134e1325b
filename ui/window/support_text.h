// What people send along when they ask for help: versions, system, robot, numbers, problems.
#pragma once

#include <QString>
#include <QStringList>

#include "ui/window/left_out.h"

namespace mapwright::ui {

struct Support {
  QString diagnostics;        // the tables of the dialog
  QStringList robot = {};     // lines about what is open; empty = nothing
  QStringList problems = {};  // oldest first
};

/// Lines about this computer: system, processor, Qt's platform, screens.
QStringList systemLines();
/// All of it, without what `privacy` says and without addresses and secrets. Of the problems the last twenty.
QString supportText(const Support& support, const QStringList& system, const Privacy& privacy);
/// What is left out and what is not, for people.
QString leftOutSentence();

}  // namespace mapwright::ui
