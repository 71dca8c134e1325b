#include "ui/window/language_controller.h"

#include <QActionGroup>
#include <QByteArray>

#include "sentences/language.h"
#include "ui/kit/actions.h"
#include "ui/window/language_setting.h"

namespace mapwright::ui {

LanguageController::LanguageController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  auto* const group = new QActionGroup(this);
  const QString now = languageIn(context.settings);
  int rank = 0;
  const auto offer = [&](const QString& code, const QString& text, const QString& name, const QString& tip) {
    const QByteArray id = "language_" + code.toLatin1();
    QAction* const action = context_.actions.add({.id = id.constData(),
                                                  .text = text,
                                                  .name = name,
                                                  .tip = tip,
                                                  .toggle = true,
                                                  .menu = {MenuGroup::Languages, rank += 10}},
                                                 this, [this, code] { choose(code); });
    group->addAction(action);
    if (code == now) action->setChecked(true);
  };
  const QString of_system = tr("Language: that of the system");
  offer(kLanguageOfSystem, tr("Language of the system"), of_system, of_system);
  for (const sentences::Language& each : sentences::languages())
    offer(each.code, each.name, {}, tr("Language: %1").arg(each.name));
}

void LanguageController::choose(const QString& language) {
  keepLanguage(context_.settings, language);
  delete remark_;
  const QString code = sentences::languageCalled(language).value_or(QString());
  if (code == sentences::spokenLanguage()) return;
  QString name;
  for (const sentences::Language& each : sentences::languages()) {
    if (each.code == code) name = each.name;
  }
  remark_ = new QMessageBox(QMessageBox::Information, tr("Language"),
                            tr("The window is in %1 from the next start of mapwright on.").arg(name),
                            QMessageBox::Ok, &context_.window);
  remark_->setTextFormat(Qt::PlainText);
  remark_->setAttribute(Qt::WA_DeleteOnClose);
  remark_->open();
}

}  // namespace mapwright::ui

#include "moc_language_controller.cpp"
