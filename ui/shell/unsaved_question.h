// What is asked before unsaved changes are left behind, and how their drafts are called. GUI thread.
#pragma once

#include <functional>

#include <QString>

class QDateTime;
class QMessageBox;
class QObject;
class QWidget;

namespace mapwright::ui {

enum class Leaving { Save, Keep, Discard, Stay };

/// Stays open until it is answered, and deletes itself then. `may_keep`: a draft of them can be kept. Without
/// `asker` nobody hears the answer.
QMessageBox* askToLeave(QObject* asker, QWidget* window, const QString& title, const QString& sentence,
                        bool may_keep, std::function<void(Leaving)> answered);

/// "today 19:20:05", "3 May 2026 19:20".
QString draftTimeText(const QDateTime& made, const QDateTime& now);

}  // namespace mapwright::ui
