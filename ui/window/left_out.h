// Takes out of a text what people do not want to pass on: addresses, names, home folders, secrets.
#pragma once

#include <QString>
#include <QStringList>

namespace mapwright::ui {

/// What is known of the people, computers and robots around.
struct Privacy {
  /// For each robot what it is called: hosts, names, serial numbers.
  QList<QStringList> robots = {};
  QString home = {}, user = {}, computer = {};
};
/// Of this computer; without robots.
Privacy privacyHere();

/// The same host is the same robot-N everywhere in the text: those of `privacy` first, then others in the
/// order in which they stand there. Of an address only its kind stays.
QString withoutPrivate(const QString& text, const Privacy& privacy);

}  // namespace mapwright::ui
