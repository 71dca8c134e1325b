#include "ui/shell/unsaved_question.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace mapwright::ui {
namespace {

struct UnsavedQuestionText {
  Q_DECLARE_TR_FUNCTIONS(UnsavedQuestion)
};

}  // namespace

QMessageBox* askToLeave(QObject* asker, QWidget* window, const QString& title, const QString& sentence,
                        bool may_keep, std::function<void(Leaving)> answered) {
  auto* const box = new QMessageBox(QMessageBox::Question, title, sentence,
                                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window);
  box->setTextFormat(Qt::PlainText);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setDefaultButton(QMessageBox::Save);
  QPushButton* keep = nullptr;
  if (may_keep) {
    keep = box->addButton(UnsavedQuestionText::tr("Keep as draft"), QMessageBox::ActionRole);
    keep->setObjectName(QStringLiteral("keepDraft"));
    keep->setToolTip(UnsavedQuestionText::tr("They will be offered when you open this map again"));
  }
  QObject::connect(box, &QMessageBox::finished, asker, [box, keep, answered = std::move(answered)] {
    QAbstractButton* const clicked = box->clickedButton();
    if (clicked && clicked == keep) return answered(Leaving::Keep);
    const auto standard = clicked ? box->standardButton(clicked) : QMessageBox::Cancel;
    answered(standard == QMessageBox::Save      ? Leaving::Save
             : standard == QMessageBox::Discard ? Leaving::Discard
                                                : Leaving::Stay);
  });
  box->open();
  return box;
}

QString draftTimeText(const QDateTime& made, const QDateTime& now) {
  const QLocale c = QLocale::c();
  return made.date() == now.date()
             ? UnsavedQuestionText::tr("today %1").arg(c.toString(made, QStringLiteral("HH:mm:ss")))
             : c.toString(made, UnsavedQuestionText::tr("d MMMM yyyy HH:mm"));
}

}  // namespace mapwright::ui
