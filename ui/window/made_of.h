// What the program is made of: its version and commit, and the libraries with their licences
// (docs/dependencies.md).
#pragma once

#include <QJsonObject>
#include <QList>
#include <QString>

namespace mapwright::ui {

struct Library {
  QString name;     // as in docs/dependencies.md
  QString version;  // that was compiled against; empty = unknown
  QString licence;
};
/// As docs/dependencies.md lists them: a test compares the two.
QList<Library> libraries();

/// The commit that was built, 40 digits; empty where the sources came without Git.
QString builtCommit();
QString compiledQt();
QString runningQt();

/// What --version --json prints (docs/json.md, "--version").
QJsonObject versionJson();
/// The same as lines, for people to paste.
QString versionText();

}  // namespace mapwright::ui
