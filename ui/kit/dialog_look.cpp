#include "ui/kit/dialog_look.h"

#include <QProgressBar>
#include <QPushButton>

namespace mapwright::ui {

void giveRoles(QPushButton& main, std::initializer_list<QPushButton*> others) {
  main.setObjectName(QStringLiteral("primary"));
  main.setDefault(true);
  for (QPushButton* const button : others) {
    button->setObjectName(QStringLiteral("secondary"));
    button->setAutoDefault(false);
  }
}

void giveCarefulRoles(QPushButton& main, QPushButton& safe) {
  giveRoles(main, {&safe});
  letEnterPress(main, false);
  safe.setDefault(true);
  safe.setFocus();
}

void letEnterPress(QPushButton& button, bool lets) {
  button.setAutoDefault(lets);
  button.setDefault(lets);
}

void makeLine(QProgressBar& progress) {
  progress.setRange(0, 1000);
  progress.setTextVisible(false);
  progress.setFixedHeight(4);
  QSizePolicy keeps = progress.sizePolicy();
  keeps.setRetainSizeWhenHidden(true);
  progress.setSizePolicy(keeps);
  progress.hide();
}

}  // namespace mapwright::ui
